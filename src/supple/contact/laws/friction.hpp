/// Tangential spring and dashpot with a Coulomb limit [Otsuki & Hayakawa 2017, eqs 4-6; Cundall & Strack
/// 1979].
#pragma once
#include <cmath>

#include "supple/model/pair_table.hpp"

namespace supple {

/// What the elongation u does while a contact slips. clamp: it is held so that |k_t u + eta_t v_t| = limit
/// [Cundall & Strack 1979]. freeze: it stays [Otsuki & Hayakawa 2017]. reset: it is zero (published package).
enum class Slip { clamp, freeze, reset };

/// A Slip as two numbers, so that loops over contacts need no branch: in slip u becomes keeps u + follows
/// (F_t - eta_t v_t), F_t being the limited force.
struct SlipRule {
  double keeps, follows;
  SlipRule(Slip slip, double k_t)
      : keeps(slip == Slip::freeze ? 1 : 0), follows(slip == Slip::clamp && k_t > 0 ? 1 / k_t : 0) {}
};

/// Tangential force on the first site along t [force], and what the contact will remember: elongation u
/// [length] and state.
struct TangentialResponse {
  double force, elongation;
  ContactState state;
};

/// F_t = k_t u + eta_t v_t, with u the integral of v_t dt: the bond of a permanent link, which has no limit.
/// u is the elongation of the step before, `slid` what it has gained since [length]; v_t is of the instant of
/// the force.
inline TangentialResponse bonded(double u, double slid, double v_t, double k_t, double eta_t) {
  const double elongation = u + slid;
  return {k_t * elongation + eta_t * v_t, elongation, ContactState::permanent};
}

/// The same where |F_t| <= limit = mu F_el (stick); else the limit, with the sign of F_t (slip).
inline TangentialResponse coulomb(double u, double slid, double v_t, double k_t, double eta_t, double limit,
                                  const SlipRule& slip) {
  const TangentialResponse trial = bonded(u, slid, v_t, k_t, eta_t);
  const bool sticks = std::abs(trial.force) <= limit;
  const double force = std::copysign(limit, trial.force);
  const double held = slip.keeps * u + slip.follows * (force - eta_t * v_t);
  return {sticks ? trial.force : force, sticks ? trial.elongation : held,
          sticks ? ContactState::stick : ContactState::slip};
}

/// Energy that the spring stores [energy], and power lost to the dashpot and by sliding [energy/time].
struct TangentialBooks {
  double energy, viscous_power, sliding_power;
};

/// The books of the response `r` after a step of dt in which the sides slid by `slid`, from the elongation u
/// before. The spring gives up its mean force over the step times the way that it did not follow; the rest of
/// the force acts at the speed v_t. In slip the dashpot has a part in the force with Slip::clamp only;
/// otherwise all loss is by sliding.
inline TangentialBooks book(const TangentialResponse& r, double u, double slid, double v_t, double dt,
                            double k_t, Slip slip) {
  const bool slides = r.state == ContactState::slip, freely = slides && slip != Slip::clamp;
  const double dashpot = (r.force - k_t * r.elongation) * v_t, to = r.elongation;
  const double given_up = slides && dt > 0 ? 0.5 * k_t * (u + to) * (slid - (to - u)) / dt : 0;
  return {0.5 * k_t * to * to, freely ? 0 : dashpot, given_up + (freely ? dashpot : 0)};
}

}  // namespace supple
