/// Errors where a flag of the library reaches who uses it. This project itself asks for -O2 alone.
#pragma once

#if defined(__SSE3__) || defined(__AVX__) || defined(__FMA__)
#error "-march of Supple is public"
#endif
#if defined(__NO_MATH_ERRNO__) || defined(__FAST_MATH__)
#error "-fno-math-errno of Supple is public"
#endif
#if defined(_OPENMP) || defined(_GLIBCXX_ASSERTIONS) || defined(NDEBUG)
#error "a definition of Supple's build is public"
#endif
#if defined(SUPPLE_VERSION) || defined(SUPPLE_ARCH) || defined(EIGEN_DONT_VECTORIZE)
#error "a definition of Supple is public"
#endif
