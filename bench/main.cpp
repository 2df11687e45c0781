#include <fmt/core.h>
#include <ctime>
#include "bench/dense_discs.hpp"
#include "bench/lammps.hpp"
using namespace supple; using namespace supple::bench;
static double cpu() { timespec t; clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t); return t.tv_sec + 1e-9 * t.tv_nsec; }
int main(int argc, char** argv) {
  int n = argc > 1 ? atoi(argv[1]) : 10000, steps = argc > 2 ? atoi(argv[2]) : 1000;
  const System<2> start = dense_discs({n});
  write_lammps_case("/tmp/benchcase", start, dense_law(), time_step);
  for (double skin : {0.2, 0.2, 0.4}) {
    System<2> s = start;
    auto d = dense_dynamics(skin);
    double t = cpu();
    for (int i = 0; i < steps; ++i) { d.evaluate(s, {}); d.advance(s, {}, time_step, 1); }
    t = cpu() - t;
    fmt::print("n {} skin {} ns {:.1f} builds {} z {:.2f} rows/disc {:.2f} speed {:.4f}->{:.4f}\n", n, skin, 1e9 * t / steps / n, d.forces().neighbors().builds(), contacts_per_disc(s), double(s.pairs.size()) / n, rms_speed(start), rms_speed(s));
  }
}
