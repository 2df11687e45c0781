/// A body between two plates: what these bear, and how far it has widened and turned.
#pragma once
#include <span>
#include <vector>

#include "supple/model/evaluation.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// Pushes [force], each at least 0, of the lower and the upper plate on sites, and how many sites touch each.
struct PlateForces {
  double lower = 0, upper = 0;
  int lower_sites = 0, upper_sites = 0;

  int sites() const { return lower_sites + upper_sites; }
  /// Of a site that touches a plate [force]; 0 where none does.
  double mean() const { return sites() > 0 ? (lower + upper) / sites() : 0; }
};

/// Sums the pushes of Evaluation::wall along the last direction; plates have no friction.
template <int Dim>
PlateForces sum_plate_forces(std::span<const SiteForce<Dim>> wall);

/// From where to where a body reaches along a direction, with the discs (spheres) of its sites [length].
struct BodyReach {
  double low, high;
  double length() const { return high - low; }
};
template <int Dim>
BodyReach reach_along(const System<Dim>& system, int body, int direction);

/// How far a cloud of points has turned as a whole [radian], from 0 to pi: the angle of the rotation about
/// the mean that brings `before` nearest to `after`, in least squares [Horn, J. Opt. Soc. Am. A 4, 629
/// (1987)]. 0 for less than two points. Input error where the lists differ in length.
template <int Dim>
double turned_by(std::span<const Vec<Dim>> before, std::span<const Vec<Dim>> after);

}  // namespace supple
