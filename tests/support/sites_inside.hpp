/// Sites inside another body, found by comparing every site with every body: the reference for look_at() and
/// contacts.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "supple/geometry/inside.hpp"
#include "supple/model/system.hpp"

namespace supple::testing {

struct SiteInside {
  std::int32_t site, body;
  friend bool operator==(const SiteInside&, const SiteInside&) = default;
};

struct Bounds {
  Vec2 low, high;
};

inline Bounds bounds_of(std::span<const Vec2> points) {
  Bounds bounds{points[0], points[0]};
  for (const Vec2& p : points)
    for (int d = 0; d < 2; ++d) {
      bounds.low[d] = std::min(bounds.low[d], p[d]);
      bounds.high[d] = std::max(bounds.high[d], p[d]);
    }
  return bounds;
}

/// Numbers of cells by which b may be moved along d, each as long as `length`, to overlap a.
struct Cells {
  double first, last;
};

inline Cells overlapping(const Bounds& a, const Bounds& b, int d, double moved, double length,
                         bool periodic) {
  const double low = (a.low[d] - b.high[d] - moved) / length, high = (a.high[d] - b.low[d] - moved) / length;
  if (!periodic) return {low <= 0 && high >= 0 ? 0.0 : 1.0, 0};
  return {std::ceil(low), std::floor(high)};
}

/// visit(shift) for each periodic image of b whose bounds overlap those of a.
template <class Visit>
void for_overlapping_images(const Box<2>& box, const Bounds& a, const Bounds& b, const Visit& visit) {
  const Cells up = overlapping(a, b, gradient, 0, box.length[gradient], box.periodic[gradient]);
  for (double m = up.first; m <= up.last; ++m) {
    const double sheared = m * box.strain * box.length[gradient];
    const Cells along = overlapping(a, b, flow, sheared, box.length[flow], box.periodic[flow]);
    for (double n = along.first; n <= along.last; ++n)
      visit(Vec2{sheared + n * box.length[flow], m * box.length[gradient]});
  }
}

/// Every site that lies inside the polygon of another body, through any periodic image, by body and site;
/// empty in a valid state. Bodies that cross with no vertex of either inside the other are not found.
inline std::vector<SiteInside> find_sites_inside(const System<2>& system) {
  const Topology<2>& topology = system.topology;
  const std::vector<Vec2>& x = system.state.position;
  const int bodies = topology.body_count(system.state.size());
  const auto sites_of = [&](int b) {
    return std::span<const Vec2>(x).subspan(static_cast<std::size_t>(topology.body_begin(b)),
                                            static_cast<std::size_t>(topology.body_size(b)));
  };
  std::vector<Bounds> bounds;
  for (int b = 0; b < bodies; ++b) bounds.push_back(bounds_of(sites_of(b)));

  std::vector<SiteInside> found;
  for (int b = 0; b < bodies; ++b) {
    if (topology.body_size(b) < 3) continue;
    for (int other = 0; other < bodies; ++other) {
      if (other == b) continue;
      for_overlapping_images(system.box, bounds[b], bounds[other], [&](const Vec2& shift) {
        for (std::int32_t i = topology.body_begin(other); i < topology.body_end(other); ++i) {
          const Vec2 p = x[i] + shift;
          bool within = true;
          for (int d = 0; d < 2; ++d)
            within = within && bounds[b].low[d] <= p[d] && p[d] <= bounds[b].high[d];
          if (within && is_inside(p, sites_of(b))) found.push_back({i, b});
        }
      });
    }
  }
  return found;
}

}  // namespace supple::testing
