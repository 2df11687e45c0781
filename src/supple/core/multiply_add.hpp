/// a b + c in one instruction where the processor has one.
#pragma once
#include <cmath>

namespace supple {

/// a b + c, rounded once where the processor does it in one instruction, else twice. The compiler may not
/// fuse other products and sums (-ffp-contract=off): the same formula would then differ from loop to loop.
inline double multiply_add(double a, double b, double c) {
#ifdef __FMA__
  return std::fma(a, b, c);
#else
  return a * b + c;
#endif
}

}  // namespace supple
