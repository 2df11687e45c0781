#include "supple/contact/reach.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "supple/geometry/facet.hpp"

namespace supple {

template <int Dim>
std::vector<double> reach_of_sites(const System<Dim>& system, Meeting meeting, double range) {
  std::vector<double> reach = system.state.radius;
  for (double& r : reach) r *= range;
  const auto leave_out_inside = [&] {
    for (int b = 0; b < system.solid.bodies(); ++b)
      if (system.solid.fills(b))
        std::fill(reach.begin() + system.topology.body_begin(b) + system.topology.boundary_size(b),
                  reach.begin() + system.topology.body_end(b), out_of_reach);
  };
  if (meeting == Meeting::sites) {
    leave_out_inside();
    return reach;
  }
  std::vector<double> most(reach.size());
  for (const auto& facet : system.topology.facet) {
    Vec<Dim> x[Dim];
    for (int k = 0; k < Dim; ++k) x[k] = system.state.position[facet[k]];
    const double radius = facet_covering_radius(x);
    for (const std::int32_t site : facet) most[site] = std::max(most[site], radius);
  }
  for (std::size_t i = 0; i < reach.size(); ++i) reach[i] += most[i];
  leave_out_inside();
  return reach;
}

namespace {

/// The largest extent of the body along a periodic axis of the cell. Images one cell along the gradient,
/// however far they are displaced along the flow, are as far away in height as the cell is high; all others
/// are a multiple of its length away.
template <int Dim>
double extent_of_body(const System<Dim>& system, std::int32_t begin, std::int32_t end) {
  const State<Dim>& state = system.state;
  double extent = 0;
  for (int d = 0; d < Dim; ++d) {
    if (!system.box.periodic[d]) continue;
    double low = state.position[begin][d], high = low;
    for (std::int32_t i = begin; i < end; ++i) {
      low = std::min(low, state.position[i][d] - state.radius[i]);
      high = std::max(high, state.position[i][d] + state.radius[i]);
    }
    extent = std::max(extent, high - low);
  }
  return extent;
}

}  // namespace

template <int Dim>
double least_period(const System<Dim>& system, const std::vector<double>& reach) {
  const Topology<Dim>& topology = system.topology;
  const int bodies = topology.body_count(system.state.size());
  double width = 0, largest = 0, second = 0;  // of bodies; reach of the two that reach farthest
  for (int b = 0; b < bodies; ++b) {
    const std::int32_t begin = topology.body_begin(b), end = topology.body_end(b);
    if (begin == end) continue;
    const double own = *std::max_element(reach.begin() + begin, reach.begin() + end);
    second = std::max(second, std::min(own, largest));
    largest = std::max(largest, own);
    width = std::max(width, extent_of_body(system, begin, end));
  }
  return std::max(width, bodies > 1 ? 2 * (largest + second) : 0.0);
}

Error ShortPeriod::error(ErrorKind kind) const {
  const double share = length / least;  // a length would need its unit
  const std::string how_short = share < 0.99
                                    ? fmt::format("is {:.3g} of the least", share)
                                    : fmt::format("is shorter than the least, by {:.2g} of it", 1 - share);
  return Error(
      kind,
      fmt::format("the period of the cell along {} {}: a particle meets itself or a neighbour on two sides",
                  "xyz"[direction], how_short),
      "only the nearest image would count", "take a larger cell, or raise bodies.N or particles.N");
}

template std::vector<double> reach_of_sites(const System<2>&, Meeting, double);
template std::vector<double> reach_of_sites(const System<3>&, Meeting, double);
template double least_period(const System<2>&, const std::vector<double>&);
template double least_period(const System<3>&, const std::vector<double>&);

}  // namespace supple
