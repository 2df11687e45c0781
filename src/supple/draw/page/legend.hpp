/// How contacts look, and the legend of pictures of a cell.
#pragma once
#include <algorithm>
#include <array>
#include <functional>
#include <string>

#include "supple/draw/canvas/canvas.hpp"
#include "supple/draw/canvas/color_scale.hpp"
#include "supple/draw/page/snapshot.hpp"

namespace supple {

struct ContactStyle {
  ContactState state;
  const char* name;
  Color color;
};
/// Styles in the order of drawing: the few contacts that slip lie on top.
inline constexpr std::array<ContactStyle, 3> contact_styles{
    {{ContactState::permanent, "crosslink", hex(0x555555)},
     {ContactState::stick, "contact, stick", hex(0x0033AA)},
     {ContactState::slip, "contact, slip", hex(0xCC1144)}}};

/// Pens of contacts, as wide as their force.
struct ContactLines {
  double full_force = 0;  ///< of a line of this width:
  double widest = 1;      ///< [pt]

  Pen pen(Color color, double force, bool tension = false) const {
    const double share = full_force > 0 ? std::clamp(force / full_force, 0.12, 1.2) : 0.12;
    Pen pen{color, share * widest};
    if (tension) pen.dash = {std::max(1.8, 1.2 * pen.width), std::max(1.2, 0.8 * pen.width)};
    return pen;
  }
};

/// The legend of a picture, written from the top down.
class Legend {
 public:
  /// Begins at `top`, right of `left` [pt].
  Legend(Canvas& canvas, double left, double top) : canvas_(canvas), x_(left), top_(top), y_(top + 6) {}

  /// Adds the colour bar of a number of bodies.
  void color_bar(const BodyScalar& scalar, const ColorScale& scale, double height);
  /// Adds what the colours of particles mean, in scenes whose bodies crosslinks may join.
  void particles(const Scene& scene);
  /// Adds hatched (held) bodies, if there are any; `hatch` draws the lines in a ring.
  void held(const Scene& scene, const std::function<void(const std::vector<Point>& ring)>& hatch);
  /// Adds the states of contacts, if they differ, and the widths of lines for forces.
  void contacts(const Scene& scene, const ContactLines& lines);

 private:
  static constexpr double row = 15, sample = 24;  // [pt]

  void name_row(const std::string& name);
  void line_row(const std::string& name, const Pen& pen);
  void swatch_row(const std::string& name, const std::vector<Color>& colors);
  bool is_empty() const { return y_ == top_ + 6; }

  Canvas& canvas_;
  double x_, top_, y_;
};

}  // namespace supple
