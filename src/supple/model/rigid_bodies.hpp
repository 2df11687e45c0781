/// Bodies that move as one piece: plain data.
#pragma once
#include <cstdint>
#include <vector>

#include "supple/core/vec.hpp"

namespace supple {

/// Which bodies of a system are rigid, and how they move: rigid body r is the body `body[r]` of Topology,
/// ascending. Centre and angle say where it is; its sites follow from them (place_sites), never the other
/// way. Like positions neither is ever wrapped. 2D.
struct RigidBodies {
  std::vector<std::int32_t> body;
  std::vector<Vec2> centre, velocity;  ///< of the centre of mass [length], [length/time]
  std::vector<double> angle, spin;     ///< turned since it became rigid, counter-clockwise [radian], [1/time]
  /// Sum of the masses of its sites, and sum m r^2 about the centre. Sites are points here, without inertia
  /// of their own, as the vertices of deformable bodies are: a rigid body is the limit of a stiff one.
  std::vector<double> mass, inertia;
  /// Sites from the centre at angle 0 [length]: those of rigid body r are [begin[r], begin[r+1]), in the
  /// order of its sites.
  std::vector<std::int32_t> begin;
  std::vector<Vec2> offset;

  bool empty() const { return body.empty(); }
  int size() const { return static_cast<int>(body.size()); }
};

}  // namespace supple
