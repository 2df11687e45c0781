/// A body and a disc that is put anywhere to probe the force of the body.
#pragma once
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "supple/contact/smooth_contacts.hpp"
#include "supple/force/force_field.hpp"
#include "supple/geometry/closest_point.hpp"
#include "supple/geometry/inside.hpp"
#include "supple/model/polygons.hpp"

namespace supple::testing {

/// A body of these vertices and radius, without shape energy.
inline void add_body(System<2>& system, const std::vector<Vec2>& vertices, double radius) {
  const std::vector<double> rest(vertices.size(), 1);
  add_ring(system, vertices, radius, {}, 1, rest, rest);
}

/// A body and a disc that probes it. The energy of a disc has the factor 1, not 1/2 as that of a vertex.
class Probe {
 public:
  Probe(const std::vector<Vec2>& vertices, double sigma, Harmonic law = {1, false})
      : ring_(vertices), field_(SmoothContacts(law)) {
    system_.box.length = {100, 100};
    system_.box.periodic = {false, false};
    for (Vec2& x : ring_) x += Vec2{50, 50};
    add_body(system_, ring_, 0.5 * sigma);
    add_disc_body(system_, {50, 50}, 0.5 * sigma);
  }
  /// Force on the probe at p.
  Vec2 force(const Vec2& p) {
    system_.state.position.back() = p + Vec2{50, 50};
    field_.evaluate(system_, Detail::energies, out_);
    return out_.force.back();
  }
  double energy(const Vec2& p) {
    force(p);
    return out_.energy.elastic;
  }
  double distance(const Vec2& p) const {
    double least = 1e300;
    for (std::size_t k = 0; k < ring_.size(); ++k)
      least = std::min(
          least, norm(closest_on_segment(p + Vec2{50, 50}, ring_[k], ring_[(k + 1) % ring_.size()]).from));
    return least;
  }
  bool inside(const Vec2& p) const { return is_inside(p + Vec2{50, 50}, ring_); }
  BodyContacts<2>& contacts() { return *field_.bodies(); }
  System<2>& system() { return system_; }

 private:
  std::vector<Vec2> ring_;
  System<2> system_;
  ForceField<2> field_;
  Evaluation<2> out_;
};

inline std::vector<Vec2> regular(int n, double radius, double stretch = 1) {
  std::vector<Vec2> ring;
  for (int k = 0; k < n; ++k)
    ring.push_back({stretch * radius * std::cos(2 * std::numbers::pi * k / n + 0.1),
                    radius * std::sin(2 * std::numbers::pi * k / n + 0.1)});
  return ring;
}

// Rings, counter-clockwise, with sides of 2 to 4 unless a comment says otherwise.
inline const std::vector<Vec2> square{{0, 0}, {3, 0}, {3, 3}, {0, 3}};
inline const std::vector<Vec2> ell{{0, 0},   {4, 0}, {4, 4},
                                   {2.3, 4}, {2, 2}, {0, 2}};  // one concave corner, about a right angle
inline const std::vector<Vec2> notch{{0, 0}, {6, 0},   {6, 4}, {3.7, 4},
                                     {3, 1}, {2.3, 4}, {0, 4}};  // a notch of 26 degrees
inline const std::vector<Vec2> ledge{
    {0, 0},     {6, 0},     {6, 4},  {3, 4},
    {2.9, 3.4}, {2.6, 4.2}, {0, 4.2}};  // edges shorter than sigma = 1 at a notch of 29 degrees
inline const std::vector<Vec2> spike{{0, 0}, {4, 0},   {4, 2}, {2.2, 2},
                                     {2, 5}, {1.8, 2}, {0, 2}};  // a spike thinner than sigma = 1

}  // namespace supple::testing
