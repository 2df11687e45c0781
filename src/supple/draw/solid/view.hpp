/// From where a picture of particles in 3D looks at them.
#pragma once
#include <string>

#include "supple/core/vec.hpp"

namespace supple {

/// The direction in which the viewer is, far away: lines that are parallel in space are parallel in the
/// picture. z points up in it, or to the viewer where the elevation is 90.
struct View {
  double azimuth = -60;   ///< about z, from x towards y [degree]
  double elevation = 25;  ///< above the plane of x and y, -90 to 90 [degree]
  friend bool operator==(const View&, const View&) = default;
};

/// "corner" (the default), "x" (y to the right, z up), "y" (x to the right, z up), "z" (x to the right, y up:
/// the plane of the shear), each from its positive side but for "y", or "AZIMUTH,ELEVATION" in degrees.
/// Throws an input error with the nearest name.
View view_of(const std::string& name);

/// Unit vectors, each at a right angle to the others: right = up x towards.
struct ViewAxes {
  Vec3 right, up, towards;  ///< in the picture, and to the viewer

  /// Distances along the three [length].
  Vec3 of(const Vec3& x) const { return {dot(right, x), dot(up, x), dot(towards, x)}; }
};

/// Multiples of 90 degrees give vectors without rounding. Throws an input error on angles that are not finite
/// and elevations beyond 90.
ViewAxes axes_of(const View& view);

}  // namespace supple
