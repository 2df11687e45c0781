/// Where lines along z are inside of a body in 3D.
#pragma once
#include <cstdint>
#include <vector>

#include "supple/geometry/line_chord.hpp"
#include "supple/geometry/tiles.hpp"
#include "supple/observe/body_shapes.hpp"

namespace supple {

/// Makes a union of intervals disjoint and ascending, and drops those without length.
void unite(std::vector<Interval>& intervals);

/// What both lists hold; both are disjoint and ascending, and so is the result.
void intersect(const std::vector<Interval>& a, const std::vector<Interval>& b, std::vector<Interval>& both);

/// The chords of one body: exactly, by the definition of its outline.
class BodyChords {
 public:
  /// The shape must outlive this.
  BodyChords(const BodySurface& shape, Outline outline);

  const BodySurface& shape() const { return *shape_; }

  /// Replaces `chords` by the heights at which the line is inside of the body, disjoint and ascending.
  void find(const LineAlongZ& line, std::vector<Interval>& chords) const;

 private:
  /// What makes up a body: spheres about its vertices, cylinders along its edges, prisms over its faces; and
  /// the triangles between which it is inside.
  enum class Kind : std::uint8_t { sphere, cylinder, prism, triangle };
  struct Part {
    Kind kind;
    std::int32_t number;
  };

  void add(Kind kind, std::int32_t number, const BoundsOf<3>& bounds);
  Interval chord_of(const Part& part, const LineAlongZ& line) const;

  const BodySurface* shape_;
  std::vector<Part> parts_;
  std::vector<Interval> x_, y_;  ///< of each part
  Tiles tiles_;                  ///< of the parts, as lines see them
};

}  // namespace supple
