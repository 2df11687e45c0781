/// Constants of the contact law of discs from a case, a state or both, for the documented model and the
/// package alike.
#pragma once
#include "supple/experiment/case.hpp"
#include "supple/experiment/initial_state.hpp"
#include "supple/model/units.hpp"

namespace supple {

/// Links have the base constants: k, k_t = k r, eta = v sqrt(m k) (S1-9) and eta_t = eta r, r being the
/// transversal link strength and v the relative viscosity. Contacts have these stiffnesses times the
/// interface re-enforcements, and the viscosities too unless they are kept constant. A constant comes from
/// the state (`stored`, in the units of the run) unless the user gave a key that it depends on; if no such
/// key was given, the stored numbers pass unchanged. `k` is the spring constant of the case and `mass` the
/// mean mass m, in the units of the run. Every constant of the result is set.
MaterialConstants resolve_material(const Case& c, const MaterialConstants& stored, double k, double mass);

/// The same constants in other units.
MaterialConstants convert(MaterialConstants material, const Units& from, const Units& to);

}  // namespace supple
