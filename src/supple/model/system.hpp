/// Everything that a checkpoint must hold.
#pragma once
#include <cstdint>
#include <vector>

#include "supple/model/box.hpp"
#include "supple/model/pair_table.hpp"
#include "supple/model/rigid_bodies.hpp"
#include "supple/model/shape.hpp"
#include "supple/model/state.hpp"
#include "supple/model/topology.hpp"
#include "supple/model/touch_table.hpp"

namespace supple {

template <int Dim>
struct System {
  Box<Dim> box;
  State<Dim> state;
  Topology<Dim> topology;
  Shape shape;
  RigidBodies rigid;  ///< empty: every body deforms
  PairTable pairs;
  TouchTable touches;       ///< of bodies of many sites, where contacts remember
  std::vector<Link> links;  ///< between bodies of many sites, ascending by (first, second)
  /// Where each site sticks to the floor, along it; not a number where it does not. Empty: no floor with
  /// friction.
  std::vector<double> floor_contact;
  double time = 0;
  /// Time over which the present velocities carried the positions while contact history has not yet followed:
  /// the last step of a leapfrog, 0 where position and velocity are of one instant.
  double lag = 0;
  std::int64_t step = 0;
};

}  // namespace supple
