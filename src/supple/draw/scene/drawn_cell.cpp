#include "supple/draw/scene/drawn_cell.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace supple {

double drawn_strain(const Box<2>& box) {
  if (!box.periodic[flow]) return 0;
  const double repeat = box.length[flow] / box.length[gradient];
  return box.strain - repeat * std::round(box.strain / repeat);
}

namespace {
Lattice<2> drawn_lattice(Box<2> box) {
  box.strain = drawn_strain(box);
  return box.lattice();
}
}  // namespace

std::array<Vec2, 4> cell_corners(const Box<2>& box) {
  const double lx = box.length[flow], ly = box.length[gradient], lean = 0.5 * drawn_lattice(box).shift;
  return {{{-lean, 0}, {lx - lean, 0}, {lx + lean, ly}, {lean, ly}}};
}

Lies lies_in(const std::array<Vec2, 4>& corner, std::span<const Vec2> points, std::span<const double> radius,
             const Vec2& shift, double margin) {
  bool inside = true;
  for (int k = 0; k < 4; ++k) {
    const Vec2 edge = corner[(k + 1) % 4] - corner[k], from = corner[k] - shift;
    double low = std::numeric_limits<double>::max(), high = -low;  // above the edge
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double height = cross(edge, points[i] - from) / norm(edge), r = radius.empty() ? 0 : radius[i];
      low = std::min(low, height - r);
      high = std::max(high, height + r);
    }
    if (high < -margin) return Lies::outside;
    inside = inside && low >= -margin;
  }
  return inside ? Lies::inside : Lies::across;
}

Vec2 into_cell(const Box<2>& box, Vec2 x) {
  Vec2 unused{};
  Box<2> vertical = box;
  vertical.periodic[flow] = false;
  vertical.wrap(x, unused);
  if (box.periodic[flow]) {
    const double lean = drawn_strain(box) * (x[gradient] - 0.5 * box.length[gradient]);
    x[flow] -= std::floor((x[flow] - lean) / box.length[flow]) * box.length[flow];
  }
  return x;
}

std::vector<Vec2> neighbour_cells(const Box<2>& box) {
  const int across = box.periodic[flow] ? 2 : 0, up = box.periodic[gradient] ? 1 : 0;
  std::vector<Vec2> shifts{{0, 0}};
  for (int q = -up; q <= up; ++q)
    for (int p = -across; p <= across; ++p)
      if (p != 0 || q != 0) shifts.push_back(drawn_lattice(box).vector({1.0 * p, 1.0 * q}));
  return shifts;
}

}  // namespace supple
