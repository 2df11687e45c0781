/// Elastic and tensile laws and scales of the published package, against its own values.
#include <gtest/gtest.h>

#include "supple/compat/particleshear/protocol.hpp"
#include "tests/package/reference.hpp"

namespace supple::testing {
namespace {

void expect_equal(double mine, double reference) {
  EXPECT_LE(std::abs(mine - reference), 1e-12 * std::abs(reference)) << mine << " for " << reference;
}

TEST(ParticleShearLaw, ForcesAreThePackages) {
  using namespace particleshear;
  for (const auto& point : read_reference_json("force_laws.json")) {
    SCOPED_TRACE(point.dump());
    ParticleShearConstants c;
    c.k = point["k"];
    c.central_repulsion_coefficient = point["crc"];
    const double d = point["d"], d0 = point["d0"];
    expect_equal(-repulsion<ParticleShearElastic::divergent>(d, d0, c), point["default"]);
    expect_equal(-repulsion<ParticleShearElastic::plateau>(d, d0, c), point["plateau"]);
    expect_equal(tension<ParticleShearTensile::linear>(d, d0, c), point["tensile_linear"]);
    expect_equal(tension<ParticleShearTensile::saturating>(d, d0, c), point["tensile_exp"]);
  }
}

TEST(ParticleShearScales, AreThePackages) {
  for (const auto& p : read_reference_json("model_parameters.json")) {
    SCOPED_TRACE(p.dump());
    const auto scales = [&](double size_ratio) {
      return particleshear_scales(p["N"], 500.0 * 500.0, p["packing_fraction"], p["E"], p["density"],
                                  size_ratio);
    };
    const ParticleShearScales s = scales(p["bimodal_factor"]);
    expect_equal(s.radius, p["r"]);
    expect_equal(s.mass, p["m"]);
    expect_equal(s.k, p["k"]);
    expect_equal(s.tau, p["tau"]);
    expect_equal(scales(1.4).radius, p["r_estimate_1p4"]);
  }
}

}  // namespace
}  // namespace supple::testing
