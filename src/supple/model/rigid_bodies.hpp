/// Bodies that move as one piece: plain data.
#pragma once
#include <cstdint>
#include <vector>

#include "supple/core/vec.hpp"

namespace supple {

/// Numbers that say where a rigid body is: coordinates of its centre, and its angles.
template <int Dim>
inline constexpr int rigid_numbers = Dim*(Dim + 1) / 2;

/// Which bodies of a system are rigid, and how they move. Rigid body r is the body `body[r]` of Topology,
/// ascending. Its centre and angle say where it is; its sites follow from these (place_sites), never the
/// other way round. In 2D the angle is never wrapped; in 3D it is a rotation vector (core/rotation.hpp),
/// which a minimisation replaces by the shortest of the same rotation. Centres are wrapped where the cell is
/// sheared (wrap_bodies).
template <int Dim>
struct RigidBodiesOf {
  std::vector<std::int32_t> body;
  std::vector<Vec<Dim>> centre, velocity;  ///< of the centre of mass [length], [length/time]
  /// Since it became rigid, counter-clockwise [radian]; [1/time].
  std::vector<Angular<Dim>> angle, spin;
  /// Sum of the masses of its sites, and sum m r^2 about the centre (3D: the tensor sum m (r^2 I - r r^T), at
  /// angle 0). Sites count as points, without inertia of their own, as in deformable bodies: a rigid body is
  /// the limit of a stiff one.
  std::vector<double> mass;
  std::vector<Inertia<Dim>> inertia;
  /// Vectors from the centre to the sites at angle 0 [length]: those of rigid body r are offset[begin[r]] to
  /// offset[begin[r+1] - 1], in the order of its sites.
  std::vector<std::int32_t> begin;
  std::vector<Vec<Dim>> offset;

  bool empty() const { return body.empty(); }
  int size() const { return static_cast<int>(body.size()); }
};
using RigidBodies = RigidBodiesOf<2>;

}  // namespace supple
