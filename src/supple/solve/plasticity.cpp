#include "supple/solve/plasticity.hpp"

#include <fmt/format.h>

#include <cmath>

#include "supple/core/error.hpp"
#include "supple/geometry/facet.hpp"
#include "supple/geometry/hinge.hpp"

namespace supple {

namespace {

/// Preferred length or area after the time dt, while the present one stays x.
double flowed(double rest, double x, double yield, double dt_per_time) {
  if (!(std::abs(x - rest) > yield * rest) || !(x > 0)) return rest;
  const double edge = x > rest ? 1 + yield : 1 - yield, end = x / edge;
  return end + (rest - end) * std::exp(-edge * dt_per_time);
}

double area_of(const State<2>& s, int begin, int end) {
  double twice = 0;  // from the first site, so that a body far from the origin loses no digits
  for (int i = begin + 1; i + 1 < end; ++i)
    twice += cross(s.position[i] - s.position[begin], s.position[i + 1] - s.position[begin]);
  return 0.5 * twice;
}

void flow_angles(System<2>& system, int b, double yield, double dt_per_time) {
  const Topology<2>& t = system.topology;
  const int begin = t.hinge_begin[b], end = t.hinge_begin[b + 1];
  static thread_local std::vector<double> delta;
  delta.clear();
  double mean = 0;
  for (int h = begin; h < end; ++h) {
    const auto& x = system.state.position;
    const auto [before, at, after] = t.hinge[h];
    delta.push_back(hinge_angle<double>({x[before], x[at], x[after]}) - system.shape.rest_hinge[h]);
    mean += delta.back() / (end - begin);
  }
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
  for (const double yield : {law.length_yield, law.area_yield})
    if (!(yield >= 0 && (yield < 1 || std::isinf(yield))))
      throw input_error(fmt::format("a yield strain of {}", yield), "nothing can be compressed that far",
                        "give 0 or more, below 1, or infinity where nothing flows");
  if (!(law.angle_yield >= 0))
    throw input_error(fmt::format("a yield angle of {}", law.angle_yield),
                      "it must be 0 or more, or infinity where nothing flows");
}

void advance(System<2>& system, const PlasticLaw& law, double dt) {
  Shape& shape = system.shape;
  if (shape.empty()) return;
  const Topology<2>& t = system.topology;
  const double dt_per_time = dt / law.time;
  for (int b = 0; b < static_cast<int>(shape.stiffness.size()); ++b) {
    const ShapeStiffness& k = shape.stiffness[b];
    if (k.facet != 0 && std::isfinite(law.length_yield))
      for (int f = t.facet_begin[b]; f < t.facet_begin[b + 1]; ++f) {
        const double length =
            norm(system.state.position[t.facet[f][1]] - system.state.position[t.facet[f][0]]);
        shape.rest_facet[f] = flowed(shape.rest_facet[f], length, law.length_yield, dt_per_time);
      }
    if (k.volume != 0 && std::isfinite(law.area_yield))
      shape.rest_volume[b] = flowed(shape.rest_volume[b], area_of(system.state, t.begin[b], t.begin[b + 1]),
                                    law.area_yield, dt_per_time);
    if (k.hinge != 0 && std::isfinite(law.angle_yield)) flow_angles(system, b, law.angle_yield, dt_per_time);
  }
}

}  // namespace supple
