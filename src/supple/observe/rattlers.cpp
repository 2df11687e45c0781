#include "supple/observe/rattlers.hpp"

#include <algorithm>

#include "supple/geometry/nearest_in_hull.hpp"
#include "supple/model/bodies.hpp"
#include "supple/model/body_links.hpp"

namespace supple {

namespace {

/// Numbers of a force and its torque.
template <int Dim>
inline constexpr int wrench_size = Dim == 2 ? 3 : 6;

/// A push on a body, and the body whose going would take it away; -1: none.
template <int Dim>
struct Push {
  std::int32_t body, by;
  Vec<wrench_size<Dim>> wrench;  ///< unit force, and its torque over the outer radius
};

template <int Dim>
class Pushes {
 public:
  explicit Pushes(const System<Dim>& system)
      : system_(system), bodies_(system.topology.body_count(system.state.size())) {
    for (int b = 0; b < bodies_; ++b) {
      centre_.push_back(body_centre(system, b));
      radius_.push_back(outer_radius(system, b));
    }
  }

  /// A force that acts on a body at a point of its unwrapped copy.
  void add(std::int32_t body, std::int32_t by, const Vec<Dim>& force, const Vec<Dim>& at) {
    const double size = norm(force);
    if (!(size > 0)) return;
    const Vec<Dim> push = (1 / size) * force;
    Push<Dim>& added = all_.emplace_back(Push<Dim>{body, by, {}});
    for (int d = 0; d < Dim; ++d) added.wrench[d] = push[d];
    if (!(system_.topology.body_size(body) > 1 && radius_[body] > 0)) return;  // it does not turn
    const Angular<Dim> torque = cross(at - centre_[body], push);
    if constexpr (Dim == 2) added.wrench[Dim] = torque / radius_[body];
    else
      for (int d = 0; d < Dim; ++d) added.wrench[Dim + d] = torque[d] / radius_[body];
  }

  std::vector<std::uint8_t> rattlers(double least_rate) {
    std::stable_sort(all_.begin(), all_.end(),
                     [](const Push<Dim>& a, const Push<Dim>& b) { return a.body < b.body; });
    std::vector<std::uint8_t> rattler(static_cast<std::size_t>(bodies_), 0);
    std::vector<Vec<wrench_size<Dim>>> wrenches;
    for (bool removed = true; removed;) {
      removed = false;
      auto push = all_.begin();
      for (int b = 0; b < bodies_; ++b) {
        wrenches.clear();
        for (; push != all_.end() && push->body == b; ++push)
          if (push->by < 0 || !rattler[push->by]) wrenches.push_back(push->wrench);
        if (rattler[b] || is_fixed(b) || distance_to_hull(wrenches) <= least_rate) continue;
        rattler[b] = 1;
        removed = true;
      }
    }
    return rattler;
  }

  int bodies() const { return bodies_; }
  const Vec<Dim>& centre(int body) const { return centre_[body]; }

 private:
  bool is_fixed(int b) const {
    const auto& mobility = system_.state.mobility;
    return std::any_of(mobility.begin() + system_.topology.body_begin(b),
                       mobility.begin() + system_.topology.body_end(b),
                       [](Mobility m) { return m != Mobility::free; });
  }

  const System<Dim>& system_;
  int bodies_;
  std::vector<Vec<Dim>> centre_;
  std::vector<double> radius_;
  std::vector<Push<Dim>> all_;
};

}  // namespace

template <int Dim>
std::vector<std::uint8_t> find_rattlers(const System<Dim>& system,
                                        const std::vector<SiteContact<Dim>>& contacts,
                                        const std::type_identity_t<OutsideForces<Dim>>& outside,
                                        double least_rate) {
  Pushes<Dim> pushes(system);
  for (const SiteContact<Dim>& c : contacts) {
    if (c.body == c.other_body) continue;  // an image of itself moves with it
    const Vec<Dim>& at = system.state.position[c.site];
    for (const double sign : {1.0, -1.0}) {
      if (sign < 0 && !c.holds) continue;
      pushes.add(c.body, c.other_body, sign * c.force, at);
      pushes.add(c.other_body, c.body, -sign * c.force, at - c.shift);
    }
  }
  const std::vector<std::int32_t> body = bodies_of_sites(system.topology, system.state.size());
  if constexpr (Dim == 2)
    for (const Link& link : system.links) {  // holds both ways
      const Vec2 &from = system.state.position[link.first], &to = system.state.position[link.second];
      const Vec2 r = link_vector(system, link);
      for (const double sign : {1.0, -1.0}) {
        pushes.add(body[link.second], body[link.first], sign * r, to);
        pushes.add(body[link.first], body[link.second], -sign * r, from);
      }
    }
  for (const SiteForce<Dim>& w : outside.wall)
    pushes.add(body[w.site], -1, w.force, system.state.position[w.site]);
  for (int b = 0; b < pushes.bodies(); ++b) pushes.add(b, -1, outside.gravity, pushes.centre(b));
  return pushes.rattlers(least_rate);
}

template std::vector<std::uint8_t> find_rattlers(const System<2>&, const std::vector<SiteContact<2>>&,
                                                 const OutsideForces<2>&, double);
template std::vector<std::uint8_t> find_rattlers(const System<3>&, const std::vector<SiteContact<3>>&,
                                                 const OutsideForces<3>&, double);

}  // namespace supple
