#include "supple/experiment/material.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace supple {
namespace {

Case re_enforced(bool keep = false) {
  Case c;
  c.material.interface_reenforcement_central = 2;
  c.material.interface_reenforcement_tangential = 4;
  c.material.relative_transversal_link_strength = 0.5;
  c.material.keep_viscosity_coefficients_constant = keep;
  return c;
}

TEST(Material, ContactsAreReEnforcedAndLinksKeepTheBaseValues) {
  const MaterialConstants m = resolve_material(re_enforced(), {}, 100, 4);
  EXPECT_DOUBLE_EQ(*m.k, 200);
  EXPECT_DOUBLE_EQ(*m.k * *m.permanent_ratio_central, 100);
  EXPECT_DOUBLE_EQ(*m.k_t, 100 * 0.5 * 4);
  EXPECT_DOUBLE_EQ(*m.k_t * *m.permanent_ratio_tangential, 50);
  EXPECT_DOUBLE_EQ(*m.nu, 2 * 0.1 * std::sqrt(400));
  EXPECT_DOUBLE_EQ(*m.nu_t, 4 * 0.5 * 0.1 * std::sqrt(400));
}

TEST(Material, ViscositiesCanBeKeptConstant) {
  const MaterialConstants m = resolve_material(re_enforced(true), {}, 100, 4);
  EXPECT_DOUBLE_EQ(*m.nu, 2);
  EXPECT_DOUBLE_EQ(*m.nu_t, 1);
}

TEST(Material, AStatePassesUntouchedUnlessAKeyIsGiven) {
  const MaterialConstants stored = resolve_material(re_enforced(), {}, 77.7, 3.3);
  const MaterialConstants m = resolve_material(Case{}, stored, 100, 4);
  EXPECT_EQ(m.k, stored.k);
  EXPECT_EQ(m.nu_t, stored.nu_t);
  EXPECT_EQ(m.permanent_ratio_tangential, stored.permanent_ratio_tangential);
}

/// The same keys on top of a state and in a fresh case must mean the same.
TEST(Material, KeysOnTopOfAStateMeanWhatTheyMeanInAFreshCase) {
  const MaterialConstants plain = resolve_material(Case{}, {}, 100, 4);
  Case c = re_enforced();
  c.given = {"material.interface_reenforcement_central", "material.interface_reenforcement_tangential",
             "material.relative_transversal_link_strength"};
  const MaterialConstants fresh = resolve_material(c, {}, 100, 4), changed = resolve_material(c, plain, 1, 4);
  EXPECT_DOUBLE_EQ(*changed.k, *fresh.k);
  EXPECT_DOUBLE_EQ(*changed.k_t, *fresh.k_t);
  EXPECT_DOUBLE_EQ(*changed.nu, *fresh.nu);
  EXPECT_DOUBLE_EQ(*changed.nu_t, *fresh.nu_t);

  Case stiffer;
  stiffer.given = {"material.young_modulus"};
  const MaterialConstants stored = resolve_material(re_enforced(), {}, 100, 4);
  const MaterialConstants m = resolve_material(stiffer, stored, 300, 4);
  EXPECT_DOUBLE_EQ(*m.k, 600);
  EXPECT_DOUBLE_EQ(*m.k * *m.permanent_ratio_central, 300);
}

}  // namespace
}  // namespace supple
