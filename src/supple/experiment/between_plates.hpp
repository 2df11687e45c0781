/// One particle between two flat, rigid plates: how it gets there, and steps of the upper plate.
#pragma once
#include <string>
#include <vector>

#include "supple/experiment/packing.hpp"
#include "supple/experiment/sound_states.hpp"
#include "supple/observe/touching_plates.hpp"

namespace supple {

/// Compressions delta/D of the case in their order: none, those of the way down, and the same ones of the way
/// up where there is one.
struct PlateCourse {
  std::vector<double> compression;
  std::size_t turn = 0;  ///< place of the largest

  bool is_down(std::size_t step) const { return step <= turn; }
};
PlateCourse plate_course(const PlateCompression& plates);

/// The particle of the case, or of a state, in equilibrium or on its way to it, far from both plates. These
/// are walls across the last direction with the springs contact.k_p; all other directions are open. Input
/// error where there is not one particle.
template <int Dim>
Packing<Dim> packing_between_plates(const Case& c, const InitialState* initial, const Making& making);

/// How far the compression of a particle has got.
template <int Dim>
struct PlateState {
  double diameter = 0;                ///< distance of the plates at first touch [length]
  double volume = 0;                  ///< that the particle encloses there [length^Dim]
  double width = 0;                   ///< mean extent along the plates there [length]
  std::vector<Vec<Dim>> shape;        ///< positions there [length]
  std::vector<double> before;         ///< degrees of freedom of the equilibrium before the last one
  double gap_before = 0;              ///< and its distance of the plates [length]
  std::int64_t step = -1;             ///< next place in the course; -1: the particle has not been put there
  double work_down = 0, work_up = 0;  ///< of the upper plate on its way down, and got back on the way up
  double force_before = 0;            ///< of the upper plate at the step before
  long evaluations = 0, minimisations = 0;
  MinimiseReport last;

  void keep(Keeper& k);
};

/// Finds the equilibrium of the particle alone, turns it as the case says (a state stays as it is) and puts
/// it between plates that just touch it. Numerics error where there is no equilibrium.
template <int Dim>
void touch_plates(const Case& c, const InitialState* initial, Packing<Dim>& packing, PlateState<Dim>& state);

/// Moves the upper plate to this distance from the lower one and finds the equilibrium, until no net force is
/// above minimise.force_tolerance times the mean force of a site that touches a plate. The minimisation
/// starts from the state of lowest energy among: the last one compressed evenly, and what the last two
/// equilibria lead to if all goes on along a straight line. Nothing holds the particle along the plates or
/// keeps it from rolling. Numerics error, at the last equilibrium, where there is none.
template <int Dim>
void move_plate(const Case& c, Packing<Dim>& packing, PlateState<Dim>& state, double gap);

/// The unit of dimensionless forces between plates, and its name: E D^(Dim-1)/(1 - nu^2) of particles that
/// have a Young's modulus and a Poisson's ratio; else the unit of pressures of the packing times D^(Dim-1).
/// [force].
struct ForceUnit {
  double value;
  std::string symbol;
};
template <int Dim>
ForceUnit plate_force_unit(const Packing<Dim>& packing, double diameter);

}  // namespace supple
