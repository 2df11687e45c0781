#include "supple/draw/scene/drawn_cell.hpp"

#include <algorithm>
#include <cmath>

namespace supple {

double drawn_strain(const Box<2>& box) {
  if (!box.periodic[flow]) return 0;
  const double repeat = box.length[flow] / box.length[gradient];
  return box.strain - repeat * std::round(box.strain / repeat);
}

Box<2> sheared(Box<2> box, double strain) {
  box.strain = strain;
  return box;
}

namespace {
Lattice<2> drawn_lattice(const Box<2>& box) { return sheared(box, drawn_strain(box)).lattice(); }
}  // namespace

std::array<Vec2, 4> cell_corners(const Box<2>& box) {
  const double lx = box.length[flow], ly = box.length[gradient], lean = 0.5 * drawn_lattice(box).shift;
  return {{{-lean, 0}, {lx - lean, 0}, {lx + lean, ly}, {lean, ly}}};
}

bool comes_near(const std::array<Vec2, 4>& corner, const Vec2& x, double reach) {
  for (int k = 0; k < 4; ++k) {
    const Vec2 edge = corner[(k + 1) % 4] - corner[k];
    if (cross(edge, x - corner[k]) < -reach * norm(edge)) return false;
  }
  return true;
}

Lies lies_in(const std::array<Vec2, 4>& corner, std::span<const Vec2> points) {
  bool inside = true;
  for (int k = 0; k < 4; ++k) {
    const Vec2 edge = corner[(k + 1) % 4] - corner[k];
    const auto beyond = [&](const Vec2& x) { return cross(edge, x - corner[k]) < 0; };
    if (std::all_of(points.begin(), points.end(), beyond)) return Lies::outside;
    inside = inside && std::none_of(points.begin(), points.end(), beyond);
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
