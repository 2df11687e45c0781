#include "supple/force/polygon_shape.hpp"

#include <algorithm>
#include <cmath>

#include "supple/force/ring_hessian.hpp"
#include "supple/force/shape_terms.hpp"
#include "supple/geometry/turning_angle.hpp"

namespace supple {

namespace {

/// Vector instructions work on whole blocks: loops over a ring run on past its end, over numbers that nobody reads.
constexpr int block = 4;
constexpr int padded(int n) { return (n + block - 1) / block * block; }

/// Numbers of one ring of n vertices. Edge e joins vertices e - 1 and e; edges 0 and n are the same one, so that no loop has to close
/// the ring; vertices are at v + 1, the last one again at 0. G = dU/d(edge vector).
struct Ring {
  int body, n;
  double area, pressure;
  double *x, *y, *e_x, *e_y, *length, *moment, *g_x, *g_y, *work, *rest_length, *rest_angle;
  static constexpr int arrays = 11;

  std::size_t size() const { return static_cast<std::size_t>(arrays) * (padded(n + 2) + block); }
  void place(double* at) {
    const int row = padded(n + 2) + block;
    for (double** array : {&x, &y, &e_x, &e_y, &length, &moment, &g_x, &g_y, &work, &rest_length, &rest_angle})
      *array = at, at += row;
  }
};

/// Some rings that go through each pass together: what one pass stores has left the processor's store buffer when the next one reads
/// it in other pieces. With one small ring at a time that wait is half of all time.
struct Group {
  static constexpr int sites = 256;
  std::vector<Ring> rings;
  std::vector<double> numbers;

  void clear() { rings.clear(); }
  void place() {
    std::size_t size = 0;
    for (const Ring& r : rings) size += r.size();
    if (numbers.size() < size) numbers.assign(size, 1.0);
    double* at = numbers.data();
    for (Ring& r : rings) r.place(at), at += r.size();
  }
};

struct ShapeSum {
  double energy = 0;
  Mat2 virial;
  ShapeSum& operator+=(const ShapeSum& b) {
    energy += b.energy;
    virial += b.virial;
    return *this;
  }
};

/// Sum of n numbers in four chains, for the processor to overlap.
double sum_of(const double* v, int n) {
  double s[4] = {};
  int i = 0;
  for (; i + 4 <= n; i += 4)
    for (int k = 0; k < 4; ++k) s[k] += v[i + k];
  for (; i < n; ++i) s[0] += v[i];
  return (s[0] + s[1]) + (s[2] + s[3]);
}

// The loops below are functions of plain arrays that do not overlap, or g++ 12 leaves them scalar.
using In = const double* __restrict;
using Out = double* __restrict;

[[gnu::noinline]] void edges_loop(int count, In x, In y, Out e_x, Out e_y, Out length, Out cross) {
  for (int e = 0; e < count; ++e) {
    const double dx = x[e + 1] - x[e], dy = y[e + 1] - y[e];
    e_x[e] = dx;
    e_y[e] = dy;
    length[e] = std::sqrt(dx * dx + dy * dy);
    cross[e] = x[e] * y[e + 1] - y[e] * x[e + 1];
  }
}

/// moment[v] = k (theta_v - rest[v]) between edges v and v + 1.
[[gnu::noinline]] void moments_loop(int count, double k, In e_x, In e_y, In length, In rest, Out moment) {
  for (int v = 0; v < count; ++v) {
    const double sine = e_x[v] * e_y[v + 1] - e_y[v] * e_x[v + 1];
    const double cosine = e_x[v] * e_x[v + 1] + e_y[v] * e_y[v + 1];
    moment[v] = k * (turning_angle(sine, cosine, length[v] * length[v + 1]) - rest[v]);
  }
}

[[gnu::noinline]] void slopes_loop(int count, double stretch, double tension, double turns, In e_x, In e_y, In length, In moment,
                                   In rest, Out g_x, Out g_y) {
  for (int e = 0; e < count; ++e) {
    const double per_length = 1 / length[e];
    const double pull = stretch * (1 - rest[e] * per_length) + tension * per_length;
    const double turn = turns * (moment[e] - moment[e + 1]) * per_length * per_length;
    g_x[e] = pull * e_x[e] - turn * e_y[e];
    g_y[e] = pull * e_y[e] + turn * e_x[e];
  }
}

/// Edge vectors and lengths; returns the enclosed area.
double measure_edges(const Vec2* position, const Ring& r) {
  const Vec2 origin = position[0];
  for (int v = 0; v < r.n; ++v) {
    r.x[v + 1] = position[v][0] - origin[0];
    r.y[v + 1] = position[v][1] - origin[1];
  }
  r.x[0] = r.x[r.n];
  r.y[0] = r.y[r.n];
  edges_loop(padded(r.n), r.x, r.y, r.e_x, r.e_y, r.length, r.work);
  r.e_x[r.n] = r.e_x[0];
  r.e_y[r.n] = r.e_y[0];
  r.length[r.n] = r.length[0];
  return 0.5 * sum_of(r.work, r.n);
}

/// Bending moments dU/d(theta) at the corners, moment[v + 1] at vertex v and moment[0] at the last one.
void bend(double k, const double* rest, const Ring& r) {
  std::copy(rest, rest + r.n, r.rest_angle);
  moments_loop(padded(r.n), k, r.e_x, r.e_y, r.length, r.rest_angle, r.moment + 1);
  r.moment[0] = r.moment[r.n];
  r.moment[r.n + 1] = r.moment[1];
}

/// Slopes G of edges 0..n by stretching, tension and the moments at both ends. rest[v] belongs to the edge that leaves vertex v.
void slope_edges(const ShapeStiffness& k, const double* rest, const Ring& r) {
  std::copy(rest, rest + r.n, r.rest_length + 1);
  r.rest_length[0] = r.rest_length[r.n];
  slopes_loop(padded(r.n + 1), k.facet, k.tension, k.hinge != 0, r.e_x, r.e_y, r.length, r.moment, r.rest_length, r.g_x, r.g_y);
}

void add_forces(const Ring& r, Vec2* force) {
  const double half = 0.5 * r.pressure;
  for (int v = 0; v < r.n; ++v) {
    force[v][0] -= r.g_x[v] - r.g_x[v + 1] + half * (r.e_y[v] + r.e_y[v + 1]);
    force[v][1] -= r.g_y[v] - r.g_y[v + 1] - half * (r.e_x[v] + r.e_x[v + 1]);
  }
}

double bending_energy(double k, const Ring& r) {
  double sum = 0;
  for (int v = 0; v < r.n; ++v) sum += r.moment[v + 1] * r.moment[v + 1];
  return 0.5 / k * sum;
}

void add_energies(const ShapeStiffness& k, const Ring& r, double bending, ShapeSum& sum) {
  double energy = bending;
  for (int e = 0; e < r.n; ++e) {
    const double stretch = r.length[e] - r.rest_length[e];
    energy += 0.5 * k.facet * stretch * stretch + k.tension * r.length[e];
    sum.virial.add_outer(-1, {r.g_x[e], r.g_y[e]}, {r.e_x[e], r.e_y[e]});
  }
  sum.energy += energy + (k.volume > 0 ? 0.5 * r.pressure * r.pressure / k.volume : 0);
  for (int d = 0; d < 2; ++d) sum.virial[d][d] -= r.pressure * r.area;
}

void add_group(const System<2>& system, bool energies, Group& group, Evaluation<2>& out, ShapeSum& sum) {
  const Topology<2>& t = system.topology;
  const Shape& shape = system.shape;
  group.place();
  for (Ring& r : group.rings) {
    r.area = measure_edges(&system.state.position[t.begin[r.body]], r);
    r.pressure = shape.stiffness[r.body].volume * (r.area - shape.rest_volume[r.body]);
  }
  for (const Ring& r : group.rings)
    if (const double k = shape.stiffness[r.body].hinge; k != 0) bend(k, &shape.rest_hinge[t.hinge_begin[r.body]], r);
  for (const Ring& r : group.rings) slope_edges(shape.stiffness[r.body], &shape.rest_facet[t.facet_begin[r.body]], r);
  for (const Ring& r : group.rings) add_forces(r, &out.force[t.begin[r.body]]);
  if (!energies) return;
  for (const Ring& r : group.rings) {
    const ShapeStiffness& k = shape.stiffness[r.body];
    add_energies(k, r, k.hinge != 0 ? bending_energy(k.hinge, r) : 0, sum);
  }
}

}  // namespace

double PolygonShape::energy(const System<2>& system) const {
  double sum = 0;
  for (const auto& [name, energy] : shape_terms(system).energies(system)) sum += energy;
  return sum;
}

void PolygonShape::evaluate(const System<2>& system, Detail detail, Evaluation<2>& out) const {
  if (system.shape.empty()) return;
  const bool energies = detail == Detail::energies;
  const ShapeSum total = sum_chunks<ShapeSum>(
      static_cast<std::int64_t>(system.shape.stiffness.size()), [&](std::int64_t begin, std::int64_t end) {
        static thread_local Group group;
        ShapeSum sum;
        int sites = 0;
        group.clear();
        for (auto b = static_cast<int>(begin); b < end; ++b) {
          const Topology<2>& t = system.topology;
          const int n = t.facet_begin[b + 1] - t.facet_begin[b];
          if (n > 0) {
            Ring& r = group.rings.emplace_back();
            r.body = b;
            r.n = n;
          }
          if ((sites += n) < Group::sites && b + 1 < end) continue;
          add_group(system, energies, group, out, sum);
          group.clear();
          sites = 0;
        }
        return sum;
      });
  if (!energies) return;
  out.energy.terms += total.energy;
  out.virial += total.virial;
}

void PolygonShape::add_hessian(const System<2>& system, HessianBlocks<2>& blocks) const {
  for (std::size_t b = 0; b < system.shape.stiffness.size(); ++b) add_ring_hessian(system, static_cast<int>(b), blocks);
}

void PolygonShape::add_sparse_hessian(const System<2>& system, HessianBlocks<2>& blocks) const {
  for (std::size_t b = 0; b < system.shape.stiffness.size(); ++b)
    add_ring_hessian(system, static_cast<int>(b), blocks, HessianKind::sparse);
}

}  // namespace supple
