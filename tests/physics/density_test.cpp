/// When everything scales with tau = sqrt(m/k), the density of the discs changes no result.
#include <gtest/gtest.h>

#include "supple/experiment/experiments.hpp"

namespace supple {
namespace {

TEST(Density, ModuliDoNotDependOnIt) {
  Case c;
  c.particles.discs = 20;
  c.particles.cut_lines = 3;
  c.shear.pre_periods = 0.5;
  c.shear.periods = 2;
  c.shear.post_periods = 0.5;
  MemoryRecorder reference;
  run(c, nullptr, reference);
  for (const double density : {50.0, 7300.0}) {
    c.material.density = density;
    MemoryRecorder other;
    run(c, nullptr, other);
    for (const char* stress : {"internal", "external", "periodic", "virial"})
      for (const char* modulus : {"storage_modulus_", "loss_modulus_"}) {
        const std::string name = std::string(modulus) + stress;
        const double expected = reference.get("results", name);
        EXPECT_NEAR(other.get("results", name), expected, 1e-6 * std::abs(expected))
            << name << ", density " << density;
      }
    EXPECT_NEAR(other.get("constants", "frequency") * std::sqrt(density / 1000),
                reference.get("constants", "frequency"), 1e-9 * reference.get("constants", "frequency"));
  }
}

}  // namespace
}  // namespace supple
