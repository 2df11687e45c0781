/// The reference for contacts in a periodic cell: the bodies with all their images, side by side in an open
/// cell.
#pragma once
#include <array>
#include <cmath>

#include "supple/model/system.hpp"
#include "tests/support/all_pairs.hpp"

namespace supple::testing {

/// The bodies of a periodic system and their images up to `cells` cells away, in a cell without periods, with
/// a row for every pair of sites. Sites of the periodic system come first, each body moved as a whole into
/// the cell. Forces on them are those of the periodic system, however small or sheared the cell and wherever
/// its bodies are: no rule of nearest images is used.
template <int Dim>
System<Dim> with_all_images(const System<Dim>& periodic, int cells = 2) {
  const Box<Dim>& box = periodic.box;
  const Topology<Dim>& topology = periodic.topology;
  const int sites = periodic.state.size(), bodies = topology.body_count(sites);
  System<Dim> open;
  for (bool& p : open.box.periodic) p = false;
  open.box.length = box.length;
  open.topology.begin = {0};
  const auto add = [&](int b, const Vec<Dim>& move, double up) {
    const int first = open.state.size();
    for (std::int32_t i = topology.body_begin(b); i < topology.body_end(b); ++i) {
      const int at = open.state.size();
      open.state.resize(at + 1);
      const State<Dim>& from = periodic.state;
      State<Dim>& to = open.state;
      to.position[at] = from.position[i] + move;
      to.velocity[at] = from.velocity[i] + box.velocity_jump(1) * up;
      to.radius[at] = from.radius[i];
      to.mass[at] = from.mass[i];
      to.inertia[at] = from.inertia[i];
      to.spin[at] = from.spin[i];
    }
    open.topology.begin.push_back(open.state.size());
    if (Dim == 2) return;  // edges follow from the order of vertices
    for (std::int32_t k = topology.facet_begin[b]; k < topology.facet_begin[b + 1]; ++k) {
      auto facet = topology.facet[k];
      for (std::int32_t& site : facet) site += first - topology.body_begin(b);
      open.topology.facet.push_back(facet);
    }
  };
  const auto middle = [&](int b) {
    Vec<Dim> sum{};
    for (std::int32_t i = topology.body_begin(b); i < topology.body_end(b); ++i)
      sum += (1.0 / topology.body_size(b)) * periodic.state.position[i];
    return sum;
  };
  const auto add_image = [&](std::array<int, Dim> image) {
    const int up = image[gradient];
    const double sheared = up * box.strain * box.length[gradient];
    const double lean = box.periodic[flow] ? std::round(sheared / box.length[flow]) : 0;
    Vec<Dim> shift;
    for (int d = 0; d < Dim; ++d) shift[d] = image[static_cast<std::size_t>(d)] * box.length[d];
    shift[flow] = sheared + (image[flow] - lean) * box.length[flow];
    for (int b = 0; b < bodies; ++b) {
      const Vec<Dim> centre = middle(b);
      Vec<Dim> home = centre, jump{};
      const Vec<Dim> moved = box.wrap(home, jump);
      add(b, home - centre + shift, up - moved[gradient]);
    }
  };
  add_image({});
  int images = 1;
  for (int d = 0; d < Dim; ++d) images *= 2 * cells + 1;
  for (int k = 0; k < images; ++k) {
    std::array<int, Dim> image;
    bool itself = true, exists = true;
    for (int d = 0, left = k; d < Dim; ++d, left /= 2 * cells + 1) {
      const int n = left % (2 * cells + 1) - cells;
      image[static_cast<std::size_t>(d)] = n;
      itself = itself && n == 0;
      exists = exists && (n == 0 || box.periodic[d]);
    }
    if (exists && !itself) add_image(image);
  }
  fill_all_pairs(open);
  return open;
}

}  // namespace supple::testing
