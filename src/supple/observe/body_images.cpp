#include "supple/observe/body_images.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "supple/core/error.hpp"

namespace supple {
namespace {

/// Copies of a body along one direction, and of all bodies for each of them. Bodies are less than a cell
/// wide, so that ten meet the cell; a damaged size would make more than there is memory.
constexpr double most_copies = 1e6;
constexpr std::size_t most_images = 1000;

template <int Dim>
std::string in_words(const Vec<Dim>& size) {
  std::string text = fmt::format("{:.3g}", size[0]);
  for (int d = 1; d < Dim; ++d) text += fmt::format(" x {:.3g}", size[d]);
  return text;
}

template <int Dim>
[[noreturn]] void refuse_copies(int body, const BoundsOf<Dim>& b, const Box<Dim>& box) {
  throw input_error(fmt::format("no copies of body {}, {} in size, in a cell of {}", body,
                                in_words<Dim>(b.high - b.low), in_words<Dim>(box.length)),
                    "there would be thousands", "look for a wrong unit or a damaged number");
}

/// The gradient first, because the images along the flow depend on it.
template <int Dim>
constexpr std::array<int, Dim> order_of_directions() {
  std::array<int, Dim> order{gradient, flow};
  for (int d = 2; d < Dim; ++d) order[static_cast<std::size_t>(d)] = d;
  return order;
}

/// Appends the copies of one body that meet the region, with the cells chosen so far.
template <int Dim>
void append_images(const BoundsOf<Dim>& region, int body, const BoundsOf<Dim>& own, const Box<Dim>& box,
                   std::size_t most, std::size_t place, Vec<Dim> cells, std::vector<ImageOf<Dim>>& images) {
  const Vec<Dim> shift = box.lattice().vector(cells);
  if (place == Dim) {
    const BoundsOf<Dim> bounds = own.shifted(shift);
    if (!bounds.meets(region)) return;
    images.push_back({body, shift, bounds});
    if (images.size() > most) refuse_copies(body, own, box);
    return;
  }
  const int d = order_of_directions<Dim>()[place];
  double first = 0, last = 0;  // cells by which the copy can be displaced along d so that it meets the region
  if (box.periodic[d]) {
    first = std::ceil((region.low[d] - (own.high[d] + shift[d])) / box.length[d]);
    last = std::floor((region.high[d] - (own.low[d] + shift[d])) / box.length[d]);
  }
  if (!(last - first < most_copies)) refuse_copies(body, own, box);
  for (cells[d] = first; cells[d] <= last; ++cells[d])
    append_images(region, body, own, box, most, place + 1, cells, images);
}

template <class Shape>
auto bounds_of_all(std::span<const Shape> bodies) {
  auto all = bodies.empty() ? decltype(Shape::bounds){} : bodies[0].bounds;
  for (const Shape& body : bodies) all.include(body.bounds);
  return all;
}

}  // namespace

Bounds bounds_of(std::span<const BodyShape> bodies) { return bounds_of_all(bodies); }
BoundsOf<3> bounds_of(std::span<const BodySurface> bodies) { return bounds_of_all(bodies); }

template <int Dim>
std::vector<ImageOf<Dim>> images_in(const BoundsOf<Dim>& region, std::span<const ShapeOf<Dim>> bodies,
                                    const Box<Dim>& box) {
  std::vector<ImageOf<Dim>> images;
  for (int body = 0; body < static_cast<int>(bodies.size()); ++body)
    append_images(region, body, bodies[body].bounds, box, most_images * bodies.size(), 0, {}, images);
  return images;
}

template <int Dim>
BoundsOf<Dim> region_of(std::span<const ShapeOf<Dim>> bodies, const Box<Dim>& box) {
  constexpr double far = std::numeric_limits<double>::infinity();
  const BoundsOf<Dim> cell{{}, box.length};
  BoundsOf<Dim> unlimited = cell, region = cell;
  for (int d = 0; d < Dim; ++d)
    if (!box.periodic[d]) unlimited.low[d] = -far, unlimited.high[d] = far;
  for (const ImageOf<Dim>& image : images_in(unlimited, bodies, box)) region.include(image.bounds);
  for (int d = 0; d < Dim; ++d)
    if (box.periodic[d]) region.low[d] = cell.low[d], region.high[d] = cell.high[d];
  return region;
}

template <int Dim>
ImageSearch<Dim>::ImageSearch(std::span<const ShapeOf<Dim>> bodies, const Box<Dim>& box)
    : bodies_(bodies), images_(images_in(bounds_of(bodies), bodies, box)) {
  std::stable_sort(images_.begin(), images_.end(), [](const ImageOf<Dim>& a, const ImageOf<Dim>& b) {
    return a.bounds.low[0] < b.bounds.low[0];
  });
  for (const auto& body : bodies) {
    widest_ = std::max(widest_, body.bounds.high[0] - body.bounds.low[0]);
    tallest_ = std::max(tallest_, body.bounds.high[1] - body.bounds.low[1]);
  }
  const BoundsOf<Dim> all = bounds_of(bodies);
  lowest_ = all.low[1] - tallest_;
  const double rows = tallest_ > 0 ? (all.high[1] - lowest_) / tallest_ : 0;
  rows_.resize(1 + static_cast<std::size_t>(std::clamp(rows, 0.0, static_cast<double>(bodies.size()))));
  for (std::size_t k = 0; k < images_.size(); ++k)
    rows_[row_of(images_[k].bounds.low[1])].push_back(static_cast<std::int32_t>(k));
}

template <int Dim>
int ImageSearch<Dim>::row_of(double height) const {
  const double row = tallest_ > 0 ? (height - lowest_) / tallest_ : 0;
  return static_cast<int>(std::clamp(row, 0.0, static_cast<double>(rows_.size() - 1)));
}

template <int Dim>
void ImageSearch<Dim>::find(int body, std::vector<ImageOf<Dim>>& found) const {
  const BoundsOf<Dim>& bounds = bodies_[body].bounds;
  found.clear();
  const double leftmost = bounds.low[0] - 1.001 * widest_;
  std::vector<std::int32_t> near;
  for (int row = row_of(bounds.low[1] - 1.001 * tallest_); row <= row_of(bounds.high[1]); ++row) {
    const auto left_of = [&](std::int32_t k, double x) { return images_[k].bounds.low[0] < x; };
    auto k = std::lower_bound(rows_[row].begin(), rows_[row].end(), leftmost, left_of);
    for (; k != rows_[row].end() && images_[*k].bounds.low[0] <= bounds.high[0]; ++k) {
      const ImageOf<Dim>& image = images_[*k];
      const bool itself = image.body == body && image.shift == Vec<Dim>{};
      if (!itself && image.bounds.meets(bounds)) near.push_back(*k);
    }
  }
  std::sort(near.begin(), near.end());  // sums go from left to right
  for (const std::int32_t k : near) found.push_back(images_[k]);
}

template std::vector<ImageOf<2>> images_in(const BoundsOf<2>&, std::span<const BodyShape>, const Box<2>&);
template std::vector<ImageOf<3>> images_in(const BoundsOf<3>&, std::span<const BodySurface>, const Box<3>&);
template BoundsOf<2> region_of(std::span<const BodyShape>, const Box<2>&);
template BoundsOf<3> region_of(std::span<const BodySurface>, const Box<3>&);
template class ImageSearch<2>;
template class ImageSearch<3>;

}  // namespace supple
