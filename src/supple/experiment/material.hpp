/// Constants of the contact law from a case, from a state, or from both: one rule for both fidelities.
#pragma once
#include "supple/experiment/case.hpp"
#include "supple/experiment/initial_state.hpp"
#include "supple/model/units.hpp"

namespace supple {

/// Base constants, those of links: k, k_t = k times the transversal strength, eta = v sqrt(m k) (S1-9), eta_t
/// likewise. Contacts: stiffness times the interface re-enforcements, viscosities too unless they are kept
/// constant. A constant comes from the state (`stored`, in the units of the run) unless the user gave a key
/// that it depends on; without any such key the stored numbers pass untouched. `k` is the case's own spring
/// and `mass` the mean mass, in the units of the run. Every constant of the result is set.
MaterialConstants resolve_material(const Case& c, const MaterialConstants& stored, double k, double mass);

/// The same constants in other units.
MaterialConstants convert(MaterialConstants material, const Units& from, const Units& to);

}  // namespace supple
