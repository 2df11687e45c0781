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
template <int Dim>
struct WallLaw {
  Harmonic repulsion{4, false};
  /// Coulomb coefficient of the floor, the lower wall of the gradient direction; 2D alone has such a floor.
  double floor_friction = 0;
  double floor_stiffness =
      0.5;  ///< of the spring to the point where a site sticks, over that of the repulsion
  std::array<std::array<bool, 2>, Dim> stands = all_stand();

  static constexpr std::array<std::array<bool, 2>, Dim> all_stand() {
    std::array<std::array<bool, 2>, Dim> all{};
    for (auto& of_direction : all) of_direction = {true, true};
    return all;
  }
};

/// Adds forces and, with Detail::energies, energy.wall, energy.tangential of the springs of the floor, and
/// the virial (walls move with the cell). Lists the forces in `out.wall` and, with friction, fills the points
/// of the floor where sites stick (trial_floor_contact).
/// Input error where the floor of a 3D system has friction.
template <int Dim>
void evaluate_walls(const System<Dim>& system, const WallLaw<Dim>& walls, Detail detail,
                    Evaluation<Dim>& out);
/// Adds the second derivatives of the repulsion; friction has none.
template <int Dim>
void add_wall_hessian(const System<Dim>& system, const WallLaw<Dim>& walls, HessianBlocks<Dim>& blocks);

}  // namespace supple
