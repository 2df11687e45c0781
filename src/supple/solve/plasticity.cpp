#include "supple/solve/plasticity.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "supple/core/error.hpp"
#include "supple/geometry/facet.hpp"
#include "supple/geometry/hinge.hpp"

namespace supple {

namespace {

/// Preferred size after the time dt, while the present one stays x.
double flowed(double rest, double x, double yield, double dt_per_time) {
  if (!(std::abs(x - rest) > yield * rest) || !(x > 0)) return rest;
  const double edge = x > rest ? 1 + yield : 1 - yield, end = x / edge;
  return end + (rest - end) * std::exp(-edge * dt_per_time);
}

/// The present points of a facet or hinge.
template <int Dim, std::size_t Count>
struct Points {
  Vec<Dim> x[Count];
  Points(const System<Dim>& system, const std::array<std::int32_t, Count>& sites,
         const Vec<Dim>& origin = {}) {
    for (std::size_t k = 0; k < Count; ++k) x[k] = system.state.position[sites[k]] - origin;
  }
};

/// What body b encloses, from its first site, so that a body far from the origin loses no digits.
double volume_of(const System<2>& system, int b) {
  const State<2>& s = system.state;
  const int begin = system.topology.begin[b], end = system.topology.begin[b + 1];
  double twice = 0;
  for (int i = begin + 1; i + 1 < end; ++i)
    twice += cross(s.position[i] - s.position[begin], s.position[i + 1] - s.position[begin]);
  return 0.5 * twice;
}
double volume_of(const System<3>& system, int b) {
  const Topology<3>& t = system.topology;
  double sum = 0;
  for (int f = t.facet_begin[b]; f < t.facet_begin[b + 1]; ++f)
    sum += facet_volume<double>(Points(system, t.facet[f], system.state.position[t.begin[b]]).x);
  return sum;
}

template <int Dim>
void flow_angles(System<Dim>& system, int b, double yield, double dt_per_time) {
  const Topology<Dim>& t = system.topology;
  const int begin = t.hinge_begin[b], end = t.hinge_begin[b + 1];
  static thread_local std::vector<double> delta;
  delta.clear();
  double mean = 0;
  for (int h = begin; h < end; ++h) {
    delta.push_back(hinge_angle<double>(Points(system, t.hinge[h]).x) - system.shape.rest_hinge[h]);
    mean += delta.back() / (end - begin);
  }
  if (Dim == 3) mean = 0;
  const double share = -std::expm1(-dt_per_time);
  for (int h = begin; h < end; ++h) {
    const double bent = delta[h - begin] - mean;
    if (std::abs(bent) > yield) system.shape.rest_hinge[h] += share * (bent - std::copysign(yield, bent));
  }
}

}  // namespace

void check(const PlasticLaw& law) {
  if (!(law.time > 0))
    throw input_error(fmt::format("a plastic time of {}", law.time), "it must be positive");
  for (const double yield : {law.facet_yield, law.volume_yield})
    if (!(yield >= 0 && (yield < 1 || std::isinf(yield))))
      throw input_error(fmt::format("a yield strain of {}", yield), "nothing can be compressed that far",
                        "give 0 or more, below 1, or infinity where nothing flows");
  if (!(law.angle_yield >= 0))
    throw input_error(fmt::format("a yield angle of {}", law.angle_yield),
                      "it must be 0 or more, or infinity where nothing flows");
}

template <int Dim>
void advance(System<Dim>& system, const PlasticLaw& law, double dt) {
  Shape& shape = system.shape;
  if (shape.empty()) return;
  const Topology<Dim>& t = system.topology;
  const double dt_per_time = dt / law.time;
  for (int b = 0; b < static_cast<int>(shape.stiffness.size()); ++b) {
    const ShapeStiffness& k = shape.stiffness[b];
    if (k.facet != 0 && std::isfinite(law.facet_yield))
      for (int f = t.facet_begin[b]; f < t.facet_begin[b + 1]; ++f) {
        const double size = facet_measure<double>(Points(system, t.facet[f]).x);
        shape.rest_facet[f] = flowed(shape.rest_facet[f], size, law.facet_yield, dt_per_time);
      }
    if (k.volume != 0 && std::isfinite(law.volume_yield))
      shape.rest_volume[b] =
          flowed(shape.rest_volume[b], volume_of(system, b), law.volume_yield, dt_per_time);
    if (k.hinge != 0 && std::isfinite(law.angle_yield)) flow_angles(system, b, law.angle_yield, dt_per_time);
  }
}

template void advance(System<2>&, const PlasticLaw&, double);
template void advance(System<3>&, const PlasticLaw&, double);

}  // namespace supple
