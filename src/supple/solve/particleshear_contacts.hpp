/// The two passes of a particleShear step over the contacts: forces, then elongations while the discs move.
#pragma once
#include "supple/contact/laws/particleshear.hpp"
#include "supple/model/evaluation.hpp"
#include "supple/model/system.hpp"

namespace supple::particleshear {

/// Adds forces and torques of all contacts to `out` and fills its pair rows, trial states and trial history (two
/// elongations a row). The box must be periodic in both directions.
void evaluate_contacts(const System<2>& system, const ParticleShearConstants& constants, Evaluation<2>& out);

/// Takes over the trial states and adds v_t dt to the elongations of contacts that stick or are linked. Called between
/// the change of velocities and that of positions: the package moves one disc after the other and lets each visit its
/// contacts before it moves, so `first` sees both discs where they were, `second` sees `first` where it will be.
void elongate_contacts(System<2>& system, const Evaluation<2>& evaluation, double dt);

}  // namespace supple::particleshear
