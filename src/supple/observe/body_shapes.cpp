#include "supple/observe/body_shapes.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "supple/core/error.hpp"
#include "supple/geometry/hinge.hpp"
#include "supple/geometry/polygon.hpp"

namespace supple {
namespace {

void check(const BodyShape& shape, int body, Outline outline) {
  const auto refuse = [body](const char* why, const char* to_do) {
    throw input_error(fmt::format("no area for body {}", body), why, to_do);
  };
  for (int i = 0; i < shape.size(); ++i) {
    if (!std::isfinite(shape.ring[i][0]) || !std::isfinite(shape.ring[i][1]))
      refuse("a position is not finite", "look at the state");
    if (!(shape.radius[i] >= 0) || std::isinf(shape.radius[i]))
      refuse("a radius is negative or not finite", "give radii");
    if (outline == Outline::smooth && shape.radius[i] != shape.radius[0])
      refuse("its radii differ", "give one radius to a body of smooth outline");
  }
  if (shape.is_disc()) return;
  for (int i = 0; i < shape.size(); ++i)
    if (shape.ring[i] == shape.ring[shape.next(i)])
      refuse("two neighbours on its ring are in one place", "move them apart");
  if (shape.size() < 3) refuse("it has two sites", "give one (a disc) or at least three (a polygon)");
  if (!(polygon_area(shape.ring) > 0))
    refuse("its sites run clockwise", "order them counter-clockwise, unwrapped");
}

Bounds bounds_with_discs(const BodyShape& shape) {
  Bounds all{shape.ring[0], shape.ring[0]};
  for (int i = 0; i < shape.size(); ++i) {
    const Vec2 reach{shape.radius[i], shape.radius[i]};
    all.include({shape.ring[i] - reach, shape.ring[i] + reach});
  }
  return all;
}

void bring_into_cell(BodyShape& shape, const Box<2>& box) {
  const Vec2 middle = 0.5 * (shape.bounds.low + shape.bounds.high);
  const Vec2 shift = -box.lattice().vector(box.lattice().cell_of(middle));
  for (Vec2& x : shape.ring) x += shift;
  shape.bounds = shape.bounds.shifted(shift);
}

/// Copies of a body along one direction, and of all bodies for each of them. Bodies are less than a cell
/// wide, so that ten meet the cell; a damaged size would make more than there is memory.
constexpr double most_copies = 1e6;
constexpr std::size_t most_images = 1000;

[[noreturn]] void refuse_copies(int body, const Bounds& b, const Box<2>& box) {
  throw input_error(
      fmt::format("no copies of body {}, {:.3g} x {:.3g} in size, in a cell of {:.3g} x {:.3g}", body,
                  b.high[0] - b.low[0], b.high[1] - b.low[1], box.length[0], box.length[1]),
      "there would be thousands", "look for a wrong unit or a damaged number");
}

}  // namespace

double BodyShape::distance_to_edge(int k, const Vec2& x) const {
  return distance_to_segment(x, ring[k], ring[next(k)]);
}

double BodyShape::turn_at(int i) const {
  const Vec2 corner[3] = {ring[previous(i)], ring[i], ring[next(i)]};
  return hinge_angle(corner);
}

std::vector<BodyShape> lay_out_bodies(const System<2>& system) {
  for (int d = 0; d < 2; ++d)
    if (!(system.box.length[d] > 0) || std::isinf(system.box.length[d]))
      throw input_error(fmt::format("the cell has length {}", system.box.length[d]), "out of range",
                        "give positive lengths");
  const State<2>& state = system.state;
  std::vector<BodyShape> shapes(static_cast<std::size_t>(system.topology.body_count(state.size())));
  for (int body = 0; body < static_cast<int>(shapes.size()); ++body) {
    const int first = system.topology.body_begin(body), last = system.topology.body_end(body);
    if (last <= first)
      throw input_error(fmt::format("no area for body {}", body), "it has no site", "leave it out");
    BodyShape& shape = shapes[body];
    shape.ring.assign(state.position.begin() + first, state.position.begin() + last);
    shape.radius.assign(state.radius.begin() + first, state.radius.begin() + last);
    shape.bounds = bounds_with_discs(shape);
    bring_into_cell(shape, system.box);
  }
  return shapes;
}

std::vector<BodyShape> body_shapes(const System<2>& system, Outline outline) {
  std::vector<BodyShape> shapes = lay_out_bodies(system);
  for (int body = 0; body < static_cast<int>(shapes.size()); ++body) check(shapes[body], body, outline);
  return shapes;
}

std::vector<BodyImage> images_in(const Bounds& region, std::span<const BodyShape> bodies, const Box<2>& box) {
  std::vector<BodyImage> images;
  // Cells by which `low .. high` can be displaced along d so that it meets the region.
  const auto cells = [&](int d, double low, double high) {
    if (!box.periodic[d]) return std::pair{0.0, 0.0};
    return std::pair{std::ceil((region.low[d] - high) / box.length[d]),
                     std::floor((region.high[d] - low) / box.length[d])};
  };
  for (int body = 0; body < static_cast<int>(bodies.size()); ++body) {
    const Bounds& own = bodies[body].bounds;
    const auto [lowest, highest] = cells(gradient, own.low[gradient], own.high[gradient]);
    if (!(highest - lowest < most_copies)) refuse_copies(body, own, box);
    for (double up = lowest; up <= highest; ++up) {
      const double sheared = box.lattice().vector({0, up})[flow];
      const auto [first, last] = cells(flow, own.low[flow] + sheared, own.high[flow] + sheared);
      if (!(last - first < most_copies)) refuse_copies(body, own, box);
      for (double across = first; across <= last; ++across) {
        const Vec2 shift = box.lattice().vector({across, up});
        const Bounds bounds = own.shifted(shift);
        if (!bounds.meets(region)) continue;
        images.push_back({body, shift, bounds});
        if (images.size() > most_images * bodies.size()) refuse_copies(body, own, box);
      }
    }
  }
  return images;
}

Bounds bounds_of(std::span<const BodyShape> bodies) {
  Bounds all = bodies.empty() ? Bounds{} : bodies[0].bounds;
  for (const BodyShape& body : bodies) all.include(body.bounds);
  return all;
}

ImageSearch::ImageSearch(std::span<const BodyShape> bodies, const Box<2>& box)
    : bodies_(bodies), images_(images_in(bounds_of(bodies), bodies, box)) {
  std::stable_sort(images_.begin(), images_.end(),
                   [](const BodyImage& a, const BodyImage& b) { return a.bounds.low[0] < b.bounds.low[0]; });
  for (const BodyShape& body : bodies) {
    widest_ = std::max(widest_, body.bounds.high[0] - body.bounds.low[0]);
    tallest_ = std::max(tallest_, body.bounds.high[1] - body.bounds.low[1]);
  }
  const Bounds all = bounds_of(bodies);
  lowest_ = all.low[1] - tallest_;
  const double rows = tallest_ > 0 ? (all.high[1] - lowest_) / tallest_ : 0;
  rows_.resize(1 + static_cast<std::size_t>(std::clamp(rows, 0.0, static_cast<double>(bodies.size()))));
  for (std::size_t k = 0; k < images_.size(); ++k)
    rows_[row_of(images_[k].bounds.low[1])].push_back(static_cast<std::int32_t>(k));
}

int ImageSearch::row_of(double height) const {
  const double row = tallest_ > 0 ? (height - lowest_) / tallest_ : 0;
  return static_cast<int>(std::clamp(row, 0.0, static_cast<double>(rows_.size() - 1)));
}

void ImageSearch::find(int body, std::vector<BodyImage>& found) const {
  const Bounds& bounds = bodies_[body].bounds;
  found.clear();
  const double leftmost = bounds.low[0] - 1.001 * widest_;
  std::vector<std::int32_t> near;
  for (int row = row_of(bounds.low[1] - 1.001 * tallest_); row <= row_of(bounds.high[1]); ++row) {
    const auto left_of = [&](std::int32_t k, double x) { return images_[k].bounds.low[0] < x; };
    auto k = std::lower_bound(rows_[row].begin(), rows_[row].end(), leftmost, left_of);
    for (; k != rows_[row].end() && images_[*k].bounds.low[0] <= bounds.high[0]; ++k) {
      const BodyImage& image = images_[*k];
      const bool itself = image.body == body && image.shift == Vec2{};
      if (!itself && image.bounds.meets(bounds)) near.push_back(*k);
    }
  }
  std::sort(near.begin(), near.end());  // sums go from left to right
  for (const std::int32_t k : near) found.push_back(images_[k]);
}

}  // namespace supple
