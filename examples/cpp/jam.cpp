/// A shared module with one function in C:
///   python3 -c 'import ctypes; f = ctypes.CDLL("./libjam.so").jammed_fraction
///   f.restype = ctypes.c_double; print(f(16, 1))'
#include <limits>

#include "supple/core/error.hpp"
#include "supple/experiment/experiments.hpp"

/// The packing fraction at which this many elastic shells jam; not a number where they do not. May be called
/// from several threads at once.
extern "C" double jammed_fraction(int shells, int seed) {
  supple::Case c;
  c.general.experiment = "jamming";
  c.general.seed = seed;
  c.bodies.family = "shell";
  c.bodies.count = shells;
  c.jamming.pressure = 1e-5;
  supple::resolve_family(c);  // the stiffnesses of shells
  supple::MemoryRecorder recorder;
  try {
    supple::run(c, nullptr, recorder);
    return recorder.get("results", "packing_fraction");
  } catch (const supple::Error&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
}
