/// Everything that a checkpoint must hold.
#pragma once
#include <cstdint>
#include <vector>

#include "supple/model/body_terms.hpp"
#include "supple/model/box.hpp"
#include "supple/model/pair_table.hpp"
#include "supple/model/rigid_bodies.hpp"
#include "supple/model/shape.hpp"
#include "supple/model/solid.hpp"
#include "supple/model/state.hpp"
#include "supple/model/topology.hpp"
#include "supple/model/touch_table.hpp"

namespace supple {

/// How fast velocities and spins changed in the last step of a leapfrog, beside the change of the flow: by
/// this, those that lag are brought to the instant of the positions before the forces there are known. Arrays
/// over sites and over rigid bodies. Those of other sites or bodies (knows_acceleration) count as 0.
template <int Dim>
struct Acceleration {
  std::vector<Vec<Dim>> site;            ///< [length/time^2]
  std::vector<Angular<Dim>> spin;        ///< [1/time^2]
  std::vector<Vec<Dim>> rigid;           ///< [length/time^2]
  std::vector<Angular<Dim>> rigid_spin;  ///< [1/time^2]
};

/// The whole state of a simulation.
template <int Dim>
struct System {
  Box<Dim> box;
  State<Dim> state;
  Topology<Dim> topology;
  Shape shape;
  Solid<Dim> solid;                 ///< empty: no body has an inside
  std::vector<BodyTermData> terms;  ///< what else acts on whole bodies
  /// Of each body, its place among the species of its sample, on which the laws of its contacts depend.
  /// Bodies beyond the end are of the first.
  std::vector<std::int32_t> species;
  RigidBodiesOf<Dim> rigid;  ///< empty: every body deforms
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
  Acceleration<Dim> acceleration;
  std::int64_t step = 0;

  bool knows_acceleration() const {
    return !acceleration.site.empty() && acceleration.site.size() == state.position.size() &&
           acceleration.spin.size() == state.spin.size() && acceleration.rigid.size() == rigid.body.size() &&
           acceleration.rigid_spin.size() == rigid.body.size();
  }

  std::int32_t species_of(std::int32_t body) const {
    return static_cast<std::size_t>(body) < species.size() ? species[body] : 0;
  }
};

}  // namespace supple
