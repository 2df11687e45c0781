#include "supple/force/surface_shape.hpp"

#include <cmath>
#include <cstdint>

#include "supple/core/parallel.hpp"
#include "supple/force/body_parts.hpp"
#include "supple/force/lane_vectors.hpp"
#include "supple/force/shape_terms.hpp"
#include "supple/force/surface_hessian.hpp"
#include "supple/force/surface_rows.hpp"
#include "supple/geometry/turning_angle.hpp"

// All of a surface by its triangles. In a triangle of the corners x_k let d_k be the edge opposite to corner
// k, x_(k+2) - x_(k+1), N = d_1 x d_2 = 2 a n, and c_k = -(d_(k+1).d_(k+2))/(2a) the cotangent at corner k.
// Then
//   dv/dx_k = sum of N/6 over the triangles at x_k, as the other parts of it cancel on a closed surface;
//   da/dx_k = (c_(k+1) d_(k+1) - c_(k+2) d_(k+2))/2            [Pinkall & Polthier 1993];
//   and of the hinge at d_k, whose angle falls where corner k moves outward, the triangle has the part
//   dtheta_k/dx_k = -n (c_(k+1) + c_(k+2))/l_k = -n/height,  dtheta_k/dx_(k+1) = n c_(k+2)/l_k,
//   dtheta_k/dx_(k+2) = n c_(k+1)/l_k                          [Wardetzky et al. 2007].
// With the moments m_k = k_b (theta_k - theta_k0)/l_k of its hinges, the slope of the energy at corner k is
//   n (p a/3 + c_(k+1) (m_(k+2) - m_k) + c_(k+2) (m_(k+1) - m_k)) + q_(k+1) - q_(k+2),
//   q_k = (k_a (a - a0) + gamma) c_k d_k / 2,  p = k_v (v - v0).
// A hinge thus gives one number to each of its two triangles, and nothing is added to sites in between.

namespace supple {

namespace {

using namespace lanes;
using namespace surfaces;
using Place = Triangulation::Place;
static_assert(block == Triangulation::block);

/// Where number i of the first of so many rows stands, in blocks of rows.
int in_rows(int i, int rows) { return i / block * rows * block + i % block; }

/// Edges, normals, areas and cotangents of the triangles, and squares of their edges. Returns the volume.
[[gnu::noinline]] double measure_triangles(const Surface& s) {
  const double* const x = s.position;
  for (int t = 0; t < s.mesh->facet_blocks * block; t += width) {
    const Place* const site = s.mesh->corner_site.data() + in_rows(t, 3);
    Point from_2[width], to_1[width], first[width];
    for (int v = 0; v < width; ++v) {
      first[v] = load<Point>(x + site[v]);
      to_1[v] = load<Point>(x + site[block + v]) - first[v];
      from_2[v] = first[v] - load<Point>(x + site[2 * block + v]);
    }
    const Vectors d1 = side_by_side(from_2), d2 = side_by_side(to_1), d0 = -(d1 + d2);
    const Vectors across = cross(d1, d2);
    const Numbers square = dot(across, across), per = per_root(square);
    const Vectors n = across * per;
    const Numbers corner[3] = {-dot(d1, d2), -dot(d2, d0), -dot(d0, d1)};
    double* const here = s.triangle + in_rows(t, row::count);
    store_vectors(d1, here + row::edge_1 * block);
    store_vectors(d2, here + row::edge_2 * block);
    store_vectors(n, here + row::normal * block);
    store(square * per, here + row::twice_area * block);
    for (int k = 0; k < 3; ++k) {
      store(corner[k] * per, here + (row::cotangent + k) * block);
      store(corner[(k + 1) % 3] + corner[(k + 2) % 3], s.edge_square + in_rows(t, 3) + k * block);
    }
    store_points(n, s.facet_normal + 4 * t);
    // The flux of (0, 0, z): the projected area, half of N_z, times the mean height of the corners.
    store((1.0 / 6) * across[2] * (3.0 * side_by_side(first)[2] + d2[2] - d1[2]), s.part + t);
  }
  LaneSum volume;
  volume.add(s.part, s.mesh->facets);
  return volume.total();
}

/// The moment of each hinge over its length. The difference of two unit vectors with the angle theta between
/// them has the square 2 - 2 cos(theta), and points from the right triangle to the left one where the hinge
/// is convex.
[[gnu::noinline]] void measure_hinges(const Surface& s, double stiffness) {
  const Triangulation& mesh = *s.mesh;
  for (int begin = 0; begin < mesh.hinge_blocks * block; begin += width) {
    const Place *const left = mesh.hinge_facet[0].data() + begin,
                       *const right = mesh.hinge_facet[1].data() + begin,
                       *const outer = mesh.hinge_outer[0].data() + begin,
                       *const other = mesh.hinge_outer[1].data() + begin;
    Point apart[width], across[width];
    for (int v = 0; v < width; ++v) {
      apart[v] = load<Point>(s.facet_normal + left[v]) - load<Point>(s.facet_normal + right[v]);
      across[v] = load<Point>(s.position + outer[v]) - load<Point>(s.position + other[v]);
    }
    const Vectors turn = side_by_side(apart);
    const Numbers square = dot(turn, turn), cosines = 1.0 - 0.5 * square;
    double sine_square[width], cosine[width], side[width], edge_square[width], angle[width];
    store(square * (1.0 - 0.25 * square), sine_square);
    store(cosines, cosine);
    store(dot(turn, side_by_side(across)), side);
    store(gathered(s.edge_square, mesh.hinge_corner.data() + begin), edge_square);
    for_lanes([&](int v) {
      side[v] = std::copysign(sine_square[v] * inverse_root(sine_square[v]), side[v]);
      angle[v] = blunt_turning_angle(side[v], cosine[v]);
    });
    if (any(cosines < least_blunt_cosine))
      for_lanes([&](int v) {
        angle[v] = cosine[v] < least_blunt_cosine ? turning_angle(side[v], cosine[v], 1) : angle[v];
      });
    for_lanes([&, moment = s.moment + begin, rest = s.rest_angle + begin](int v) {
      moment[v] = stiffness * (angle[v] - rest[v]) * inverse_root(edge_square[v]);
    });
  }
}

/// Forces of the triangles on their corners.
template <bool bends>
[[gnu::noinline]] void push_corners(const Surface& s, const ShapeStiffness& k) {
  const double sixth_pressure = (1.0 / 6) * s.pressure, half_stretch = 0.5 * k.facet,
               half_tension = 0.5 * k.tension;
  for (int t = 0; t < s.mesh->facet_blocks * block; t += width) {
    const double* const here = s.triangle + in_rows(t, row::count);
    const Vectors d1 = load_vectors(here + row::edge_1 * block),
                  d2 = load_vectors(here + row::edge_2 * block), n = load_vectors(here + row::normal * block),
                  cot = load_vectors(here + row::cotangent * block);
    const Numbers twice_area = load(here + row::twice_area * block),
                  beyond_rest = 0.5 * twice_area - load(s.rest_area + t),
                  pull = half_stretch * beyond_rest + half_tension;
    const Vectors q[3] = {(d1 + d2) * (-(pull * cot[0])), d1 * (pull * cot[1]), d2 * (pull * cot[2])};
    Numbers out[3];
    for (Numbers& corner : out) corner = sixth_pressure * twice_area;
    if constexpr (bends) {
      const Place* const hinge = s.mesh->corner_hinge.data() + in_rows(t, 3);
      const Numbers m0 = gathered(s.moment, hinge), m1 = gathered(s.moment, hinge + block),
                    m2 = gathered(s.moment, hinge + 2 * block);
      const Numbers by_0 = cot[0] * (m2 - m1), by_1 = cot[1] * (m0 - m2), by_2 = cot[2] * (m1 - m0);
      out[0] += by_2 - by_1;
      out[1] += by_0 - by_2;
      out[2] += by_1 - by_0;
    }
    for (int c = 0; c < 3; ++c)
      store_points(q[(c + 2) % 3] - q[(c + 1) % 3] - n * out[c],
                   s.corner_force + 4 * (in_rows(t, 3) + c * block));
  }
}

/// Adds up the forces of the corners at each site; with a virial, forces times where they act.
template <Detail detail>
[[gnu::noinline]] void add_forces(const Surface& s, Vec3* force, Mat<3>& virial) {
  const Triangulation& mesh = *s.mesh;
  Point by_force[3]{};
  for (int i = 0; i < mesh.sites; ++i) {
    Point sum{}, more{};
    for (std::int32_t c = mesh.site_begin[i]; c < mesh.site_begin[i + 1]; c += 2) {
      sum += load<Point>(s.corner_force + mesh.site_corner[c]);
      more += load<Point>(s.corner_force + mesh.site_corner[c + 1]);
    }
    sum += more;
    for (int d = 0; d < 3; ++d) force[i][d] += sum[d];
    if constexpr (detail == Detail::energies)
      for (int d = 0; d < 3; ++d) by_force[d] += sum[d] * load<Point>(s.position + 4 * i);
  }
  for (int c = 0; c < 3; ++c)
    for (int d = 0; d < 3; ++d) virial[c][d] += by_force[c][d];
}

double stored_energy(const Surface& s, const ShapeStiffness& k) {
  const Triangulation& mesh = *s.mesh;
  LaneSum sum;
  for (int t = 0; t < mesh.facet_blocks * block; t += width) {
    const Numbers area = 0.5 * load(s.triangle + in_rows(t, row::count) + row::twice_area * block),
                  beyond_rest = area - load(s.rest_area + t);
    store(0.5 * k.facet * beyond_rest * beyond_rest + k.tension * area, s.part + t);
  }
  sum.add(s.part, mesh.facets);
  if (k.hinge != 0) {
    for (int h = 0; h < mesh.hinges; ++h)
      s.part[h] = 0.5 / k.hinge * s.moment[h] * s.moment[h] * s.edge_square[mesh.hinge_corner[h]];
    sum.add(s.part, mesh.hinges);
  }
  return sum.total() + (k.volume != 0 ? 0.5 * s.pressure * s.pressure / k.volume : 0);
}

struct ShapeSum {
  double energy = 0;
  Mat<3> virial;
  ShapeSum& operator+=(const ShapeSum& b) {
    energy += b.energy;
    virial += b.virial;
    return *this;
  }
};

void add_body(const System<3>& system, int b, Detail detail, Surface& s, Evaluation<3>& out, ShapeSum& sum) {
  const ShapeStiffness& k = system.shape.stiffness[b];
  s.place(system, b);
  s.pressure = k.volume * (measure_triangles(s) - system.shape.rest_volume[b]);
  if (k.hinge != 0) {
    measure_hinges(s, k.hinge);
    push_corners<true>(s, k);
  } else {
    push_corners<false>(s, k);
  }
  Vec3* const force = &out.force[system.topology.begin[b]];
  if (detail == Detail::forces) return add_forces<Detail::forces>(s, force, sum.virial);
  add_forces<Detail::energies>(s, force, sum.virial);
  sum.energy += stored_energy(s, k);
}

}  // namespace

double SurfaceShape::energy(const System<3>& system) const {
  double sum = 0;
  for (const auto& [name, energy] : shape_terms(system).energies(system)) sum += energy;
  return sum;
}

void SurfaceShape::evaluate(const System<3>& system, Detail detail, Evaluation<3>& out) const {
  if (system.shape.empty()) return;
  const std::vector<int> part_begin = parts_of_bodies(system, 64, 2048);
  const auto add_part = [&](std::int64_t part) {
    static thread_local Surface surface;
    ShapeSum sum;
    const int end = part_begin[static_cast<std::size_t>(part) + 1];
    for (int b = part_begin[static_cast<std::size_t>(part)]; b < end; ++b)
      if (has_shape_energy(system, b)) add_body(system, b, detail, surface, out, sum);
    return sum;
  };
  const auto total = sum_parts<ShapeSum>(static_cast<std::int64_t>(part_begin.size()) - 1, add_part);
  if (detail == Detail::forces) return;
  out.energy.terms += total.energy;
  out.virial += total.virial;
}

void SurfaceShape::add_hessian(const System<3>& system, HessianBlocks<3>& blocks) const {
  for (std::size_t b = 0; b < system.shape.stiffness.size(); ++b)
    add_surface_hessian(system, static_cast<int>(b), blocks);
}

void SurfaceShape::add_sparse_hessian(const System<3>& system, HessianBlocks<3>& blocks) const {
  for (std::size_t b = 0; b < system.shape.stiffness.size(); ++b)
    add_surface_hessian(system, static_cast<int>(b), blocks, HessianKind::sparse);
}

void SurfaceShape::add_body_hessian(const System<3>& system, int b, HessianBlocks<3>& blocks,
                                    OuterProducts<3>& products) const {
  if (static_cast<std::size_t>(b) < system.shape.stiffness.size())
    add_surface_hessian(system, b, blocks, HessianKind::exact, &products);
}

}  // namespace supple
