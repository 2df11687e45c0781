/// A heap of particles under gravity on a floor: its shape, and the forces that bear it.
#pragma once
#include <utility>
#include <vector>

#include "supple/experiment/observable.hpp"
#include "supple/force/force_field.hpp"
#include "supple/observe/wall_forces.hpp"

namespace supple {

/// What is measured of a heap at one instant; energies in units of the run.
struct Heap {
  double time = 0, kinetic = 0, potential = 0;
  double height = 0;          ///< mean height of the mass [length]
  double front = 0, top = 0;  ///< rightmost and highest end of a particle [length]
  double spread =
      0;  ///< twice the mean distance of the mass from the left wall: the width of a heap that is flat
  double slope = 0;      ///< of the line fitted to the surface; positive: downward to the right
  WallForces walls;      ///< [weight of all particles]
  double motion = 0;     ///< kinetic energy over that of a fall of all particles by their mean diameter
  double imbalance = 0;  ///< largest net force on a particle over its weight

  void keep(Keeper& k) {
    k("time", time);
    k("kinetic", kinetic);
    k("potential", potential);
    k("height", height);
    k("front", front);
    k("top", top);
    k("spread", spread);
    k("slope", slope);
    k("left", walls.left);
    k("right", walls.right);
    k("floor", walls.floor);
    k("lid", walls.lid);
    k("drag", walls.drag);
    k("motion", motion);
    k("imbalance", imbalance);
  }
};

/// Measures the heap at the instant of `evaluation`, which must hold energies. There must be gravity.
Heap measure_heap(const System<2>& system, ForceField<2>& field, const Evaluation<2>& evaluation);

/// Whether the heap lies still: Heap::motion is below `motion`, and the forces on every particle balance to 1
/// % of its weight. The second condition matters at the top of a bounce, where nothing moves but nothing
/// bears the weight.
bool is_at_rest(const Heap& heap, double motion);

/// The columns of the table of a heap.
const Observables<Heap>& heap_observables();

/// Weight of all sites [force].
double weight(const System<2>& system, ForceField<2>& field);

/// Mean and largest diameter of the circles round the bodies (outer_radius) [length].
double mean_diameter(const System<2>& system);
double widest_diameter(const System<2>& system);

}  // namespace supple
