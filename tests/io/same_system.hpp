/// Whether two systems are the same, bit for bit.
#pragma once
#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "supple/model/system.hpp"

namespace supple::testing {

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

template <int Dim>
void expect_same(const System<Dim>& a, const System<Dim>& b) {
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.lag, b.lag);
  EXPECT_EQ(a.step, b.step);
  EXPECT_EQ(a.box.length, b.box.length);
  EXPECT_EQ(a.box.periodic, b.box.periodic);
  EXPECT_EQ(a.box.strain, b.box.strain);
  EXPECT_EQ(a.box.strain_rate, b.box.strain_rate);
  EXPECT_TRUE(same_bits(a.state.position, b.state.position));
  EXPECT_TRUE(same_bits(a.state.velocity, b.state.velocity));
  EXPECT_TRUE(same_bits(a.acceleration.site, b.acceleration.site));
  EXPECT_TRUE(same_bits(a.acceleration.spin, b.acceleration.spin));
  EXPECT_TRUE(same_bits(a.acceleration.rigid, b.acceleration.rigid));
  EXPECT_TRUE(same_bits(a.acceleration.rigid_spin, b.acceleration.rigid_spin));
  EXPECT_TRUE(same_bits(a.state.mass, b.state.mass));
  EXPECT_TRUE(same_bits(a.state.radius, b.state.radius));
  EXPECT_TRUE(same_bits(a.state.angle, b.state.angle));
  EXPECT_TRUE(same_bits(a.state.spin, b.state.spin));
  EXPECT_TRUE(same_bits(a.state.inertia, b.state.inertia));
  EXPECT_EQ(a.state.mobility, b.state.mobility);
  EXPECT_EQ(a.topology.begin, b.topology.begin);
  EXPECT_EQ(a.topology.facet_begin, b.topology.facet_begin);
  EXPECT_EQ(a.topology.hinge_begin, b.topology.hinge_begin);
  EXPECT_EQ(a.topology.facet, b.topology.facet);
  EXPECT_EQ(a.topology.hinge, b.topology.hinge);
  EXPECT_TRUE(same_bits(a.shape.stiffness, b.shape.stiffness));
  EXPECT_TRUE(same_bits(a.shape.rest_volume, b.shape.rest_volume));
  EXPECT_TRUE(same_bits(a.shape.rest_facet, b.shape.rest_facet));
  EXPECT_TRUE(same_bits(a.shape.rest_hinge, b.shape.rest_hinge));
  EXPECT_EQ(a.solid.bond_begin, b.solid.bond_begin);
  EXPECT_EQ(a.solid.element_begin, b.solid.element_begin);
  EXPECT_EQ(a.solid.bond, b.solid.bond);
  EXPECT_EQ(a.solid.element, b.solid.element);
  EXPECT_TRUE(same_bits(a.solid.stiffness, b.solid.stiffness));
  EXPECT_TRUE(same_bits(a.solid.rest_bond, b.solid.rest_bond));
  EXPECT_TRUE(same_bits(a.solid.rest_element, b.solid.rest_element));
  ASSERT_EQ(a.terms.size(), b.terms.size());
  for (std::size_t k = 0; k < a.terms.size(); ++k) {
    EXPECT_EQ(a.terms[k].name, b.terms[k].name);
    EXPECT_EQ(a.terms[k].width, b.terms[k].width);
    EXPECT_TRUE(same_bits(a.terms[k].number, b.terms[k].number));
  }
  EXPECT_EQ(a.species, b.species);
  EXPECT_EQ(a.rigid.body, b.rigid.body);
  EXPECT_TRUE(same_bits(a.rigid.centre, b.rigid.centre));
  EXPECT_TRUE(same_bits(a.rigid.velocity, b.rigid.velocity));
  EXPECT_TRUE(same_bits(a.rigid.angle, b.rigid.angle));
  EXPECT_TRUE(same_bits(a.rigid.spin, b.rigid.spin));
  EXPECT_TRUE(same_bits(a.rigid.mass, b.rigid.mass));
  EXPECT_TRUE(same_bits(a.rigid.inertia, b.rigid.inertia));
  EXPECT_EQ(a.rigid.begin, b.rigid.begin);
  EXPECT_TRUE(same_bits(a.rigid.offset, b.rigid.offset));
  EXPECT_TRUE(same_bits(a.floor_contact, b.floor_contact));
  EXPECT_EQ(a.pairs.begin, b.pairs.begin);
  EXPECT_EQ(a.pairs.first, b.pairs.first);
  EXPECT_EQ(a.pairs.second, b.pairs.second);
  EXPECT_EQ(a.pairs.state, b.pairs.state);
  EXPECT_EQ(a.pairs.width, b.pairs.width);
  EXPECT_TRUE(same_bits(a.pairs.history, b.pairs.history));
  EXPECT_TRUE(a.touches.rows == b.touches.rows);
  EXPECT_TRUE(a.links == b.links);
}

}  // namespace supple::testing
