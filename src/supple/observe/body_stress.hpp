/// Stress of a cell of bodies, and of each body in it.
#pragma once
#include <span>
#include <vector>

#include "supple/contact/laws/table.hpp"
#include "supple/contact/record.hpp"
#include "supple/force/force_field.hpp"
#include "supple/model/evaluation.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// Parts of the stress of a cell of area A [MacKeith 2025, eq. 9.23-9.27], compression positive; entry
/// [i][j]: force along i, position along j. In F l^T of a contact F acts on a site, and l leads from the
/// other site to it.
struct BodyStresses {
  Mat2 kinetic;  ///< (1/A) sum m u u^T, velocities relative to the flow
  Mat2 shape;    ///< (1/A) sum F r^T over all sites, F of the shape energy or what keeps a body rigid, r
                 ///< unwrapped
  Mat2 contact;  ///< (1/A) sum F l^T over contacts between bodies: what some codes call the pressure; with
                 ///< friction, viscosity and links, of a force field that has them, half to each body
  Mat2 wall;     ///< (1/A) sum F l^T over sites on walls
  /// Of each body, its area times its static stress (9.27): the part of its shape and its shares of contacts
  /// [energy]. The sum over bodies is the area of the cell times virial().
  std::vector<Mat2> moment;

  /// The static stress, -(1/A) dU/d(strain). It is Evaluation::virial over A, except that `shape` also holds
  /// the inertia of sites of rigid bodies that turn.
  Mat2 virial() const { return shape + contact + wall; }
  /// The full stress (9.26).
  Mat2 total() const { return kinetic + virial(); }
  /// Stress of each body (9.27): its moment over its area, for which the caller chooses a definition, such as
  /// (9.21).
  std::vector<Mat2> of_bodies(std::span<const double> area) const;
};

/// Mean normal stress, positive in compression.
template <int Dim>
double pressure(const Mat<Dim>& stress) {
  double trace = stress[0][0];
  for (int d = 1; d < Dim; ++d) trace += stress[d][d];
  return Dim == 2 ? 0.5 * trace : trace / Dim;
}
/// Shear stress -Sigma_xy, of the symmetric part.
inline double shear_stress(const Mat2& stress) { return -0.5 * (stress[0][1] + stress[1][0]); }

/// Stresses of a system with these forces of shape energy on the sites, contacts, and forces of walls. A
/// contact is shared between its two bodies in proportion to the parts of its line on either side of the
/// chord through the points where the two circles cross (the contact line of 9.27), in halves for sites of
/// equal radius. The shares add to one, so that the moments of bodies add to the whole.
BodyStresses body_stresses(const System<2>& system, std::span<const Vec2> shape_force,
                           const std::vector<ContactRecord<2>>& records, const ContactLaws& laws,
                           std::span<const SiteForce<2>> wall = {});

/// The same for a force field of bodies, at the instant of `evaluation`. The shape force on a site of a rigid
/// body is what keeps it in its place there: mass times acceleration less all other forces.
/// Evaluation::virial has these forces for bodies at rest.
BodyStresses body_stresses(const System<2>& system, ForceField<2>& field, const Evaluation<2>& evaluation);

}  // namespace supple
