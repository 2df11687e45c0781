/// Demodulation as particleShear 1.0.2 does it.
#pragma once
#include "supple/observe/demodulate.hpp"

namespace supple {

/// Follows the package to rounding, from one period after the start of shear to its end, whole cycles or not.
/// The drift comes from the rests before and after, with the wrong sign, which doubles it, and sums hold both
/// ends of the window.
Demodulation demodulate_as_published(std::vector<StressSample> series, const Protocol& protocol);

}  // namespace supple
