#include "supple/draw/page/cell_page.hpp"

#include <algorithm>
#include <cmath>

#include "supple/draw/canvas/superscript.hpp"

namespace supple {

namespace {

constexpr double surroundings = 0.045;  // width of the faded rim, of the cell's longer side
constexpr double fade = 0.72;           // share of white in it
constexpr double least_height = 190;    // that the legend needs [pt]

}  // namespace

std::string shown(const Units& units, double in_si, const char* unit, Digits digits) {
  return units.name == reduced_units().name ? short_number(in_si) : with_unit(in_si, unit, digits);
}

CellPage::CellPage(const std::string& path, const Box<2>& box, double cell_size, double strain_room,
                   double dots_per_inch, const Vec2& room)
    : box_(box),
      room_{std::max(box.length[0], room[0]), std::max(box.length[1], room[1])},
      scale_(cell_size / std::max(room_[0], room_[1])),
      rim_(surroundings * cell_size),
      lean_(std::max(std::abs(drawn_strain(box)), strain_room) * (box.length[gradient] * scale_ + 2 * rim_)),
      cell_(cell_corners(box)),
      canvas_(path, 2 * edge + 2 * rim_ + lean_ + room_[flow] * scale_ + legend_width,
              std::max(2 * rim_ + room_[gradient] * scale_, least_height) + title_height + foot_height,
              dots_per_inch) {
  for (int k = 0; k < 4; ++k) corner_[k] = on_page(cell_[k]);
}

Point CellPage::on_page(const Vec2& x) const {
  return {edge + rim_ + 0.5 * lean_ + x[0] * scale_, title_height + rim_ + (room_[gradient] - x[1]) * scale_};
}

/// The cell's corners moved outward.
std::array<Point, 4> CellPage::moved_out(double along, double across) const {
  const double lean = drawn_strain(box_);
  std::array<Point, 4> corners;
  for (int k = 0; k < 4; ++k) {
    const double right = k == 1 || k == 2 ? along : -along, up = k >= 2 ? across : -across;
    corners[k] = on_page(cell_[k] + Vec2{right + lean * up, up});
  }
  return corners;
}

void CellPage::draw_matter(const std::function<void(double, Lies)>& draw) {
  const bool along = box_.periodic[flow], up = box_.periodic[gradient];
  if (!along && !up) return draw(0, Lies::outside);
  const double out = rim_ / scale_, far = box_.length[flow] + box_.length[gradient];
  const std::array<Point, 4> cell = moved_out(along ? 0 : far, up ? 0 : far);
  canvas_.clipped(moved_out(along ? out : far, up ? out : far), ClipTo::inside,
                  [&] { canvas_.clipped(cell, ClipTo::outside, [&] { draw(fade, Lies::inside); }); });
  canvas_.clipped(cell, ClipTo::inside, [&] { draw(0, Lies::outside); });
}

void CellPage::draw_title(const std::string& title) {
  canvas_.text({edge + rim_, title_height - 3}, title, {.size = 11});
}

void CellPage::draw_scale_bar(const Units& units) {
  const double in_si = round_below(0.25 * room_[flow] * units.length), x = edge + rim_;
  const double width = in_si / units.length * scale_;
  const double y = title_height + 2 * rim_ + room_[gradient] * scale_ + 5;
  canvas_.rectangle({x, y}, {x + width, y + 3}, {ink, {}});
  canvas_.text({x + width + 6, y + 1.5}, shown(units, in_si, "m"), {.size = 9, .down = Down::middle});
}

}  // namespace supple
