// Points are thrown on a raster whose cells are known to be covered, to be empty, or to hold a part of an
// outline; only in the last kind are bodies looked at. Nothing here is shared with the formulas but the
// layout of the bodies.
#include <algorithm>
#include <cmath>

#include "supple/core/error.hpp"
#include "supple/core/parallel.hpp"
#include "supple/core/random.hpp"
#include "supple/core/require.hpp"
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

/// Square cells over a rectangle. A cell is covered, empty, or the number of a list of copies of bodies to
/// look at.
class Raster {
 public:
  Raster(std::span<const BodyShape> bodies, Outline outline, const Box<2>& box, const Bounds& region,
         int level)
      : bodies_(bodies),
        outline_(outline),
        region_(region),
        side_(1 << level),
        kind_(side_ * std::size_t(side_)),
        cell_(kind_.size()) {
    for (int d = 0; d < 2; ++d) {
      size_[d] = (region.high[d] - region.low[d]) / side_;
      per_size_[d] = 1 / size_[d];
    }
    begin_.push_back(0);
    fill(0, 0, side_, images_in(region, bodies, box));
  }

  /// Whether the point at u, in units of the region, is covered.
  bool covers(const Vec2& u) const {
    const int column = static_cast<int>(u[0] * side_), row = static_cast<int>(u[1] * side_);
    const std::size_t place = row * std::size_t(side_) + column;
    if (kind_[place] != Kind::unsure) return kind_[place] == Kind::covered;
    const std::int32_t cell = cell_[place];
    const Vec2 x = region_.low + Vec2{u[0] * side_ * size_[0], u[1] * side_ * size_[1]};
    for (std::int32_t k = begin_[cell]; k < begin_[cell + 1]; ++k)
      if (covered_by(bodies_[list_[k].body], outline_, x - list_[k].shift)) return true;
    return false;
  }

 private:
  enum class Kind : std::uint8_t { empty, covered, unsure };

  /// Classifies the square of `side` cells at (column, row), which only `near` can cover; divides it if
  /// unsure.
  void fill(int column, int row, int side, const std::vector<BodyImage>& near) {
    const Vec2 half{0.5 * side * size_[0], 0.5 * side * size_[1]};
    const Vec2 middle = region_.low + Vec2{column * size_[0], row * size_[1]} + half;
    const double reach = (1 + 1e-9) * norm(half);
    std::vector<BodyImage> unsure;
    for (const BodyImage& image : near) {
      if (!image.bounds.meets({middle - 1.001 * half, middle + 1.001 * half})) continue;
      const double depth = depth_in(bodies_[image.body], outline_, middle - image.shift);
      if (depth >= reach) return mark(column, row, side, Kind::covered);
      if (depth > -reach) unsure.push_back(image);
    }
    if (unsure.empty()) return mark(column, row, side, Kind::empty);
    if (side == 1) {
      mark(column, row, 1, Kind::unsure);
      cell_[row * std::size_t(side_) + column] = static_cast<std::int32_t>(begin_.size() - 1);
      list_.insert(list_.end(), unsure.begin(), unsure.end());
      begin_.push_back(static_cast<std::int32_t>(list_.size()));
      return;
    }
    for (int quarter = 0; quarter < 4; ++quarter)
      fill(column + quarter % 2 * side / 2, row + quarter / 2 * side / 2, side / 2, unsure);
  }
  void mark(int column, int row, int side, Kind kind) {
    for (int r = row; r < row + side; ++r)
      std::fill_n(kind_.begin() + static_cast<std::ptrdiff_t>(r * std::size_t(side_) + column), side, kind);
  }

  std::span<const BodyShape> bodies_;
  Outline outline_;
  Bounds region_;
  int side_;
  Vec2 size_, per_size_;
  std::vector<Kind> kind_;  ///< apart from cell_, to stay in the cache
  std::vector<std::int32_t> cell_, begin_;
  std::vector<BodyImage> list_;
};

/// Number of cells: making a cell pays if several points fall on it, and all cells should fit the cache.
int raster_level(std::int64_t points) {
  int level = 4;
  while (level < 10 && (std::int64_t{1} << (2 * (level + 1))) * 4 < points) ++level;
  return level;
}

}  // namespace

MonteCarloFraction monte_carlo_fraction(const System<2>& system, Outline outline, std::int64_t points,
                                        std::uint64_t seed) {
  require(points > 0, "points", static_cast<double>(points), "at least 1");
  const std::vector<BodyShape> bodies = body_shapes(system, outline);
  const Bounds region = region_of<2>(bodies, system.box);
  const Raster raster(bodies, outline, system.box, region, raster_level(points));

  constexpr std::int64_t points_of_stream = 1024;
  const std::int64_t streams = (points + points_of_stream - 1) / points_of_stream;
  const std::int64_t hits = sum_chunks<std::int64_t>(streams, [&](std::int64_t begin, std::int64_t end) {
    std::int64_t count = 0;
    for (std::int64_t stream = begin; stream < end; ++stream) {
      RandomStream draw(seed, Purpose::area_sample, static_cast<std::uint64_t>(stream));
      const std::int64_t last = std::min(points, (stream + 1) * points_of_stream);
      for (std::int64_t p = stream * points_of_stream; p < last; ++p) {
        const double x = draw.uniform(), y = draw.uniform();
        count += raster.covers({x, y});
      }
    }
    return count;
  });
  const Vec2 extent = region.high - region.low;
  const double sampled = extent[0] * extent[1] / system.box.volume();
  const double part = static_cast<double>(hits) / static_cast<double>(points);
  return {sampled * part, sampled * std::sqrt(part * (1 - part) / static_cast<double>(points)), points};
}

}  // namespace supple
