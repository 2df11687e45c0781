/// Whether a system can be computed with at all.
#pragma once
#include <cmath>
#include <string>

#include "supple/model/system.hpp"

namespace supple {

/// Bounds of size between which the product of four numbers neither overflows nor becomes 0.
inline constexpr double least_number = 1e-60, most_number = 1e60;
/// Whether x is 0 or its size is within these bounds.
inline bool is_computable(double x) {
  return x == 0 || (std::abs(x) >= least_number && std::abs(x) <= most_number);
}

/// Throws an input error that begins with `what` ("the state to start from") unless
/// * there is a site, and radii, masses, lengths of the cell, preferred areas and lengths (3D: volumes and
///   areas) are positive;
/// * every number is_computable(), and none is 0 that may not be;
/// * no site lies further out than 1e9 times the smallest radius, nor does the cell reach further: positions,
///   which have 16 digits, would not resolve contacts;
/// * the largest radius is at most 1e7 times the smallest one;
/// * the kinetic energy is finite.
/// Whatever makes or reads a sample calls this, so that loops over sites, grids and steps may rely on it.
template <int Dim>
void require_sane(const System<Dim>& system, const std::string& what);

}  // namespace supple
