/// The reference for contacts in a periodic cell: the bodies with all their images, side by side in an open
/// cell.
#pragma once
#include <cmath>

#include "supple/model/bodies.hpp"
#include "supple/model/system.hpp"
#include "tests/support/all_pairs.hpp"

namespace supple::testing {

/// The bodies of a periodic system and their images up to `cells` cells away, in a cell without periods, with
/// a row for every pair of sites. Sites of the periodic system come first, each body moved as a whole into
/// the cell. Forces on them are those of the periodic system, however small or sheared the cell and wherever
/// its bodies are: no rule of nearest images is used.
inline System<2> with_all_images(const System<2>& periodic, int cells = 2) {
  const Box<2>& box = periodic.box;
  const int sites = periodic.state.size(), bodies = periodic.topology.body_count(sites);
  System<2> open;
  open.box.periodic = {false, false};
  open.box.length = box.length;
  open.topology.begin = {0};
  const auto add = [&](int b, const Vec2& move, double up) {
    for (std::int32_t i = periodic.topology.body_begin(b); i < periodic.topology.body_end(b); ++i) {
      const int at = open.state.size();
      open.state.resize(at + 1);
      const State<2>& from = periodic.state;
      State<2>& to = open.state;
      to.position[at] = from.position[i] + move;
      to.velocity[at] = from.velocity[i] + box.velocity_jump(1) * up;
      to.radius[at] = from.radius[i];
      to.mass[at] = from.mass[i];
      to.inertia[at] = from.inertia[i];
      to.spin[at] = from.spin[i];
    }
    open.topology.begin.push_back(open.state.size());
  };
  const auto add_image = [&](int along, int up) {
    const double sheared = up * box.strain * box.length[gradient];
    const double lean = box.periodic[flow] ? std::round(sheared / box.length[flow]) : 0;
    const Vec2 image{sheared + (along - lean) * box.length[flow], up * box.length[gradient]};
    for (int b = 0; b < bodies; ++b) {
      const Vec2 centre = body_centre(periodic, b);
      Vec2 home = centre, jump{};
      const Vec2 moved = box.wrap(home, jump);
      add(b, home - centre + image, up - moved[gradient]);
    }
  };
  add_image(0, 0);
  const int most_up = box.periodic[gradient] ? cells : 0, most_along = box.periodic[flow] ? cells : 0;
  for (int up = -most_up; up <= most_up; ++up)
    for (int along = -most_along; along <= most_along; ++along)
      if (up != 0 || along != 0) add_image(along, up);
  fill_all_pairs(open);
  return open;
}

}  // namespace supple::testing
