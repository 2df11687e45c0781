/// The light in pictures of particles in 3D.
#pragma once
#include <algorithm>

#include "supple/core/vec.hpp"
#include "supple/draw/canvas/color.hpp"

namespace supple {

/// How bright a surface with this normal is (along right, up, towards the viewer; any length), in [0, 1]: a
/// share that comes from everywhere, and the cosine to the light, which comes from the viewer's upper left
/// [Lambert 1760].
inline double brightness(const Vec3& normal) {
  constexpr double everywhere = 0.6;
  constexpr Vec3 light{-0.40, 0.56, 0.725};  // of length 1 to three digits
  const double length = norm(normal);
  const double cosine = length > 0 ? dot(light, normal) / length : 0;
  return everywhere + (1 - everywhere) * std::clamp(cosine, 0.0, 1.0);
}

}  // namespace supple
