#include "supple/energy/elastic_constants.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "supple/core/error.hpp"

namespace supple {
namespace {

TEST(ElasticConstants, GoToLameConstantsAndBack) {
  for (const double nu : {-0.9, -0.3, 0.0, 0.25, 0.49}) {
    const ElasticConstants there = elastic_constants<3>(lame_constants<3>({2, nu})),
                           flat = elastic_constants<2>(lame_constants<2>({2, 2 * nu > -1 ? 2 * nu : nu}));
    EXPECT_NEAR(there.young_modulus, 2, 1e-14);
    EXPECT_NEAR(there.poisson_ratio, nu, 1e-14);
    EXPECT_NEAR(flat.young_modulus, 2, 1e-14);
    EXPECT_NEAR(flat.poisson_ratio, 2 * nu > -1 ? 2 * nu : nu, 1e-14);
  }
}

TEST(ElasticConstants, AreThoseOfABarUnderTension) {
  // Stress lambda tr(eps) + 2 mu eps of the strain 1 along the bar and -nu across: E along, 0 across.
  const double E = 3, nu = 0.3;
  const LameConstants flat = lame_constants<2>({E, nu}), solid = lame_constants<3>({E, nu});
  EXPECT_NEAR(flat.lambda * (1 - nu) + 2 * flat.mu, E, 1e-14);
  EXPECT_NEAR(flat.lambda * (1 - nu) - 2 * flat.mu * nu, 0, 1e-14);
  EXPECT_NEAR(solid.lambda * (1 - 2 * nu) + 2 * solid.mu, E, 1e-14);
  EXPECT_NEAR(solid.lambda * (1 - 2 * nu) - 2 * solid.mu * nu, 0, 1e-14);
  // Cauchy's solid, where both constants are the same.
  EXPECT_NEAR(elastic_constants<2>({1, 1}).poisson_ratio, 1.0 / 3, 1e-15);
  EXPECT_NEAR(elastic_constants<3>({1, 1}).poisson_ratio, 0.25, 1e-15);
  EXPECT_NEAR(elastic_constants<2>({1, 1}).young_modulus, 8.0 / 3, 1e-15);
  EXPECT_NEAR(elastic_constants<3>({1, 1}).young_modulus, 2.5, 1e-15);
}

TEST(ElasticConstants, RefuseAMaterialThatIsNotStable) {
  EXPECT_THROW(lame_constants<3>({0, 0.3}), Error);
  EXPECT_THROW(lame_constants<3>({-1, 0.3}), Error);
  EXPECT_THROW(lame_constants<3>({NAN, 0.3}), Error);
  EXPECT_THROW(lame_constants<3>({1, 0.5}), Error);
  EXPECT_THROW(lame_constants<3>({1, -1}), Error);
  EXPECT_THROW(lame_constants<3>({1, NAN}), Error);
  EXPECT_THROW(lame_constants<2>({1, 1}), Error);
  EXPECT_NO_THROW(lame_constants<2>({1, 0.9}));
  EXPECT_THROW(elastic_constants<3>({1, 0}), Error);
  EXPECT_THROW(elastic_constants<3>({-2.0 / 3, 1}), Error);
  EXPECT_THROW(elastic_constants<2>({-1, 1}), Error);
  EXPECT_NO_THROW(elastic_constants<2>({-0.9, 1}));
}

}  // namespace
}  // namespace supple
