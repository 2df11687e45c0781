/// Demodulation as particleShear 1.0.2 does it.
#pragma once
#include "supple/observe/demodulate.hpp"

namespace supple {

/// Follows the package to rounding, from one period after the start to the end, whole cycles or not: the
/// drift from the rests before and after, with the reversed sign, which doubles it; sums closed at both ends.
Demodulation demodulate_as_published(std::vector<StressSample> series, const Protocol& protocol);

}  // namespace supple
