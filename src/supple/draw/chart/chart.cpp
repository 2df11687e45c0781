#include "supple/draw/chart/chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "supple/core/error.hpp"
#include "supple/draw/canvas/canvas.hpp"
#include "supple/draw/chart/chart_scale.hpp"

namespace supple {

namespace {

constexpr double edge = 8, gap = 9, column_gap = 16;                              // [pt]
constexpr double text_size = 8, tick_size = 7, row_height = 11, tick_length = 3;  // [pt]
constexpr double frame_width = 0.6, resolution = 0.15;
constexpr Color band_text = gray;

using Interval = std::pair<double, double>;

/// The range of the values that the axis can show; from infinity to -infinity where there are none.
Interval range_of(const ChartPanel& panel, std::vector<double> ChartSeries::*values, const ChartAxis& axis) {
  Interval range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const ChartSeries& s : panel.series)
    for (std::size_t i = 0; i < (s.*values).size(); ++i) {
      const double value = (s.*values)[i];
      const double error = values == &ChartSeries::y && i < s.error.size() ? s.error[i] : 0;
      for (const double end : {value - error, value + error})
        if (can_show(axis.spacing, value) && can_show(axis.spacing, end))
          range = {std::min(range.first, end), std::max(range.second, end)};
    }
  return range;
}

/// One panel on its place; drawn when the layout of the whole column is known.
class PlacedPanel {
 public:
  PlacedPanel(Canvas& canvas, const ChartPanel& panel, double width) : canvas_(canvas), panel_(panel) {
    for (const ChartSeries& s : panel.series)
      if (!s.label.empty()) legend_.push_back(&s);
    layout_legend(width);
  }

  double header_height() const {
    return row_height * static_cast<double>(panel_.heading.size() + legend_rows_.size()) +
           (header_empty() ? 0 : 3);
  }

  void set_place(double top, double bottom) {
    top_ = top;
    bottom_ = bottom;
    y_ = scale_of_axis(panel_.y, range_of(panel_, &ChartSeries::y, panel_.y));
    if (!panel_.y.range)
      y_.widen(0.06, 0.06 + (has_band_names() ? (tick_size + 3) / std::max(bottom - top, 1.0) : 0));
    y_.set_ticks(panel_.y, std::clamp(static_cast<int>((bottom - top) / 28), 2, 6));
  }
  double y_label_width() const {
    double widest = 0;
    for (const AxisTick& tick : y_.ticks)
      widest = std::max(widest, canvas_.text_width(tick.label, {.size = tick_size}));
    return widest + tick_length + 2 + 4 + text_size;
  }
  void set_columns(double left, double right, const AxisScale& x) {
    left_ = left;
    right_ = right;
    x_ = x;
  }

  void draw(bool lowest) {
    draw_header();
    const std::array<Point, 4> box{Point{left_, top_}, {right_, top_}, {right_, bottom_}, {left_, bottom_}};
    canvas_.clipped(box, ClipTo::inside, [&] {
      draw_bands();
      if (y_.low < 0 && y_.high > 0) canvas_.line(at(x_.low, 0), at(x_.high, 0), {pale_gray, 0.6});
      if (x_.low < 0 && x_.high > 0) canvas_.line(at(0, y_.low), at(0, y_.high), {pale_gray, 0.6});
      for (const ChartSeries& s : panel_.series) draw_series(s);
    });
    name_bands();
    canvas_.rectangle(box[0], box[2], {{}, Pen{ink, frame_width}});
    draw_y_axis();
    draw_x_axis(lowest);
  }

 private:
  bool header_empty() const { return panel_.heading.empty() && legend_rows_.empty(); }
  bool has_band_names() const {
    return std::any_of(panel_.bands.begin(), panel_.bands.end(),
                       [](const ChartBand& b) { return !b.label.empty(); });
  }
  Point at(double x, double y) const {
    return {left_ + x_.share(x) * (right_ - left_), bottom_ - y_.share(y) * (bottom_ - top_)};
  }

  static constexpr double sample = 16, sample_gap = 4, entry_gap = 12;
  /// A label that is wider than the panel is written smaller.
  double label_size(const ChartSeries& s) const {
    const double room = legend_width_ - sample - sample_gap;
    return tick_size * std::min(1.0, room / canvas_.text_width(s.label, {.size = tick_size}));
  }
  double entry_width(const ChartSeries& s) const {
    return sample + sample_gap + canvas_.text_width(s.label, {.size = label_size(s)}) + entry_gap;
  }
  void layout_legend(double width) {
    legend_width_ = width;
    double used = width + 1;  // starts a row
    for (const ChartSeries* s : legend_) {
      if (used + entry_width(*s) - entry_gap > width) {
        legend_rows_.emplace_back();
        used = 0;
      }
      legend_rows_.back().push_back(s);
      used += entry_width(*s);
    }
  }

  void draw_header() {
    double y = top_ - header_height() + 0.5 * row_height;
    for (const std::string& line : panel_.heading) {
      canvas_.text({left_, y}, line, {.size = text_size, .down = Down::middle});
      y += row_height;
    }
    for (const auto& row : legend_rows_) {
      double x = left_;
      for (const ChartSeries* s : row) {
        if (s->marks == Marks::points) canvas_.circle({x + sample / 2, y}, s->width, {s->color, {}});
        else canvas_.line({x, y}, {x + sample, y}, {s->color, std::max(s->width, 1.0), s->dash});
        canvas_.text({x + sample + sample_gap, y}, s->label, {.size = label_size(*s), .down = Down::middle});
        x += entry_width(*s);
      }
      y += row_height;
    }
  }

  void draw_bands() {
    for (const ChartBand& b : panel_.bands)
      canvas_.rectangle({at(b.from, y_.low)[0], top_}, {at(b.to, y_.low)[0], bottom_}, {b.color, {}});
  }
  /// Where the name fits its band.
  void name_bands() {
    const TextStyle style{.size = tick_size, .color = band_text, .across = Across::centre, .down = Down::top};
    for (const ChartBand& b : panel_.bands) {
      const double from = std::max(at(b.from, y_.low)[0], left_), to = std::min(at(b.to, y_.low)[0], right_);
      if (canvas_.text_width(b.label, style) + 4 < to - from)
        canvas_.text({0.5 * (from + to), top_ + 3}, b.label, style);
    }
  }

  bool can_show(const ChartSeries& s, std::size_t i) const {
    return supple::can_show(x_.spacing, s.x[i]) && supple::can_show(y_.spacing, s.y[i]);
  }
  void draw_series(const ChartSeries& s) {
    const std::size_t n = std::min(s.x.size(), s.y.size());
    for (std::size_t i = 0; i < std::min(n, s.error.size()); ++i) draw_error(s, i);
    if (s.marks == Marks::points) {
      for (std::size_t i = 0; i < n; ++i)
        if (can_show(s, i)) canvas_.circle(at(s.x[i], s.y[i]), s.width, {s.color, {}});
      return;
    }
    std::vector<Point> points;
    for (std::size_t i = 0; i < n; ++i) points.push_back(at(s.x[i], s.y[i]));
    canvas_.polyline(thin(points, resolution), {s.color, s.width, s.dash});
  }
  void draw_error(const ChartSeries& s, std::size_t i) {
    if (!can_show(s, i) || !(s.error[i] > 0)) return;
    const double least =
        supple::can_show(y_.spacing, s.y[i] - s.error[i]) ? s.y[i] - s.error[i] : 0.5 * y_.low;
    const Point low = at(s.x[i], least), high = at(s.x[i], s.y[i] + s.error[i]);
    const Pen pen{s.color, 0.7};
    canvas_.line(low, high, pen);
    for (const Point& end : {low, high}) canvas_.line(end - Point{2, 0}, end + Point{2, 0}, pen);
  }

  void draw_y_axis() {
    for (const AxisTick& tick : y_.ticks) {
      const double y = at(x_.low, tick.at)[1], length = tick.label.empty() ? 0.5 * tick_length : tick_length;
      canvas_.line({left_ - length, y}, {left_, y}, {ink, frame_width});
      canvas_.text({left_ - tick_length - 2, y}, tick.label,
                   {.size = tick_size, .across = Across::right, .down = Down::middle});
    }
    canvas_.text({left_ - y_label_width() + text_size - 2, 0.5 * (top_ + bottom_)}, y_.title,
                 {.size = text_size, .across = Across::centre, .turn = Turn::left});
  }
  void draw_x_axis(bool lowest) {
    for (const AxisTick& tick : x_.ticks) {
      const double x = at(tick.at, y_.low)[0], length = tick.label.empty() ? 0.5 * tick_length : tick_length;
      canvas_.line({x, bottom_}, {x, bottom_ + length}, {ink, frame_width});
      if (lowest)
        canvas_.text({x, bottom_ + tick_length + 2}, tick.label,
                     {.size = tick_size, .across = Across::centre, .down = Down::top});
    }
    if (lowest)
      canvas_.text({0.5 * (left_ + right_), bottom_ + tick_length + 2 + tick_size + 4}, x_.title,
                   {.size = text_size, .across = Across::centre, .down = Down::top});
  }

  Canvas& canvas_;
  const ChartPanel& panel_;
  std::vector<const ChartSeries*> legend_;
  double legend_width_ = 0;
  std::vector<std::vector<const ChartSeries*>> legend_rows_;
  double left_ = 0, right_ = 0, top_ = 0, bottom_ = 0;
  AxisScale x_, y_;
};

constexpr double x_axis_height = tick_length + 2 + tick_size + 4 + text_size;  // [pt]

/// The x axis that the panels of a column share.
AxisScale column_scale(const ChartColumn& column, double width) {
  const ChartAxis& axis = column.panels.back().x;
  Interval range = range_of(column.panels.front(), &ChartSeries::x, axis);
  for (const ChartPanel& panel : column.panels) {
    const Interval here = range_of(panel, &ChartSeries::x, axis);
    range = {std::min(range.first, here.first), std::max(range.second, here.second)};
  }
  AxisScale scale = scale_of_axis(axis, range);
  scale.set_ticks(axis, std::clamp(static_cast<int>(width / 45), 2, 8));
  return scale;
}

void draw_column(Canvas& canvas, const ChartColumn& column, double left, double right, double bottom) {
  // Legends wrap at the width without the labels of the y axis, which are not known yet: 40 pt is ample.
  std::vector<PlacedPanel> panels;
  double headers = 0, weights = 0;
  for (const ChartPanel& panel : column.panels) {
    panels.emplace_back(canvas, panel, right - left - 40);
    headers += panels.back().header_height();
    weights += panel.weight;
  }
  const double gaps = gap * static_cast<double>(panels.size() - 1);
  const double height = bottom - 2 * edge - x_axis_height - headers - gaps;
  double y = edge, labels = 0;
  for (std::size_t p = 0; p < panels.size(); ++p) {
    const double top = y + panels[p].header_height();
    y = top + height * column.panels[p].weight / weights;
    panels[p].set_place(top, y);
    labels = std::max(labels, panels[p].y_label_width());
    y += gap;
  }
  const AxisScale x = column_scale(column, right - left - labels);
  for (std::size_t p = 0; p < panels.size(); ++p) {
    panels[p].set_columns(left + labels, right, x);
    panels[p].draw(p + 1 == panels.size());
  }
}

}  // namespace

void draw_chart(const std::string& path, const Chart& chart) {
  Canvas canvas(path, chart.width, chart.height, chart.dots_per_inch);
  double weights = 0;
  for (const ChartColumn& column : chart.columns) {
    if (column.panels.empty()) throw input_error("a column of a chart has no panel");
    weights += column.weight;
  }
  const double usable = chart.width - 2 * edge - column_gap * static_cast<double>(chart.columns.size() - 1);
  double left = edge;
  for (const ChartColumn& column : chart.columns) {
    const double width = usable * column.weight / weights;
    draw_column(canvas, column, left, left + width, chart.height - chart.room_below);
    left += width + column_gap;
  }
  if (chart.below) chart.below(canvas, chart.height - chart.room_below);
  canvas.finish();
}

}  // namespace supple
