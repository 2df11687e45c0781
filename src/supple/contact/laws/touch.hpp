/// Friction and viscosity of contacts between bodies of many sites.
#pragma once
#include <algorithm>
#include <cmath>

#include "supple/contact/laws/friction.hpp"

namespace supple {

/// Whether the normal dashpot of a contact that opens may pull beyond its elastic repulsion.
enum class ViscousPull { never, allowed };

/// Parameters that all contacts share. Where the elastic energy of a contact has the factor 1/2 [MacKeith
/// 2025, eq. 9.5], stiffness and viscosities have it too (`scale`).
struct TouchLaw {
  double friction = 0;  ///< mu
  double k_t = 0;       ///< tangential stiffness [force/length]
  double eta = 0;       ///< normal viscosity [force/speed]
  double eta_t = 0;     ///< tangential viscosity [force/speed]
  Slip slip = Slip::clamp;
  ViscousPull pull = ViscousPull::never;
};

/// Tangential stiffness k_t = ratio k_c [force/length], k_c the stiffness of contacts.
inline double tangential_stiffness(double ratio, double k_c) { return ratio * k_c; }
/// Viscosity eta = v sqrt(m k_c) [force/speed], v the relative viscosity and m the mean mass of two sites
/// (S1-9).
inline double viscosity(double relative, double mass, double k_c) { return relative * std::sqrt(mass * k_c); }

/// The relative motion of the two sides of a contact: speed of separation v_n = v.n and v_t = v.t
/// [length/time].
struct TouchMotion {
  double v_n, v_t;
};

/// Forces on the side that n points to [force]: `viscous` along n, `tangential` along -t.
struct TouchResponse {
  double viscous;
  TangentialResponse tangential;
};

/// Friction and viscosity of a contact. `elastic` is its elastic force, positive for repulsion; `scale` the
/// factor on its elastic energy; `slid` the tangential way of the last step, u the elongation before it
/// [length]. A contact that pulls has no friction, and its dashpot pulls only with ViscousPull::allowed.
inline TouchResponse respond_touch(const TouchLaw& law, double scale, double elastic, const TouchMotion& m,
                                   double slid, double u) {
  const double repulsion = std::max(elastic, 0.0);
  const double free = -scale * law.eta * m.v_n, k_t = scale * law.k_t;
  const double viscous = law.pull == ViscousPull::allowed ? free : std::max(free, -repulsion);
  return {viscous,
          coulomb(u, slid, m.v_t, k_t, scale * law.eta_t, law.friction * repulsion, {law.slip, k_t})};
}

/// A permanent link: a central spring in both directions, a central dashpot, and a tangential spring and
/// dashpot without a Coulomb limit.
struct LinkLaw {
  double k = 0, eta = 0, k_t = 0, eta_t = 0;  ///< [force/length], [force/speed]

  double energy(double d, double rest) const { return 0.5 * k * (d - rest) * (d - rest); }
  /// Repulsion of the spring [force]: positive where compressed, negative where stretched.
  double force(double d, double rest) const { return k * (rest - d); }
};

}  // namespace supple
