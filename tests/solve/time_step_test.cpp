#include "supple/solve/time_step.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "supple/solve/degrees.hpp"
#include "tests/support/moving_bodies.hpp"

namespace supple {
namespace {

using Rows = std::vector<std::map<int, double>>;

/// |mass-weighted Hessian| of the whole, all parts multiplied out.
Rows absolute_hessian(System<2>& system, ForceField<2>& field) {
  const BodyDegrees<2> degrees(system);
  Evaluation<2> evaluation;
  field.evaluate(system, Detail::forces, evaluation);
  HessianBlocks<2> blocks;
  field.add_hessian(system, blocks);
  const std::vector<double> mass = degrees.masses(system);
  Rows rows(mass.size());
  for (const MatrixEntry& e : degrees.hessian(system, blocks, evaluation.force)) {
    rows[e.row()][e.col()] += e.value();
    if (e.row() != e.col()) rows[e.col()][e.row()] += e.value();
  }
  for (std::size_t a = 0; a < rows.size(); ++a)
    for (auto& [b, value] : rows[a]) value = std::abs(value) / std::sqrt(mass[a] * mass[b]);
  return rows;
}

/// The numbers that a row is connected with, however far.
std::vector<int> connected(const Rows& rows, int row, std::vector<bool>& seen) {
  std::vector<int> found{row};
  seen[row] = true;
  for (std::size_t k = 0; k < found.size(); ++k)
    for (const auto& [b, value] : rows[found[k]])
      if (!seen[b]) seen[b] = true, found.push_back(b);
  return found;
}

/// The largest bound [Collatz 1942] of all parts of a matrix.
double bound_of_parts(const Rows& rows) {
  std::vector<bool> seen(rows.size());
  std::vector<double> x(rows.size(), 1.0), y(rows.size());
  double bound = 0;
  for (int row = 0; row < static_cast<int>(rows.size()); ++row) {
    if (seen[row]) continue;
    const std::vector<int> part = connected(rows, row, seen);
    double least = 1e300;
    for (int iteration = 0; iteration < 30; ++iteration) {
      double ratio = 0, largest = 0;
      for (const int a : part) {
        y[a] = 0;
        for (const auto& [b, value] : rows[a]) y[a] += value * x[b];
        ratio = std::max(ratio, y[a] / x[a]);
        largest = std::max(largest, y[a]);
      }
      least = std::min(least, ratio);
      for (const int a : part) x[a] = y[a] / largest + 1e-3;
    }
    bound = std::max(bound, least);
  }
  return bound;
}

/// 6 k/m and the wall, of the site where this is most: k = 1/sigma^2 of contacts relative to the diameter.
double further_contacts(const System<2>& system, const ForceField<2>& field) {
  double most = 0;
  for (int i = 0; i < system.state.size(); ++i) {
    const double sigma = 2 * system.state.radius[i];
    const double wall = field.walls() ? field.walls()->repulsion.spring(sigma) : 0;
    most = std::max(most, (6 / (sigma * sigma) + wall) / system.state.mass[i]);
  }
  return most;
}

/// Bodies far apart, some of them rigid or held, but for the last one, which touches the first: more than
/// two thousand sites in all.
System<2> mostly_apart() {
  System<2> system = testing::random_polygons({.bodies = 289, .spacing = 9});
  const Topology<2>& t = system.topology;
  const int last = t.body_count(system.state.size()) - 1;
  const Vec2 way = system.state.position[0] - system.state.position[t.begin[last]];
  for (int i = t.begin[last]; i < t.begin[last + 1]; ++i) system.state.position[i] += way + Vec2{1.7, 0.2};
  for (const int b : {3, 100, 288}) make_rigid(system, b);
  for (int i = t.begin[7]; i < t.begin[7] + 4; ++i) system.state.mobility[i] = Mobility::fixed;
  return system;
}

void expect_bound(System<2>& system, ForceField<2>& field, const std::string& what) {
  const double expected =
      std::sqrt(bound_of_parts(absolute_hessian(system, field)) + further_contacts(system, field));
  EXPECT_NEAR(frequency_bound(system, field), expected, 1e-12 * expected) << what;
}

TEST(FrequencyBound, OfBodiesThatDoNotInteractIsTheLargestOfTheirs) {
  const System<2> apart = mostly_apart();
  const Topology<2>& t = apart.topology;
  ASSERT_GT(apart.state.size(), 3000);
  double heavy = 0;
  for (const int light : {-1, 0, 3, 7, 150, 288}) {  // this one moves faster than all others
    System<2> system = apart;
    if (light >= 0)
      for (int i = t.begin[light]; i < t.begin[light + 1]; ++i) system.state.mass[i] /= 100;
    for (int r = 0; r < system.rigid.size(); ++r)
      if (system.rigid.body[r] == light) system.rigid.mass[r] /= 100, system.rigid.inertia[r] /= 100;
    ForceField<2> field = testing::shell_field();
    expect_bound(system, field, "light body " + std::to_string(light));
    if (light < 0) heavy = frequency_bound(system, field);
    else EXPECT_GT(frequency_bound(system, field), 2 * heavy) << light;
  }
}

/// The blocks of a wall join nothing, those of contacts all.
TEST(FrequencyBound, OfBodiesInOneClumpOnWallsIsThatOfTheWhole) {
  System<2> system = testing::random_polygons({.bodies = 225});
  ASSERT_GT(system.state.size(), 2048);
  for (const int b : {10, 200}) make_rigid(system, b);
  ForceField<2> field = testing::shell_field();
  expect_bound(system, field, "periodic");
  system.box.strain = 0;
  system.box.periodic = {false, false};
  WallLaw<2> walls;
  walls.repulsion = {3, false};
  field.set_walls(walls);
  field.invalidate();
  expect_bound(system, field, "walls");
}

}  // namespace
}  // namespace supple
