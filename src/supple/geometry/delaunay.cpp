#include "supple/geometry/delaunay.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "supple/core/error.hpp"

namespace supple {

namespace {

/// Coordinates have 24 bits with their sign: the largest determinant below, of 4 rows (x, y, z, x^2 + y^2 +
/// z^2) of differences, then has less than 127.
__extension__ using Wide = __int128;
template <int Dim>
using Point = std::array<std::int64_t, Dim>;

Wide determinant(const Point<2>& a, const Point<2>& b) {
  return static_cast<Wide>(a[0]) * b[1] - static_cast<Wide>(a[1]) * b[0];
}
Wide determinant(const Point<3>& a, const Point<3>& b, const Point<3>& c) {
  return c[0] * determinant(Point<2>{a[1], a[2]}, {b[1], b[2]}) +
         c[1] * determinant(Point<2>{a[2], a[0]}, {b[2], b[0]}) +
         c[2] * determinant(Point<2>{a[0], a[1]}, {b[0], b[1]});
}
int sign(Wide x) { return (x > 0) - (x < 0); }

template <std::size_t N>
std::array<std::int64_t, N> difference(const std::array<std::int64_t, N>& a,
                                       const std::array<std::int64_t, N>& b) {
  std::array<std::int64_t, N> d;
  for (std::size_t k = 0; k < N; ++k) d[k] = a[k] - b[k];
  return d;
}

template <int Dim>
using Corners = std::array<Point<Dim>, Dim + 1>;

/// Sign of the area (volume) of a simplex.
int orientation(const Corners<2>& x) {
  return sign(determinant(difference(x[0], x[2]), difference(x[1], x[2])));
}
int orientation(const Corners<3>& x) {
  return sign(determinant(difference(x[0], x[3]), difference(x[1], x[3]), difference(x[2], x[3])));
}

/// 1 where p is within the circle (sphere) through the corners of a simplex of positive area (volume), -1
/// outside, 0 on it: the sign of the determinant of their differences d from p, with their squares as the
/// last column.
template <int Dim>
int side_of_sphere(const Corners<Dim>& x, const Point<Dim>& p) {
  Corners<Dim> d;
  Wide square[Dim + 1];
  for (int k = 0; k <= Dim; ++k) {
    d[k] = difference(x[k], p);
    square[k] = 0;
    for (const std::int64_t c : d[k]) square[k] += static_cast<Wide>(c) * c;
  }
  if constexpr (Dim == 2)
    return sign(square[0] * determinant(d[1], d[2]) - square[1] * determinant(d[0], d[2]) +
                square[2] * determinant(d[0], d[1]));
  else
    return sign(square[1] * determinant(d[0], d[2], d[3]) - square[0] * determinant(d[1], d[2], d[3]) +
                square[3] * determinant(d[0], d[1], d[2]) - square[2] * determinant(d[0], d[1], d[3]));
}

/// A triangulation that grows. Beyond each facet of its hull lies a simplex with the corner `outside`, so
/// that all of space is filled, and a point outside of the hull is added like any other.
template <int Dim>
class Growing {
 public:
  explicit Growing(std::span<const Vec<Dim>> points) {
    round_points(points);
    std::array<std::int32_t, Dim + 1> first = first_simplex();
    begin(first);
    std::sort(first.begin(), first.end());
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(point_.size()); ++i)
      if (!std::binary_search(first.begin(), first.end(), i)) add(i);
  }

  DelaunayMesh<Dim> mesh() const {
    DelaunayMesh<Dim> mesh;
    for (const Cell& cell : cells_) {
      if (cell.corner[0] == nowhere) continue;
      const int k = place_of_outside(cell);
      if (k > Dim) {
        mesh.simplex.push_back(cell.corner);
        continue;
      }
      std::array<std::int32_t, Dim> facet;
      for (int j = 0; j < Dim; ++j) facet[j] = cell.corner[(k + 1 + j) % (Dim + 1)];
      // With the outer side in the place of its last corner the simplex is positive, if a cycle of its
      // corners leaves the sign, as it does of three, or if k is odd; the facet as seen from outside is
      // turned the other way round.
      if (Dim == 2 || k % 2 == 1) std::swap(facet[0], facet[1]);
      mesh.hull.push_back(facet);
    }
    return mesh;
  }

 private:
  static constexpr std::int32_t outside = -1, nowhere = -2;
  struct Cell {
    std::array<std::int32_t, Dim + 1> corner, neighbor;  ///< neighbor[k] lies across from corner[k]
  };
  /// A facet of the cavity that a new point makes: what is beyond it, and the new simplex over it.
  struct Rim {
    std::array<std::int32_t, Dim - 1> ridge;  ///< ascending
    std::int32_t cell;
    int place;
  };

  static int place_of_outside(const Cell& cell) {
    return static_cast<int>(std::find(cell.corner.begin(), cell.corner.end(), outside) - cell.corner.begin());
  }

  void round_points(std::span<const Vec<Dim>> points) {
    for (std::size_t i = 0; i < points.size(); ++i)
      for (int d = 0; d < Dim; ++d)
        if (!(std::abs(points[i][d]) < 1e300))
          throw input_error(
              fmt::format("a triangulation of points of which {} has the coordinate {}", i, points[i][d]),
              "this is no place");
    Vec<Dim> low, high;
    for (int d = 0; d < Dim && !points.empty(); ++d) {
      const auto by_coordinate = [d](const Vec<Dim>& a, const Vec<Dim>& b) { return a[d] < b[d]; };
      const auto [least, most] = std::minmax_element(points.begin(), points.end(), by_coordinate);
      low[d] = (*least)[d];
      high[d] = (*most)[d];
    }
    double side = 0;
    for (int d = 0; d < Dim; ++d) side = std::max(side, high[d] - low[d]);
    const double scale = side > 0 ? 0x1p23 / side : 0;
    for (const Vec<Dim>& x : points) {
      Point<Dim> p;
      for (int d = 0; d < Dim; ++d)
        p[d] = static_cast<std::int64_t>(std::floor(scale * (x[d] - low[d]) + 0.5));
      point_.push_back(p);
    }
  }

  Corners<Dim> corners(const Cell& cell) const {
    Corners<Dim> x;
    for (int k = 0; k <= Dim; ++k)
      if (cell.corner[k] != outside) x[k] = point_[static_cast<std::size_t>(cell.corner[k])];
    return x;
  }
  /// Orientation of the simplex with p in the place of its corner k.
  int orientation_with(const Cell& cell, int k, const Point<Dim>& p) const {
    Corners<Dim> x = corners(cell);
    x[k] = p;
    return orientation(x);
  }

  /// Points that no line (plane) holds, the first such ones: the next point is taken wherever it adds a
  /// dimension to those before.
  std::array<std::int32_t, Dim + 1> first_simplex() const {
    const auto n = static_cast<std::int32_t>(point_.size());
    const auto spans = [&](const Point<Dim>& a, const Point<Dim>& b) {  // a and b are no multiples
      for (int i = 0; i < Dim; ++i)
        for (int j = 0; j < i; ++j)
          if (determinant(Point<2>{a[i], a[j]}, {b[i], b[j]}) != 0) return true;
      return false;
    };
    std::array<std::int32_t, Dim + 1> first{};
    int found = 1;
    for (std::int32_t i = 1; i < n && found <= Dim; ++i) {
      const Point<Dim> d = difference(point_[i], point_[0]);
      first[found] = i;
      if (found == 1    ? d != Point<Dim>{}
          : found < Dim ? spans(d, difference(point_[first[1]], point_[0]))
                        : orientation_with({first, {}}, Dim, point_[i]) != 0)
        ++found;
    }
    if (found <= Dim)
      throw input_error(fmt::format("a triangulation of {} points", n),
                        Dim == 2 ? "there are less than three, or they lie on one line"
                                 : "there are less than four, or they lie in one plane");
    return first;
  }

  void begin(std::array<std::int32_t, Dim + 1>& first) {
    if (orientation(corners({first, {}})) < 0) std::swap(first[0], first[1]);
    cells_.push_back({first, {}});
    std::vector<Rim> rims;
    for (int k = 0; k <= Dim; ++k) {
      Cell beyond{first, {}};
      beyond.corner[k] = outside;
      beyond.neighbor[k] = 0;
      // Seen from beyond, the facet is turned the other way round.
      const int i = (k + 1) % (Dim + 1), j = (k + 2) % (Dim + 1);
      std::swap(beyond.corner[i], beyond.corner[j]);
      cells_[0].neighbor[k] = k + 1;
      add_rims(beyond, k + 1, k, rims);
      cells_.push_back(beyond);
    }
    join(rims);
  }

  /// Whether p is within the circle (sphere) through the corners; if one of them is `outside`, beyond the
  /// facet of the others, or in its line (plane) and within their circle.
  bool in_conflict(const Cell& cell, const Point<Dim>& p) const {
    const int k = place_of_outside(cell);
    if (k > Dim) return side_of_sphere<Dim>(corners(cell), p) > 0;
    const int side = orientation_with(cell, k, p);
    if (side != 0) return side > 0;
    return side_of_sphere<Dim>(corners(cells_[cell.neighbor[k]]), p) > 0;
  }

  /// A simplex in conflict with p: walks toward p from the one found last, across facets that have p beyond
  /// them. In a Delaunay triangulation such a walk ends [Edelsbrunner 1990].
  std::int32_t locate(const Point<Dim>& p) const {
    std::int32_t at = last_;
    if (const int k = place_of_outside(cells_[at]); k <= Dim) at = cells_[at].neighbor[k];
    for (bool moved = true; moved;) {
      moved = false;
      for (int k = 0; k <= Dim && !moved; ++k)
        if (orientation_with(cells_[at], k, p) < 0) {
          at = cells_[at].neighbor[k];
          if (place_of_outside(cells_[at]) <= Dim) return at;
          moved = true;
        }
    }
    return at;
  }

  void add(std::int32_t i) {
    const Point<Dim>& p = point_[static_cast<std::size_t>(i)];
    const std::int32_t start = locate(p);
    if (!in_conflict(cells_[start], p)) {
      for (const std::int32_t corner : cells_[start].corner)
        if (corner >= 0 && point_[static_cast<std::size_t>(corner)] == p)
          throw input_error(
              fmt::format("a triangulation of points of which {} and {} are the same", corner, i));
    }
    std::vector<std::int32_t> cavity{start};
    std::vector<Rim> rims;
    mark_.resize(cells_.size(), 0);
    ++turn_;
    mark_[start] = turn_;
    std::vector<std::pair<std::int32_t, int>> border;
    for (std::size_t at = 0; at < cavity.size(); ++at)
      for (int k = 0; k <= Dim; ++k) {
        const std::int32_t next = cells_[cavity[at]].neighbor[k];
        if (mark_[next] == turn_) continue;
        if (in_conflict(cells_[next], p)) {
          mark_[next] = turn_;
          cavity.push_back(next);
        } else {
          border.emplace_back(cavity[at], k);
        }
      }
    for (const auto& [old, k] : border) {
      const auto number = static_cast<std::int32_t>(cells_.size());
      const std::int32_t beyond = cells_[old].neighbor[k];
      Cell made = cells_[old];
      made.corner[k] = i;
      for (int j = 0; j <= Dim; ++j)
        if (cells_[beyond].neighbor[j] == old) cells_[beyond].neighbor[j] = number;
      add_rims(made, number, k, rims);
      cells_.push_back(made);
    }
    for (const std::int32_t old : cavity) cells_[old].corner[0] = nowhere;
    join(rims);
    last_ = static_cast<std::int32_t>(cells_.size()) - 1;
  }

  /// The ridges of a new simplex with its apex in place k, in each of which it meets another new one.
  static void add_rims(const Cell& cell, std::int32_t number, int k, std::vector<Rim>& rims) {
    for (int j = 0; j <= Dim; ++j) {
      if (j == k) continue;
      Rim rim{{}, number, j};
      int n = 0;
      for (int l = 0; l <= Dim; ++l)
        if (l != j && l != k) rim.ridge[n++] = cell.corner[l];
      std::sort(rim.ridge.begin(), rim.ridge.end());
      rims.push_back(rim);
    }
  }

  void join(std::vector<Rim>& rims) {
    std::sort(rims.begin(), rims.end(), [](const Rim& a, const Rim& b) {
      return std::tie(a.ridge, a.cell) < std::tie(b.ridge, b.cell);
    });
    for (std::size_t r = 0; r + 1 < rims.size(); r += 2) {
      cells_[rims[r].cell].neighbor[rims[r].place] = rims[r + 1].cell;
      cells_[rims[r + 1].cell].neighbor[rims[r + 1].place] = rims[r].cell;
    }
  }

  std::vector<Point<Dim>> point_;
  std::vector<Cell> cells_;
  std::vector<std::int32_t> mark_;
  std::int32_t turn_ = 0, last_ = 0;
};

}  // namespace

template <int Dim>
DelaunayMesh<Dim> delaunay(std::span<const Vec<Dim>> points) {
  return Growing<Dim>(points).mesh();
}

template DelaunayMesh<2> delaunay<2>(std::span<const Vec2>);
template DelaunayMesh<3> delaunay<3>(std::span<const Vec3>);

}  // namespace supple
