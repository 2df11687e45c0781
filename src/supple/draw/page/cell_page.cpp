#include "supple/draw/page/cell_page.hpp"

#include <fmt/format.h>

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

std::string instant_title(const Units& units, double time, double strain, double drawn, bool flows) {
  const bool passes = time != 0 || units.name != reduced_units().name;
  std::string text;
  if (passes) text += "t = " + shown(units, time * units.time, "s", Digits::three) + "     ";
  if (strain != 0 || (passes && flows))
    text += fmt::format("\u03b3 = {}\u00a0%", tick_label(100 * strain, 0.1));
  if (std::abs(drawn - strain) > 1e-9)
    text += fmt::format("     (drawn at the equivalent {}\u00a0%)", tick_label(100 * drawn, 0.1));
  return text;
}

void draw_scale_bar(Canvas& canvas, Point at, double scale, double longest, const Units& units) {
  const double in_si = round_below(longest * units.length);
  const double width = in_si / units.length * scale;
  canvas.rectangle(at, {at[0] + width, at[1] + 3}, {ink, {}});
  canvas.text({at[0] + width + 6, at[1] + 1.5}, shown(units, in_si, "m"), {.size = 9, .down = Down::middle});
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
  const double y = title_height + 2 * rim_ + room_[gradient] * scale_ + 5;
  supple::draw_scale_bar(canvas_, {edge + rim_, y}, scale_, 0.25 * room_[flow], units);
}

}  // namespace supple
