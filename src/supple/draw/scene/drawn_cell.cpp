#include "supple/draw/scene/drawn_cell.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace supple {

template <int Dim>
double drawn_strain(const Box<Dim>& box) {
  if (!box.periodic[flow]) return 0;
  const double repeat = box.length[flow] / box.length[gradient];
  return box.strain - repeat * std::round(box.strain / repeat);
}

namespace {
template <int Dim>
Lattice<Dim> drawn_lattice(Box<Dim> box) {
  box.strain = drawn_strain(box);
  return box.lattice();
}
}  // namespace

template <int Dim>
std::array<Vec<Dim>, Dim> cell_edges(const Box<Dim>& box) {
  std::array<Vec<Dim>, Dim> edge;
  for (int d = 0; d < Dim; ++d) {
    Vec<Dim> one{};
    one[d] = 1;
    edge[d] = drawn_lattice(box).vector(one);
  }
  return edge;
}

std::array<Vec2, 4> cell_corners(const Box<2>& box) {
  const double lx = box.length[flow], ly = box.length[gradient], lean = 0.5 * drawn_lattice(box).shift;
  return {{{-lean, 0}, {lx - lean, 0}, {lx + lean, ly}, {lean, ly}}};
}

std::array<Vec3, 8> cell_corners(const Box<3>& box) {
  const Lattice<3> lattice = drawn_lattice(box);
  std::array<Vec3, 8> corner;
  for (int k = 0; k < 8; ++k) {
    corner[k] = lattice.vector({1.0 * (k & 1), 1.0 * (k >> 1 & 1), 1.0 * (k >> 2 & 1)});
    corner[k][flow] -= 0.5 * lattice.shift;
  }
  return corner;
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

template <int Dim>
Vec<Dim> into_cell(const Box<Dim>& box, Vec<Dim> x) {
  Vec<Dim> unused{};
  Box<Dim> vertical = box;
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

std::vector<Vec3> neighbour_cells(const Box<3>& box) {
  const auto far = [&](int d) { return !box.periodic[d] ? 0 : d == flow ? 2 : 1; };
  std::vector<Vec3> shifts{{0, 0, 0}};
  for (int r = -far(2); r <= far(2); ++r)
    for (int q = -far(gradient); q <= far(gradient); ++q)
      for (int p = -far(flow); p <= far(flow); ++p)
        if (p != 0 || q != 0 || r != 0)
          shifts.push_back(drawn_lattice(box).vector({1.0 * p, 1.0 * q, 1.0 * r}));
  return shifts;
}

template double drawn_strain(const Box<2>&);
template double drawn_strain(const Box<3>&);
template std::array<Vec2, 2> cell_edges<2>(const Box<2>&);
template std::array<Vec3, 3> cell_edges<3>(const Box<3>&);
template Vec2 into_cell(const Box<2>&, Vec2);
template Vec3 into_cell(const Box<3>&, Vec3);

}  // namespace supple
