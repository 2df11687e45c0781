#include "supple/force/surface_shape.hpp"

#include <cmath>
#include <cstdint>
#include <cstring>

#include "supple/core/parallel.hpp"
#include "supple/force/body_parts.hpp"
#include "supple/force/lanes.hpp"
#include "supple/force/shape_terms.hpp"
#include "supple/force/surface_hessian.hpp"
#include "supple/force/surface_rows.hpp"
#include "supple/geometry/inverse_root.hpp"
#include "supple/geometry/turning_angle.hpp"

// All of a surface by its triangles. In a triangle of the corners x_k let d_k be the edge opposite to corner
// k, x_(k+2) - x_(k+1), N = d_1 x d_2 = 2 a n, and c_k = -(d_(k+1).d_(k+2))/(2a) the cotangent at corner k.
// Then
//   dv/dx_k = sum of N/6 over the triangles at x_k, as the other parts of it cancel on a closed surface;
//   da/dx_k = (c_(k+1) d_(k+1) - c_(k+2) d_(k+2))/2            [Pinkall & Polthier 1993, eq. 7];
//   and of the hinge at d_k, whose angle falls where corner k moves outward, the triangle has the part
//   dtheta_k/dx_k = -n (c_(k+1) + c_(k+2))/l_k = -n/height,  dtheta_k/dx_(k+1) = n c_(k+2)/l_k,
//   dtheta_k/dx_(k+2) = n c_(k+1)/l_k                          [Wardetzky et al. 2007, section 4].
// With the moments m_k = k_b (theta_k - theta_k0)/l_k of its hinges, the slope of the energy at corner k is
//   n (p a/3 + c_(k+1) (m_(k+2) - m_k) + c_(k+2) (m_(k+1) - m_k)) + q_(k+1) - q_(k+2),
//   q_k = (k_a (a - a0) + gamma) c_k d_k / 2,  p = k_v (v - v0).
// A hinge thus gives one number to each of its two triangles, and nothing is added to sites in between.

namespace supple {

namespace {

using namespace surfaces;
using lanes::for_blocks;
using lanes::LaneSum;
using Place = Triangulation::Place;
constexpr int width = lanes::block;
static_assert(width == Triangulation::block);

/// A point and a number that is not used; eight numbers; eight vectors side by side.
typedef double Four __attribute__((vector_size(4 * sizeof(double))));
typedef double Eight __attribute__((vector_size(width * sizeof(double))));
using EightVectors = VecOf<Eight, 3>;

template <class V>
[[gnu::always_inline]] inline V load(const double* from) {
  V v;
  std::memcpy(&v, from, sizeof v);
  return v;
}
template <class V>
[[gnu::always_inline]] inline void store(const V& v, double* to) {
  std::memcpy(to, &v, sizeof v);
}

/// Eight points, one behind the other, as vectors side by side.
[[gnu::always_inline]] inline EightVectors side_by_side(const Four (&v)[width]) {
  const auto both = [](Four a, Four b) { return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7); };
  const Eight a = both(v[0], v[2]), b = both(v[1], v[3]), c = both(v[4], v[6]), d = both(v[5], v[7]);
  const Eight xz_low = __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14),
              xz_high = __builtin_shufflevector(c, d, 0, 8, 2, 10, 4, 12, 6, 14),
              y_low = __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15),
              y_high = __builtin_shufflevector(c, d, 1, 9, 3, 11, 5, 13, 7, 15);
  return {__builtin_shufflevector(xz_low, xz_high, 0, 1, 4, 5, 8, 9, 12, 13),
          __builtin_shufflevector(y_low, y_high, 0, 1, 4, 5, 8, 9, 12, 13),
          __builtin_shufflevector(xz_low, xz_high, 2, 3, 6, 7, 10, 11, 14, 15)};
}

/// The other way: stores eight points one behind the other.
[[gnu::always_inline]] inline void store_points(const EightVectors& v, double* to) {
  constexpr Eight zero{};
  const Eight xy_low = __builtin_shufflevector(v[0], v[1], 0, 8, 1, 9, 2, 10, 3, 11),
              xy_high = __builtin_shufflevector(v[0], v[1], 4, 12, 5, 13, 6, 14, 7, 15),
              z_low = __builtin_shufflevector(v[2], zero, 0, 8, 1, 9, 2, 10, 3, 11),
              z_high = __builtin_shufflevector(v[2], zero, 4, 12, 5, 13, 6, 14, 7, 15);
  store(__builtin_shufflevector(xy_low, z_low, 0, 1, 8, 9, 2, 3, 10, 11), to);
  store(__builtin_shufflevector(xy_low, z_low, 4, 5, 12, 13, 6, 7, 14, 15), to + width);
  store(__builtin_shufflevector(xy_high, z_high, 0, 1, 8, 9, 2, 3, 10, 11), to + 2 * width);
  store(__builtin_shufflevector(xy_high, z_high, 4, 5, 12, 13, 6, 7, 14, 15), to + 3 * width);
}

[[gnu::always_inline]] inline Eight gathered(const double* from, const Place* at) {
  return Eight{from[at[0]], from[at[1]], from[at[2]], from[at[3]],
               from[at[4]], from[at[5]], from[at[6]], from[at[7]]};
}

[[gnu::always_inline]] inline Eight per_root(const Eight& x) {
  double lane[width];
  store(x, lane);
  for_blocks(width, [&lane](int v) { lane[v] = inverse_root(lane[v]); });
  return load<Eight>(lane);
}

typedef std::int64_t EightFlags __attribute__((vector_size(width * sizeof(std::int64_t))));
typedef std::int8_t EightBytes __attribute__((vector_size(width)));
/// Whether a comparison holds in some lane.
[[gnu::always_inline]] inline bool any(const EightFlags& flags) {
  const EightBytes bytes = __builtin_convertvector(flags, EightBytes);
  std::uint64_t bits;
  std::memcpy(&bits, &bytes, sizeof bits);
  return bits != 0;
}

[[gnu::always_inline]] inline EightVectors vectors(const double* block, int row) {
  return {load<Eight>(block + row * width), load<Eight>(block + (row + 1) * width),
          load<Eight>(block + (row + 2) * width)};
}
[[gnu::always_inline]] inline void store_vectors(const EightVectors& v, double* block, int row) {
  for (int d = 0; d < 3; ++d) store(v[d], block + (row + d) * width);
}

/// Edges, normals, areas and cotangents of the triangles, and squares of their edges. Returns the volume.
[[gnu::noinline]] double measure_triangles(const Surface& s) {
  const double* const x = s.position;
  for (int b = 0; b < s.mesh->facet_blocks; ++b) {
    const Place* const site = s.mesh->corner_site.data() + b * 3 * width;
    Four from_2[width], to_1[width], first[width];
    for (int v = 0; v < width; ++v) {
      first[v] = load<Four>(x + site[v]);
      to_1[v] = load<Four>(x + site[width + v]) - first[v];
      from_2[v] = first[v] - load<Four>(x + site[2 * width + v]);
    }
    const EightVectors d1 = side_by_side(from_2), d2 = side_by_side(to_1), d0 = -(d1 + d2);
    const EightVectors across = cross(d1, d2);
    const Eight square = dot(across, across), per = per_root(square);
    const EightVectors n = across * per;
    const Eight corner[3] = {-dot(d1, d2), -dot(d2, d0), -dot(d0, d1)};
    double* const block = s.block(b);
    store_vectors(d1, block, row::edge_1);
    store_vectors(d2, block, row::edge_2);
    store_vectors(n, block, row::normal);
    store(square * per, block + row::twice_area * width);
    for (int k = 0; k < 3; ++k) {
      store(corner[k] * per, block + (row::cotangent + k) * width);
      store(corner[(k + 1) % 3] + corner[(k + 2) % 3], s.edge_square + (3 * b + k) * width);
    }
    store_points(n, s.facet_normal + b * 4 * width);
    // The flux of (0, 0, z): the projected area, half of N_z, times the mean height of the corners.
    store((1.0 / 6) * across[2] * (3.0 * side_by_side(first)[2] + d2[2] - d1[2]), s.part + b * width);
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
  for (int begin = 0; begin < mesh.hinge_blocks * width; begin += width) {
    const Place *const left = mesh.hinge_facet[0].data() + begin,
                       *const right = mesh.hinge_facet[1].data() + begin,
                       *const outer = mesh.hinge_outer[0].data() + begin,
                       *const other = mesh.hinge_outer[1].data() + begin;
    Four apart[width], across[width];
    for (int v = 0; v < width; ++v) {
      apart[v] = load<Four>(s.facet_normal + left[v]) - load<Four>(s.facet_normal + right[v]);
      across[v] = load<Four>(s.position + outer[v]) - load<Four>(s.position + other[v]);
    }
    const EightVectors turn = side_by_side(apart);
    const Eight square = dot(turn, turn), cosines = 1.0 - 0.5 * square;
    double sine_square[width], cosine[width], side[width], edge_square[width], angle[width];
    store(square * (1.0 - 0.25 * square), sine_square);
    store(cosines, cosine);
    store(dot(turn, side_by_side(across)), side);
    store(gathered(s.edge_square, mesh.hinge_corner.data() + begin), edge_square);
    for_blocks(width, [&](int v) {
      side[v] = std::copysign(sine_square[v] * inverse_root(sine_square[v]), side[v]);
      angle[v] = blunt_turning_angle(side[v], cosine[v]);
    });
    if (any(cosines < least_blunt_cosine))
      for_blocks(width, [&](int v) {
        angle[v] = cosine[v] < least_blunt_cosine ? turning_angle(side[v], cosine[v], 1) : angle[v];
      });
    for_blocks(width, [&, moment = s.moment + begin, rest = s.rest_angle + begin](int v) {
      moment[v] = stiffness * (angle[v] - rest[v]) * inverse_root(edge_square[v]);
    });
  }
}

/// Forces of the triangles on their corners.
template <bool bends>
[[gnu::noinline]] void push_corners(const Surface& s, const ShapeStiffness& k) {
  const double sixth_pressure = (1.0 / 6) * s.pressure, half_stretch = 0.5 * k.facet,
               half_tension = 0.5 * k.tension;
  for (int b = 0; b < s.mesh->facet_blocks; ++b) {
    const double* const block = s.block(b);
    const EightVectors d1 = vectors(block, row::edge_1), d2 = vectors(block, row::edge_2),
                       n = vectors(block, row::normal), cot = vectors(block, row::cotangent);
    const Eight twice_area = load<Eight>(block + row::twice_area * width),
                beyond_rest = 0.5 * twice_area - load<Eight>(s.rest_area + b * width),
                pull = half_stretch * beyond_rest + half_tension;
    const EightVectors q[3] = {(d1 + d2) * (-(pull * cot[0])), d1 * (pull * cot[1]), d2 * (pull * cot[2])};
    Eight out[3];
    for (Eight& corner : out) corner = sixth_pressure * twice_area;
    if constexpr (bends) {
      const Place* const hinge = s.mesh->corner_hinge.data() + b * 3 * width;
      const Eight m0 = gathered(s.moment, hinge), m1 = gathered(s.moment, hinge + width),
                  m2 = gathered(s.moment, hinge + 2 * width);
      const Eight by_0 = cot[0] * (m2 - m1), by_1 = cot[1] * (m0 - m2), by_2 = cot[2] * (m1 - m0);
      out[0] += by_2 - by_1;
      out[1] += by_0 - by_2;
      out[2] += by_1 - by_0;
    }
    for (int c = 0; c < 3; ++c)
      store_points(q[(c + 2) % 3] - q[(c + 1) % 3] - n * out[c], s.corner_force + (3 * b + c) * 4 * width);
  }
}

/// Adds up the forces of the corners at each site; with a virial, forces times where they act.
template <Detail detail>
[[gnu::noinline]] void add_forces(const Surface& s, Vec3* force, Mat<3>& virial) {
  const Triangulation& mesh = *s.mesh;
  Four by_force[3]{};
  for (int i = 0; i < mesh.sites; ++i) {
    Four sum{}, more{};
    for (std::int32_t c = mesh.site_begin[i]; c < mesh.site_begin[i + 1]; c += 2) {
      sum += load<Four>(s.corner_force + mesh.site_corner[c]);
      more += load<Four>(s.corner_force + mesh.site_corner[c + 1]);
    }
    sum += more;
    for (int d = 0; d < 3; ++d) force[i][d] += sum[d];
    if constexpr (detail == Detail::energies)
      for (int d = 0; d < 3; ++d) by_force[d] += sum[d] * load<Four>(s.position + 4 * i);
  }
  for (int c = 0; c < 3; ++c)
    for (int d = 0; d < 3; ++d) virial[c][d] += by_force[c][d];
}

double stored_energy(const Surface& s, const ShapeStiffness& k) {
  const Triangulation& mesh = *s.mesh;
  LaneSum sum;
  for (int b = 0; b < mesh.facet_blocks; ++b) {
    const Eight area = 0.5 * load<Eight>(s.block(b) + row::twice_area * width),
                beyond_rest = area - load<Eight>(s.rest_area + b * width);
    store(0.5 * k.facet * beyond_rest * beyond_rest + k.tension * area, s.part + b * width);
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
