/// Colours of pictures: palettes that colour-blind readers can tell apart [Paul Tol, SRON/EPS/TN/09-002,
/// 2021].
#pragma once
#include <array>
#include <cstdint>

namespace supple {

/// An opaque colour, each channel in [0, 1]. PostScript has no transparency, so faint colours are mixed with
/// white.
struct Color {
  double red = 0, green = 0, blue = 0;
  friend constexpr bool operator==(const Color&, const Color&) = default;
};

/// The colour 0xRRGGBB.
constexpr Color hex(std::uint32_t rgb) {
  return {(rgb >> 16 & 255) / 255.0, (rgb >> 8 & 255) / 255.0, (rgb & 255) / 255.0};
}
/// Mixes two colours; `share` is the part of b.
constexpr Color mix(Color a, Color b, double share) {
  const double keep = 1 - share;
  return {keep * a.red + share * b.red, keep * a.green + share * b.green, keep * a.blue + share * b.blue};
}

inline constexpr Color black{0, 0, 0}, white{1, 1, 1};
inline constexpr Color ink = hex(0x222222), gray = hex(0x777777), pale_gray = hex(0xDDDDDD);

/// Tol's "light" scheme, for areas under dark lines and letters. The most different colours come first.
inline constexpr std::array<Color, 8> area_palette{hex(0x77AADD), hex(0xEEDD88), hex(0x44BB99),
                                                   hex(0xFFAABB), hex(0xEE8866), hex(0xBBCC33),
                                                   hex(0x99DDFF), hex(0xAAAA00)};
/// Tol's "bright" scheme, for lines and points.
inline constexpr std::array<Color, 6> line_palette{hex(0x4477AA), hex(0xEE6677), hex(0x228833),
                                                   hex(0xCCBB44), hex(0x66CCEE), hex(0xAA3377)};

}  // namespace supple
