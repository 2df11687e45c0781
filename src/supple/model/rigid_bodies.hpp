/// Bodies that move as one piece: plain data.
#pragma once
#include <cstdint>
#include <vector>

#include "supple/core/vec.hpp"

namespace supple {

/// Which bodies of a 2D system are rigid, and how they move. Rigid body r is the body `body[r]` of Topology,
/// ascending. Its centre and angle say where it is; its sites follow from these (place_sites), never the
/// other way round. The angle is never wrapped, the centre where the cell is sheared (wrap_bodies).
struct RigidBodies {
  std::vector<std::int32_t> body;
  std::vector<Vec2> centre, velocity;  ///< of the centre of mass [length], [length/time]
  std::vector<double> angle, spin;     ///< since it became rigid, counter-clockwise [radian]; [1/time]
  /// Sum of the masses of its sites, and sum m r^2 about the centre. Sites count as points, without inertia
  /// of their own, as in deformable bodies: a rigid body is the limit of a stiff one.
  std::vector<double> mass, inertia;
  /// Vectors from the centre to the sites at angle 0 [length]: those of rigid body r are offset[begin[r]] to
  /// offset[begin[r+1] - 1], in the order of its sites.
  std::vector<std::int32_t> begin;
  std::vector<Vec2> offset;

  bool empty() const { return body.empty(); }
  int size() const { return static_cast<int>(body.size()); }
};

}  // namespace supple
