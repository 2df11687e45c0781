// Points are thrown on a raster whose cells are known to be covered, to be empty, or to hold a part of an
// outline; only in the last kind are bodies looked at. Nothing here is shared with the formulas but the
// layout of the bodies.
#include <algorithm>
#include <cmath>

#include "supple/core/error.hpp"
#include "supple/core/parallel.hpp"
#include "supple/core/random.hpp"
#include "supple/core/require.hpp"
#include "supple/geometry/closest_point.hpp"
#include "supple/geometry/inside.hpp"
#include "supple/geometry/polygon.hpp"
#include "supple/observe/packing_fraction.hpp"

namespace supple {
namespace {

/// Whether the body covers x: the definition of its outline.
bool covered_by(const BodyShape& body, Outline outline, const Vec2& x) {
  const bool smooth = outline == Outline::smooth && !body.is_disc();
  for (int k = 0; k < body.size(); ++k) {
    const Vec2 r = x - body.ring[k];
    if (smooth ? body.distance_to_edge(k, x) < body.radius[k] : dot(r, r) < body.radius[k] * body.radius[k])
      return true;
  }
  return !body.is_disc() && is_inside(x, body.ring);
}

/// The distance to the outline at least: positive inside, negative outside.
double depth_in(const BodyShape& body, Outline outline, const Vec2& x) {
  double from_disc = INFINITY, from_edge = INFINITY;
  for (int k = 0; k < body.size(); ++k) {
    from_disc = std::min(from_disc, norm(x - body.ring[k]) - body.radius[k]);
    if (!body.is_disc()) from_edge = std::min(from_edge, body.distance_to_edge(k, x));
  }
  if (body.is_disc()) return -from_disc;
  const bool inside = is_inside(x, body.ring);
  if (outline == Outline::smooth) return body.radius[0] + (inside ? from_edge : -from_edge);
  return std::max(-from_disc, inside ? from_edge : -from_edge);
}

/// The distance to the nearest triangle [length].
double distance_to_surface(const BodySurface& body, const Vec3& x) {
  double least = INFINITY;
  for (const auto& face : body.face) {
    const auto [a, b, c] = body.corners(face);
    least = std::min(least, norm(closest_on_triangle(x, {a, b, c}).from));
  }
  return least;
}

bool covered_by(const BodySurface& body, Outline outline, const Vec3& x) {
  const bool smooth = outline == Outline::smooth && !body.is_sphere();
  for (int k = 0; k < body.size() && !smooth; ++k)
    if (norm(x - body.vertex[k]) < body.radius[k]) return true;
  if (smooth && distance_to_surface(body, x) < body.radius[0]) return true;
  return is_inside(x, body.vertex, body.face);
}

double depth_in(const BodySurface& body, Outline outline, const Vec3& x) {
  double from_sphere = INFINITY;
  for (int k = 0; k < body.size(); ++k)
    from_sphere = std::min(from_sphere, norm(x - body.vertex[k]) - body.radius[k]);
  if (body.is_sphere()) return -from_sphere;
  const double distance = distance_to_surface(body, x);
  const double depth = is_inside(x, body.vertex, body.face) ? distance : -distance;
  return outline == Outline::smooth ? body.radius[0] + depth : std::max(-from_sphere, depth);
}

/// Equal cells over a region. A cell is covered, empty, or the number of a list of copies of bodies to look
/// at.
template <int Dim>
class Raster {
 public:
  Raster(std::span<const ShapeOf<Dim>> bodies, Outline outline, const Box<Dim>& box,
         const BoundsOf<Dim>& region, int level)
      : bodies_(bodies), outline_(outline), region_(region), side_(1 << level) {
    std::size_t cells = 1;
    for (int d = 0; d < Dim; ++d) {
      size_[d] = (region.high[d] - region.low[d]) / side_;
      cells *= static_cast<std::size_t>(side_);
    }
    kind_.resize(cells);
    cell_.resize(cells);
    begin_.push_back(0);
    fill({}, side_, images_in(region, bodies, box));
  }

  /// Whether the point at u, in units of the region, is covered.
  bool covers(const Vec<Dim>& u) const {
    Place at;
    Vec<Dim> x = region_.low;
    for (int d = 0; d < Dim; ++d) {
      at[d] = static_cast<int>(u[d] * side_);
      x[d] += u[d] * side_ * size_[d];
    }
    const std::size_t place = number_of(at);
    if (kind_[place] != Kind::unsure) return kind_[place] == Kind::covered;
    const std::int32_t cell = cell_[place];
    for (std::int32_t k = begin_[cell]; k < begin_[cell + 1]; ++k)
      if (covered_by(bodies_[list_[k].body], outline_, x - list_[k].shift)) return true;
    return false;
  }

 private:
  enum class Kind : std::uint8_t { empty, covered, unsure };
  using Place = std::array<int, Dim>;

  std::size_t number_of(const Place& at) const {
    std::size_t number = 0;
    for (int d = Dim - 1; d >= 0; --d) number = number * side_ + at[d];
    return number;
  }

  /// Classifies the block of `side` cells at this place, which only `near` can cover; divides it if unsure.
  void fill(const Place& at, int side, const std::vector<ImageOf<Dim>>& near) {
    Vec<Dim> half, middle = region_.low;
    for (int d = 0; d < Dim; ++d) {
      half[d] = 0.5 * side * size_[d];
      middle[d] += at[d] * size_[d] + half[d];
    }
    const double reach = (1 + 1e-9) * norm(half);
    std::vector<ImageOf<Dim>> unsure;
    for (const ImageOf<Dim>& image : near) {
      if (!image.bounds.meets({middle - 1.001 * half, middle + 1.001 * half})) continue;
      const double depth = depth_in(bodies_[image.body], outline_, middle - image.shift);
      if (depth >= reach) return mark(at, side, Kind::covered);
      if (depth > -reach) unsure.push_back(image);
    }
    if (unsure.empty()) return mark(at, side, Kind::empty);
    if (side == 1) {
      mark(at, 1, Kind::unsure);
      cell_[number_of(at)] = static_cast<std::int32_t>(begin_.size() - 1);
      list_.insert(list_.end(), unsure.begin(), unsure.end());
      begin_.push_back(static_cast<std::int32_t>(list_.size()));
      return;
    }
    for (int part = 0; part < 1 << Dim; ++part) {
      Place inner = at;
      for (int d = 0; d < Dim; ++d) inner[d] += (part >> d & 1) * side / 2;
      fill(inner, side / 2, unsure);
    }
  }
  void mark(const Place& at, int side, Kind kind) {
    const int layers = Dim == 3 ? side : 1;
    for (int layer = 0; layer < layers; ++layer)
      for (int row = 0; row < side; ++row) {
        Place first = at;
        first[1] += row;
        first[Dim - 1] += Dim == 3 ? layer : 0;
        std::fill_n(kind_.begin() + static_cast<std::ptrdiff_t>(number_of(first)), side, kind);
      }
  }

  std::span<const ShapeOf<Dim>> bodies_;
  Outline outline_;
  BoundsOf<Dim> region_;
  int side_;
  Vec<Dim> size_;
  std::vector<Kind> kind_;  ///< apart from cell_, to stay in the cache
  std::vector<std::int32_t> cell_, begin_;
  std::vector<ImageOf<Dim>> list_;
};

/// Number of halvings of the region: making a cell pays if several points fall on it, and all cells should
/// fit the cache.
template <int Dim>
int raster_level(std::int64_t points) {
  int level = Dim == 2 ? 4 : 2;
  while (level < 20 / Dim && (std::int64_t{1} << (Dim * (level + 1))) * 4 < points) ++level;
  return level;
}

template <int Dim>
MonteCarloFraction sample(const System<Dim>& system, Outline outline, std::int64_t points,
                          std::uint64_t seed) {
  require(points > 0, "points", static_cast<double>(points), "at least 1");
  const std::vector<ShapeOf<Dim>> bodies = body_shapes(system, outline);
  const BoundsOf<Dim> region = region_of<Dim>(bodies, system.box);
  const Raster<Dim> raster(bodies, outline, system.box, region, raster_level<Dim>(points));

  constexpr std::int64_t points_of_stream = 1024;
  const std::int64_t streams = (points + points_of_stream - 1) / points_of_stream;
  const std::int64_t hits = sum_chunks<std::int64_t>(streams, [&](std::int64_t begin, std::int64_t end) {
    std::int64_t count = 0;
    for (std::int64_t stream = begin; stream < end; ++stream) {
      RandomStream draw(seed, Purpose::area_sample, static_cast<std::uint64_t>(stream));
      const std::int64_t last = std::min(points, (stream + 1) * points_of_stream);
      for (std::int64_t p = stream * points_of_stream; p < last; ++p) {
        Vec<Dim> u;
        for (int d = 0; d < Dim; ++d) u[d] = draw.uniform();
        count += raster.covers(u);
      }
    }
    return count;
  });
  double sampled = 1 / system.box.volume();
  for (int d = 0; d < Dim; ++d) sampled *= region.high[d] - region.low[d];
  const double part = static_cast<double>(hits) / static_cast<double>(points);
  return {sampled * part, sampled * std::sqrt(part * (1 - part) / static_cast<double>(points)), points};
}

}  // namespace

MonteCarloFraction monte_carlo_fraction(const System<2>& system, Outline outline, std::int64_t points,
                                        std::uint64_t seed) {
  return sample(system, outline, points, seed);
}

MonteCarloFraction monte_carlo_fraction(const System<3>& system, Outline outline, std::int64_t points,
                                        std::uint64_t seed) {
  return sample(system, outline, points, seed);
}

}  // namespace supple
