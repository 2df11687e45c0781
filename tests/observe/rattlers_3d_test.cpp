#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "supple/build/surfaces.hpp"
#include "supple/contact/rough_contacts.hpp"
#include "supple/model/rigid.hpp"
#include "supple/observe/rattlers.hpp"

namespace supple {
namespace {

/// A sphere of radius 1 in the middle of a large cell, and others that overlap it in these directions and
/// stay where they are.
System<3> cage(const std::vector<Vec3>& directions) {
  System<3> s;
  s.box.length = {20, 20, 20};
  add_sphere_body(s, {10, 10, 10}, 1);
  for (const Vec3& d : directions) {
    add_sphere_body(s, Vec3{10, 10, 10} + (1.9 / norm(d)) * d, 1);
    s.state.mobility.back() = Mobility::fixed;
  }
  return s;
}

bool middle_rattles(System<3> s) {
  NeighborList<3>().update(s);
  RoughContacts<3> contacts{Harmonic{1, true}};
  const auto touching = site_contacts(s, contacts.records(s), contacts.laws());
  return find_rattlers(s, touching)[0] == 1;
}

TEST(RattlersIn3D, ASphereIsHeldFromAllSidesOrByTwoOpposite) {
  EXPECT_TRUE(middle_rattles(cage({})));
  EXPECT_TRUE(middle_rattles(cage({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}))) << "from one side";
  EXPECT_FALSE(middle_rattles(cage({{1, 0, 0}, {-1, 0, 0}}))) << "squeezed by two";
  EXPECT_FALSE(middle_rattles(cage({{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}})));
  EXPECT_TRUE(middle_rattles(cage({{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}}))) << "less one";
}

/// Two equal and opposite pushes hold an icosahedron, rigid or not, if they are along one line, and turn it
/// if not.
TEST(RattlersIn3D, ASurfaceIsHeldAgainstTurning) {
  for (const auto& [aligned, rigid] : {std::pair{true, false}, {false, false}, {true, true}, {false, true}}) {
    System<3> s;
    s.box.length = {40, 40, 40};
    add_surface(s, geodesic_icosahedron(12, 100), 1, ShapeSpec{});
    if (rigid) make_rigid(s, 0);
    const std::vector<Vec3> vertex = s.state.position;
    const auto at = [&](double x, double z) {  // of the four vertices farthest along x
      return *std::max_element(vertex.begin(), vertex.end(), [&](const Vec3& a, const Vec3& b) {
        return 2 * x * a[0] + z * a[2] < 2 * x * b[0] + z * b[2];
      });
    };
    for (const double x : {1.0, -1.0}) {
      const Vec3 out{x * 0.9 * (s.state.radius[0] + 1), 0, 0};
      add_sphere_body(s, at(x, aligned ? 1 : x) + out, 1);
      s.state.mobility.back() = Mobility::fixed;
    }
    EXPECT_EQ(middle_rattles(s), !aligned) << rigid;
  }
}

}  // namespace
}  // namespace supple
