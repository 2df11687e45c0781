/// Repulsive walls where the cell is not periodic, and a floor with Coulomb friction.
#pragma once
#include <array>

#include "supple/contact/laws/harmonic.hpp"
#include "supple/model/evaluation.hpp"
#include "supple/model/hessian.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// U = (k_p/2)(sigma/2 - distance)^2 between a site of diameter sigma and a wall nearer than sigma/2. Walls
/// are at x_d = 0 and x_d = length_d in every direction d that is not periodic; a site beyond a wall is
/// pushed back. stands[d][0] and stands[d][1] say whether the lower and the upper one are there.
struct WallLaw {
  Harmonic repulsion{4, false};
  double floor_friction = 0;  ///< Coulomb coefficient of the floor, the lower wall of the gradient direction
  double floor_stiffness =
      0.5;  ///< of the spring to the point where a site sticks, over that of the repulsion
  std::array<std::array<bool, 2>, 2> stands{{{true, true}, {true, true}}};
};

/// Adds forces and, with Detail::energies, energy.wall, energy.tangential of the springs of the floor, and
/// the virial (walls move with the cell). Lists the forces in `out.wall` and, with friction, fills the points
/// of the floor where sites stick (trial_floor_contact).
void evaluate_walls(const System<2>& system, const WallLaw& walls, Detail detail, Evaluation<2>& out);
/// Adds the second derivatives of the repulsion; friction has none.
void add_wall_hessian(const System<2>& system, const WallLaw& walls, HessianBlocks<2>& blocks);

}  // namespace supple
