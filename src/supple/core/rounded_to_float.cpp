#include "supple/core/rounded_to_float.hpp"

namespace supple {

double rounded_to_float(double x) { return static_cast<float>(x); }

}  // namespace supple
