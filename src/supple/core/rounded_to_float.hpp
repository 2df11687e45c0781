/// Doubles as files of floats give them back.
#pragma once

namespace supple {

/// The double that the nearest float stands for; beyond the range of floats, an infinity. A function that is
/// never inlined, since where GCC 12 rounds several numbers at once (-O2 -march=native -fno-trapping-math) it
/// leaves both conversions out and hands the doubles on as they were.
[[nodiscard, gnu::noinline]] double rounded_to_float(double x);

}  // namespace supple
