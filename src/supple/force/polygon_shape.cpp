#include "supple/force/polygon_shape.hpp"

#include "supple/core/multiply_add.hpp"
#include "supple/core/parallel.hpp"
#include "supple/force/body_parts.hpp"
#include "supple/force/ring_hessian.hpp"
#include "supple/force/rings.hpp"
#include "supple/force/shape_terms.hpp"
#include "supple/geometry/inverse_root.hpp"
#include "supple/geometry/turning_angle.hpp"

namespace supple {

namespace {

using namespace rings;

double sum_of_parts(const Ring& r, int n) {
  LaneSum sum;
  sum.add(r[Row::part], n);
  return sum.total();
}

struct ShapeSum {
  LaneSum energy, virial[2][2];
  ShapeSum& operator+=(const ShapeSum& b) {
    energy += b.energy;
    for (int c = 0; c < 2; ++c)
      for (int d = 0; d < 2; ++d) virial[c][d] += b.virial[c][d];
    return *this;
  }
};

/// Edge vectors and lengths, and the parts of twice the area; none of the last edge, as the first vertex is
/// the origin.
void measure_edges(const Ring& r) {
  double *const edge_x = r[Row::edge_x], *const edge_y = r[Row::edge_y],
                *const per_length = r[Row::per_length];
  const auto edge = [=](int v, double dx, double dy) {
    edge_x[v] = dx;
    edge_y[v] = dy;
    per_length[v] = inverse_root(multiply_add(dx, dx, dy * dy));
  };
  const Vec2 *const position = r.position, origin = position[0];
  for_blocks(r.n, [=, part = r[Row::part]](int v) {
    const double dx = position[v + 1][0] - position[v][0], dy = position[v + 1][1] - position[v][1];
    edge(v, dx, dy);
    part[v] = multiply_add(position[v][0] - origin[0], dy, -((position[v][1] - origin[1]) * dx));
  });
  const int last = r.n - 1;
  edge(last, origin[0] - position[last][0], origin[1] - position[last][1]);
  for (double* row : {edge_x, edge_y, per_length}) row[-1] = row[last];
}

/// Angles at the corners, those that are not blunt in a second go: few rings have any.
template <bool blunt>
void measure_angles(Ring& r) {
  double* const bent = r[Row::bent];
  for_blocks(r.n, [bent, edge_x = r[Row::edge_x], edge_y = r[Row::edge_y], per_length = r[Row::per_length],
                   rest = r.rest_angle, is_sharp = r[Row::part]](int v) {
    const double per_product = per_length[v - 1] * per_length[v];
    const double sine = per_product * multiply_add(edge_x[v - 1], edge_y[v], -(edge_y[v - 1] * edge_x[v]));
    const double cosine = per_product * multiply_add(edge_x[v - 1], edge_x[v], edge_y[v - 1] * edge_y[v]);
    if constexpr (blunt) {
      bent[v] = blunt_turning_angle(sine, cosine) - rest[v];
      is_sharp[v] = cosine < least_blunt_cosine ? 1 : 0;
    } else {
      const double angle = turning_angle(sine, cosine, 1) - rest[v];
      bent[v] = cosine < least_blunt_cosine ? angle : bent[v];
    }
  });
  bent[r.n] = bent[0];
  if constexpr (blunt) r.sharp = sum_of_parts(r, r.n) > 0;
}

/// Forces of each edge on its ends by stretching, tension, the moments at both ends, and pressure.
template <bool bends>
void push_ends(const ShapeStiffness& k, const Ring& r) {
  double *const end_x = r[Row::end_x], *const end_y = r[Row::end_y];
  for_blocks(r.n, [end_x, end_y, start_x = r[Row::start_x], start_y = r[Row::start_y], bent = r[Row::bent],
                   rest = r.rest_length, edge_x = r[Row::edge_x], edge_y = r[Row::edge_y],
                   per_length = r[Row::per_length], stretch = k.facet, tension = k.tension, bend = k.hinge,
                   half_pressure = 0.5 * r.pressure](int v) {
    const double pull = multiply_add(multiply_add(-stretch, rest[v], tension), per_length[v], stretch);
    double along_x = pull * edge_x[v], along_y = pull * edge_y[v];
    if constexpr (bends) {
      const double turn = bend * (bent[v] - bent[v + 1]) * (per_length[v] * per_length[v]);
      along_x = multiply_add(-turn, edge_y[v], along_x);
      along_y = multiply_add(turn, edge_x[v], along_y);
    }
    const double out_x = half_pressure * edge_y[v], out_y = -half_pressure * edge_x[v];
    start_x[v] = along_x - out_x, end_x[v] = -along_x - out_x;
    start_y[v] = along_y - out_y, end_y[v] = -along_y - out_y;
  });
  end_x[-1] = end_x[r.n - 1], end_y[-1] = end_y[r.n - 1];
}

void add_forces(const Ring& r, Vec2* __restrict force) {
  const double* __restrict start_x = r[Row::start_x], * __restrict start_y = r[Row::start_y];
  const double* __restrict end_x = r[Row::end_x] - 1, * __restrict end_y = r[Row::end_y] - 1;
  const int n = r.n;
  for (int v = 0; v < n; ++v) {
    force[v][0] += start_x[v] + end_x[v];
    force[v][1] += start_y[v] + end_y[v];
  }
}

template <bool bends>
void add_energies(const ShapeStiffness& k, const Ring& r, ShapeSum& sum) {
  for_blocks(r.n, [edge_x = r[Row::edge_x], edge_y = r[Row::edge_y], per_length = r[Row::per_length],
                   bent = r[Row::bent], rest = r.rest_length, part = r[Row::part], stretch = k.facet,
                   tension = k.tension, bend = k.hinge](int v) {
    const double length = (edge_x[v] * edge_x[v] + edge_y[v] * edge_y[v]) * per_length[v],
                 beyond = length - rest[v];
    part[v] = 0.5 * stretch * beyond * beyond + tension * length;
    if constexpr (bends) part[v] += 0.5 * bend * bent[v] * bent[v];
  });
  sum.energy.add(r[Row::part], r.n);
  if (k.volume > 0) sum.energy.lanes[0] += 0.5 * r.pressure * r.pressure / k.volume;
}

/// Forces on the vertices times where they are; edges are no longer needed.
void add_virial(const Ring& r, ShapeSum& sum) {
  double* const product[2][2] = {{r[Row::edge_x], r[Row::edge_y]}, {r[Row::per_length], r[Row::bent]}};
  for_blocks(r.n, [xx = product[0][0], xy = product[0][1], yx = product[1][0], yy = product[1][1],
                   position = r.position, origin = r.position[0], start_x = r[Row::start_x],
                   start_y = r[Row::start_y], end_x = r[Row::end_x], end_y = r[Row::end_y]](int v) {
    const double force_x = start_x[v] + end_x[v - 1], force_y = start_y[v] + end_y[v - 1];
    const double x = position[v][0] - origin[0], y = position[v][1] - origin[1];
    xx[v] = force_x * x, xy[v] = force_x * y;
    yx[v] = force_y * x, yy[v] = force_y * y;
  });
  for (int c = 0; c < 2; ++c)
    for (int d = 0; d < 2; ++d) sum.virial[c][d].add(product[c][d], r.n);
}

/// Each pass in a function of its own, or the compiler runs out of registers.
template <class Pass>
[[gnu::noinline]] void for_rings(std::vector<Ring>& rings, const Pass& pass) {
  for (Ring& r : rings) pass(r);
}

void add_group(const System<2>& system, Detail detail, Group& g, Evaluation<2>& out, ShapeSum& sum) {
  const auto stiffness = [&](const Ring& r) -> const ShapeStiffness& {
    return system.shape.stiffness[r.body];
  };
  g.place(system);
  for_rings(g.rings, [](Ring& r) { measure_edges(r); });
  for_rings(g.rings, [&](Ring& r) {
    r.pressure = stiffness(r).volume * (0.5 * sum_of_parts(r, r.n - 1) - system.shape.rest_volume[r.body]);
  });
  for_rings(g.rings, [&](Ring& r) {
    if (stiffness(r).hinge != 0) measure_angles<true>(r);
  });
  for_rings(g.rings, [&](Ring& r) {
    if (r.sharp) measure_angles<false>(r);
  });
  for_rings(g.rings, [&](Ring& r) {
    stiffness(r).hinge != 0 ? push_ends<true>(stiffness(r), r) : push_ends<false>(stiffness(r), r);
  });
  for_rings(g.rings, [&](Ring& r) { add_forces(r, &out.force[system.topology.begin[r.body]]); });
  if (detail == Detail::forces) return;
  for_rings(g.rings, [&](Ring& r) {
    stiffness(r).hinge != 0 ? add_energies<true>(stiffness(r), r, sum)
                            : add_energies<false>(stiffness(r), r, sum);
  });
  for_rings(g.rings, [&](Ring& r) { add_virial(r, sum); });
}

bool is_stiff(const ShapeStiffness& k) {
  return k.volume != 0 || k.facet != 0 || k.hinge != 0 || k.tension != 0;
}

int ring_size(const System<2>& system, int b) {
  return system.topology.facet_begin[b + 1] - system.topology.facet_begin[b];
}

}  // namespace

double PolygonShape::energy(const System<2>& system) const {
  double sum = 0;
  for (const auto& [name, energy] : shape_terms(system).energies(system)) sum += energy;
  return sum;
}

void PolygonShape::evaluate(const System<2>& system, Detail detail, Evaluation<2>& out) const {
  if (system.shape.empty()) return;
  const std::vector<int> part_begin =
      parts_of_bodies(system, static_cast<int>(chunk_size), 32 * static_cast<int>(chunk_size));
  const auto add_part = [&](std::int64_t part) {
    static thread_local Group group;
    ShapeSum sum;
    const int end = part_begin[static_cast<std::size_t>(part) + 1];
    int sites = 0;
    group.rings.clear();
    for (int b = part_begin[static_cast<std::size_t>(part)]; b < end; ++b) {
      const int n = ring_size(system, b);
      if (n > 0 && is_stiff(system.shape.stiffness[b])) group.rings.emplace_back(b, n);
      if ((sites += n) < Group::sites && b + 1 < end) continue;
      add_group(system, detail, group, out, sum);
      group.rings.clear();
      sites = 0;
    }
    return sum;
  };
  const auto total = sum_parts<ShapeSum>(static_cast<std::int64_t>(part_begin.size()) - 1, add_part);
  if (detail == Detail::forces) return;
  out.energy.terms += total.energy.total();
  for (int c = 0; c < 2; ++c)
    for (int d = 0; d < 2; ++d) out.virial[c][d] += total.virial[c][d].total();
}

void PolygonShape::add_hessian(const System<2>& system, HessianBlocks<2>& blocks) const {
  for (std::size_t b = 0; b < system.shape.stiffness.size(); ++b)
    add_ring_hessian(system, static_cast<int>(b), blocks);
}

void PolygonShape::add_sparse_hessian(const System<2>& system, HessianBlocks<2>& blocks) const {
  for (std::size_t b = 0; b < system.shape.stiffness.size(); ++b)
    add_ring_hessian(system, static_cast<int>(b), blocks, HessianKind::sparse);
}

void PolygonShape::add_body_hessian(const System<2>& system, int b, HessianBlocks<2>& blocks,
                                    OuterProducts<2>& products) const {
  if (static_cast<std::size_t>(b) < system.shape.stiffness.size())
    add_ring_hessian(system, b, blocks, HessianKind::exact, &products);
}

}  // namespace supple
