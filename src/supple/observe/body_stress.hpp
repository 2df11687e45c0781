/// Stress of a cell of bodies, and of each body in it.
#pragma once
#include <span>
#include <vector>

#include "supple/contact/laws/body.hpp"
#include "supple/contact/record.hpp"
#include "supple/force/force_field.hpp"
#include "supple/model/evaluation.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// Parts of the stress of a cell of area A [MacKeith 2025, eq. 9.23-9.27], compression positive; entry
/// [i][j]: force along i, position along j. F l^T of a contact: F on a site, l from the other one to it.
struct BodyStresses {
  Mat2 kinetic;  ///< (1/A) sum m u u^T, velocities relative to the flow
  Mat2 shape;    ///< (1/A) sum F r^T over all sites, F of the shape energy or what keeps a body rigid, r
                 ///< unwrapped
  Mat2 contact;  ///< (1/A) sum F l^T over contacts between bodies: what some codes call the pressure; with
                 ///< friction, viscosity and links, of a force field that has them, half to each body
  Mat2 wall;     ///< (1/A) sum F l^T over sites on walls
  /// Of each body: area times its static stress (9.27), its shape part and its shares of contacts [energy].
  /// They add to the area of the cell times virial().
  std::vector<Mat2> moment;

  /// The static stress: -(1/A) dU/d(strain); Evaluation::virial per area, but for the inertia of the sites of
  /// rigid bodies that turn.
  Mat2 virial() const { return shape + contact + wall; }
  /// The full stress (9.26).
  Mat2 total() const { return kinetic + virial(); }
  /// Stress of each body on its area (9.27), which may be any that the bodies are said to have (9.21).
  std::vector<Mat2> of_bodies(std::span<const double> area) const;
};

/// Mean normal stress, positive in compression.
inline double pressure(const Mat2& stress) { return 0.5 * (stress[0][0] + stress[1][1]); }
/// Shear stress -Sigma_xy, of the symmetric part.
inline double shear_stress(const Mat2& stress) { return -0.5 * (stress[0][1] + stress[1][0]); }

/// Stresses of a system whose sites bear these shape forces, contacts and forces of walls. A contact goes to
/// its two bodies in proportion to the parts of its line on either side of the chord through the points where
/// the two circles cross (the contact line of 9.27), for sites of equal radius in halves: the shares add to
/// one, so that the moments of bodies add to the whole.
BodyStresses body_stresses(const System<2>& system, std::span<const Vec2> shape_force,
                           const std::vector<ContactRecord<2>>& records, const BodyLaw& law,
                           std::span<const SiteForce<2>> wall = {});

/// The same of a force field of bodies, at the instant of `evaluation`. The shape forces of rigid bodies are
/// what keeps their sites together: mass times acceleration less all other forces. Evaluation::virial has
/// them at rest.
BodyStresses body_stresses(const System<2>& system, ForceField& field, const Evaluation<2>& evaluation);

}  // namespace supple
