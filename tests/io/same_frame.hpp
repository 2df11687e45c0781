/// Frames that must be equal to the last bit.
#pragma once
#include <gtest/gtest.h>

#include <tuple>

#include "supple/experiment/recorder.hpp"
#include "tests/io/same_system.hpp"

namespace supple::testing {

template <int Dim>
void expect_same(const Frame<Dim>& a, const Frame<Dim>& b) {
  EXPECT_EQ(a.step, b.step);
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.strain, b.strain);
  EXPECT_EQ(a.strain_rate, b.strain_rate);
  EXPECT_TRUE(same_bits(a.position, b.position));
  EXPECT_TRUE(same_bits(a.velocity, b.velocity));
  EXPECT_TRUE(same_bits(a.force, b.force));
  EXPECT_TRUE(same_bits(a.angle, b.angle));
  EXPECT_TRUE(same_bits(a.spin, b.spin));
  EXPECT_TRUE(same_bits(a.torque, b.torque));
  EXPECT_EQ(a.mobility, b.mobility);
  EXPECT_EQ(a.length, b.length);
  EXPECT_EQ(a.body, b.body);
  EXPECT_EQ(a.numbers, b.numbers);
  ASSERT_EQ(a.contacts.size(), b.contacts.size());
  for (std::size_t c = 0; c < a.contacts.size(); ++c) {
    const ContactRow<Dim>&x = a.contacts[c], &y = b.contacts[c];
    EXPECT_EQ(std::tie(x.first, x.second, x.state, x.elongation, x.elongation_back, x.normal_force,
                       x.tangential_force, x.elastic, x.viscous),
              std::tie(y.first, y.second, y.state, y.elongation, y.elongation_back, y.normal_force,
                       y.tangential_force, y.elastic, y.viscous));
    EXPECT_EQ(x.force, y.force);
  }
}

}  // namespace supple::testing
