#include "supple/draw/canvas/color_scale.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "supple/draw/canvas/ticks.hpp"

namespace supple {

namespace {

constexpr std::array<Color, 19> iridescent{
    hex(0xFEFBE9), hex(0xFCF7D5), hex(0xF5F3C1), hex(0xEAF0B5), hex(0xDDECBF), hex(0xD0E7CA), hex(0xC2E3D2),
    hex(0xB5DDD8), hex(0xA8D8DC), hex(0x9BD2E1), hex(0x8DCBE4), hex(0x81C4E7), hex(0x7BBCE7), hex(0x7EB2E4),
    hex(0x88A5DD), hex(0x9398D2), hex(0x9B8AC4), hex(0x9D7DB2), hex(0x9A709E)};

constexpr double bar_width = 11, tick_length = 3, text_size = 8;  // [pt]

}  // namespace

Color sequential_color(double share) {
  const double at = std::clamp(share, 0.0, 1.0) * (iridescent.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(at), iridescent.size() - 2);
  return mix(iridescent[below], iridescent[below + 1], at - static_cast<double>(below));
}

Color ColorScale::color(double value) const {
  return std::isfinite(value) ? sequential_color((value - low) / (high - low)) : pale_gray;
}

ColorScale scale_over(std::span<const double> values) {
  ColorScale scale{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    scale.low = std::min(scale.low, value);
    scale.high = std::max(scale.high, value);
  }
  if (scale.low > scale.high) return {0, 1};
  if (scale.high - scale.low <= 1e-12 * std::max(std::abs(scale.low), std::abs(scale.high))) {
    const double half = scale.low == 0 ? 1 : 0.05 * std::abs(scale.low);
    return {scale.low - half, scale.high + half};
  }
  return scale;
}

double draw_color_bar(Canvas& canvas, Point upper_left, double height, const ColorScale& scale,
                      const std::string& label, const std::string& unit) {
  const ShownUnit shown = shown_unit(unit, std::max(std::abs(scale.low), std::abs(scale.high)));
  const double left = upper_left[0], right = left + bar_width, top = upper_left[1] + 1.8 * text_size;
  canvas.text({left, upper_left[1]}, shown.text.empty() ? label : label + " (" + shown.text + ")",
              {.size = text_size, .down = Down::top});
  const int strips = 128;  // each as high as two, so that no gap shows between them
  for (int k = 0; k < strips; ++k) {
    const double y = top + height * k / strips;
    canvas.rectangle({left, y}, {right, std::min(y + 2 * height / strips, top + height)},
                     {sequential_color(1 - (k + 0.5) / strips), {}});
  }
  canvas.rectangle({left, top}, {right, top + height}, {{}, Pen{ink, 0.6}});
  const Ticks ticks =
      nice_ticks(scale.low / shown.factor, scale.high / shown.factor, std::max(2, int(height / 28)));
  for (const double tick : ticks.at) {
    const double y = top + height * (scale.high - tick * shown.factor) / (scale.high - scale.low);
    canvas.line({right, y}, {right + tick_length, y}, {ink, 0.6});
    canvas.text({right + tick_length + 3, y}, tick_label(tick, ticks.step),
                {.size = text_size, .down = Down::middle});
  }
  return top + height;
}

}  // namespace supple
