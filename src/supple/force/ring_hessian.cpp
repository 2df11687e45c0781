#include "supple/force/ring_hessian.hpp"

#include <algorithm>
#include <cmath>

#include "supple/geometry/facet.hpp"
#include "supple/geometry/hinge.hpp"

namespace supple {

namespace {

/// The lower blocks of a ring of n vertices: all in rows, or of each vertex those of itself and of the two
/// before it round the ring.
class RingBlocks {
 public:
  static constexpr int near = 2,
                       least_sparse =
                           2 * near + 1;  ///< with fewer vertices a pair would be near on both sides

  enum class Pairs { all, near };

  RingBlocks(int first, int n, Pairs pairs, HessianBlocks<2>& blocks)
      : n_(n), sparse_(pairs == Pairs::near), begin_(blocks.size()), blocks_(blocks) {
    for (int i = 0; i < n; ++i) {
      if (!sparse_)
        for (int j = 0; j <= i; ++j) blocks.push_back({first + i, first + j, {}});
      else
        for (int back = near; back >= 0; --back) {
          const int j = i >= back ? i - back : i - back + n;
          blocks.push_back({first + std::max(i, j), first + std::min(i, j), {}});
        }
    }
  }
  Mat2& at(int i, int j) {
    if (!sparse_) return blocks_[begin_ + static_cast<std::size_t>(i * (i + 1) / 2 + j)].h;
    const int back = i - j;
    const int place = back <= near ? (near + 1) * (i + 1) - 1 - back : (near + 1) * (j + 1) - 1 - n_ + back;
    return blocks_[begin_ + static_cast<std::size_t>(place)].h;
  }

  /// Adds d2U/(dx_i dx_j) = m where the block is a lower one.
  void add(int i, int j, double sign, const Mat2& m) {
    if (i < j) return;
    Mat2& h = at(i, j);
    for (int c = 0; c < 2; ++c)
      for (int d = 0; d < 2; ++d) h[c][d] += sign * m[c][d];
  }
  /// Adds d2U/(de_i de_j) = m of edges e_i = x_(i+1) - x_i.
  void add_edges(int i, int j, const Mat2& m) {
    const int i1 = i + 1 < n_ ? i + 1 : 0, j1 = j + 1 < n_ ? j + 1 : 0;
    add(i1, j1, 1, m);
    add(i1, j, -1, m);
    add(i, j1, -1, m);
    add(i, j, 1, m);
  }

 private:
  int n_;
  bool sparse_;
  std::size_t begin_;
  HessianBlocks<2>& blocks_;
};

struct EdgeNumbers {
  Vec2 e, unit, turn;         ///< vector; over its length; slope of its direction angle, turned_left(e)/l^2
  double length, moment = 0;  ///< moment dU/d(theta) at the vertex that it leaves
};

/// Stretching and tension, and bending by the angles at both ends.
void add_edge_energies(const ShapeStiffness& k, const double* rest_length,
                       const std::vector<EdgeNumbers>& edges, RingBlocks& ring) {
  const int n = static_cast<int>(edges.size());
  for (int i = 0; i < n; ++i) {
    const EdgeNumbers& edge = edges[i];
    const EdgeNumbers& before = edges[i > 0 ? i - 1 : n - 1];
    const EdgeNumbers& after = edges[i + 1 < n ? i + 1 : 0];
    const double pull = (k.facet * (edge.length - rest_length[i]) + k.tension) / edge.length;
    Mat2 m;
    m.add_outer(k.facet - pull, edge.unit, edge.unit);
    m[0][0] += pull;
    m[1][1] += pull;
    if (k.hinge != 0) {
      // The angle of e turns by turn.de, and turn by J (1 - 2 u u^T) de / l^2.
      m.add_outer(2 * k.hinge, edge.turn, edge.turn);
      const double moment = (edge.moment - after.moment) / (edge.length * edge.length);
      const double xx = edge.unit[0] * edge.unit[0], xy = edge.unit[0] * edge.unit[1],
                   yy = edge.unit[1] * edge.unit[1];
      m[0][0] += moment * 2 * xy;
      m[0][1] += moment * (2 * yy - 1);
      m[1][0] += moment * (1 - 2 * xx);
      m[1][1] -= moment * 2 * xy;
      Mat2 cross;
      cross.add_outer(-k.hinge, before.turn, edge.turn);
      const int p = i > 0 ? i - 1 : n - 1;
      ring.add_edges(p, i, cross);
      ring.add_edges(i, p, {{{cross[0][0], cross[1][0]}, {cross[0][1], cross[1][1]}}});
    }
    ring.add_edges(i, i, m);
  }
}

/// Area of a ring, and its slope by each vertex.
struct AreaNumbers {
  double area = 0;
  std::vector<Vec2> slope;
};

AreaNumbers measure_area(const std::vector<EdgeNumbers>& edges) {
  const int n = static_cast<int>(edges.size());
  AreaNumbers out{0, std::vector<Vec2>(edges.size())};
  Vec2 from_first{};
  for (int i = 0; i < n; ++i) {
    const Vec2 across = edges[i].e + edges[i > 0 ? i - 1 : n - 1].e;
    out.slope[i] = {0.5 * across[1], -0.5 * across[0]};
    out.area += 0.5 * cross(from_first, edges[i].e);
    from_first += edges[i].e;
  }
  return out;
}

/// k_a (a - a0) d2a/dx2.
void add_pressure(double k, double beyond_rest, int n, RingBlocks& ring) {
  const double half = 0.5 * k * beyond_rest;
  const Mat2 next{{{0, -half}, {half, 0}}};  // by x_(i+1) and x_i
  for (int i = 0; i < n; ++i) {
    const int after = i + 1 < n ? i + 1 : 0;
    ring.add(after, i, 1, next);
    ring.add(i, after, -1, next);
  }
}

/// Whether a ring keeps its shape without its area: corners resist, and edges resist a swelling more than the
/// area does. Second derivatives by the logarithm of the size: 4 k_a a0^2 of the area, k_l sum l0^2 of the
/// edges.
bool stiff_without_area(const ShapeStiffness& k, double rest_area, const double* rest_length, int n) {
  double edges = 0;
  for (int i = 0; i < n; ++i) edges += k.facet * rest_length[i] * rest_length[i];
  return k.hinge > 0 && 4 * k.volume * rest_area * rest_area <= edges;
}

}  // namespace

void add_ring_hessian(const System<2>& system, int b, HessianBlocks<2>& blocks, HessianKind kind,
                      OuterProducts<2>* products) {
  const Topology<2>& t = system.topology;
  const int first = t.begin[b], facet = t.facet_begin[b], n = t.facet_begin[b + 1] - facet;
  if (n == 0) return;  // a disc
  const ShapeStiffness& k = system.shape.stiffness[b];
  if (k.volume == 0 && k.facet == 0 && k.hinge == 0 && k.tension == 0) return;  // rigid
  std::vector<EdgeNumbers> edges(static_cast<std::size_t>(n));
  const Vec2* x = &system.state.position[first];
  for (int i = 0; i < n; ++i) {
    const Vec2 e = x[i + 1 < n ? i + 1 : 0] - x[i];
    const double length = norm(e);
    edges[i] = {e, (1 / length) * e, (1 / (length * length)) * turned_left(e), length};
  }
  if (k.hinge != 0)
    for (int i = 0; i < n; ++i) {
      const Vec2 corner[3] = {x[i > 0 ? i - 1 : n - 1], x[i], x[i + 1 < n ? i + 1 : 0]};
      edges[i].moment = k.hinge * (hinge_angle(corner) - system.shape.rest_hinge[t.hinge_begin[b] + i]);
    }
  const double* rest_length = &system.shape.rest_facet[facet];
  const double rest_area = system.shape.rest_volume[b];
  using Pairs = RingBlocks::Pairs;
  const bool left_out = kind == HessianKind::sparse && stiff_without_area(k, rest_area, rest_length, n);
  const Pairs pairs = n >= RingBlocks::least_sparse && (left_out || products) ? Pairs::near : Pairs::all;
  RingBlocks ring(first, n, pairs, blocks);
  add_edge_energies(k, rest_length, edges, ring);
  if (k.volume == 0) return;
  AreaNumbers area = measure_area(edges);
  for (int i = 0; i < n && pairs == Pairs::all; ++i)
    for (int j = 0; j <= i; ++j) ring.at(i, j).add_outer(k.volume, area.slope[i], area.slope[j]);
  add_pressure(k.volume, area.area - rest_area, n, ring);
  if (pairs == Pairs::near && products) products->push_back({k.volume, first, std::move(area.slope)});
}

}  // namespace supple
