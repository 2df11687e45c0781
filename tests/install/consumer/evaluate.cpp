/// Makes the library call supple::ForceField::evaluate, which stands in a header.
#include <cstdio>

#include "supple/experiment/experiments.hpp"

int main() {
  supple::Case c;
  c.general.experiment = "jamming";
  c.bodies.count = 4;
  c.bodies.vertices = 6;
  c.jamming.pressure = 1e-3;
  supple::resolve_family(c);
  supple::MemoryRecorder recorder;
  supple::run(c, nullptr, recorder);
  return std::printf("%g\n", recorder.get("results", "packing_fraction")) < 0;
}
