/// Everything that a checkpoint must hold.
#pragma once
#include <cstdint>
#include <vector>

#include "supple/model/body_terms.hpp"
#include "supple/model/box.hpp"
#include "supple/model/pair_table.hpp"
#include "supple/model/rigid_bodies.hpp"
#include "supple/model/shape.hpp"
#include "supple/model/state.hpp"
#include "supple/model/topology.hpp"
#include "supple/model/touch_table.hpp"

namespace supple {

/// The whole state of a simulation.
template <int Dim>
struct System {
  Box<Dim> box;
  State<Dim> state;
  Topology<Dim> topology;
  Shape shape;
  std::vector<BodyTermData> terms;  ///< what else acts on whole bodies
  /// Of each body, its place among the species of its sample, on which the laws of its contacts depend.
  /// Bodies beyond the end are of the first.
  std::vector<std::int32_t> species;
  RigidBodies rigid;  ///< empty: every body deforms
  PairTable pairs;
  TouchTable touches;       ///< of bodies of many sites, where contacts remember
  std::vector<Link> links;  ///< between bodies of many sites, ascending by (first, second)
  /// Where along the floor each site sticks to it [length]; not a number where it does not. Empty: no floor
  /// with friction.
  std::vector<double> floor_contact;
  double time = 0;
  /// The last step of a leapfrog [time]: the present velocities have carried the positions over it, and are
  /// half of it behind them; the memory of contacts has not followed yet. 0: positions, velocities and memory
  /// are of one instant.
  double lag = 0;
  std::int64_t step = 0;

  std::int32_t species_of(std::int32_t body) const {
    return static_cast<std::size_t>(body) < species.size() ? species[body] : 0;
  }
};

}  // namespace supple
