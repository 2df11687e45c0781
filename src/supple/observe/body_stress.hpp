/// Stress of a cell of bodies, and of each body in it.
#pragma once
#include <span>
#include <type_traits>
#include <vector>

#include "supple/contact/laws/table.hpp"
#include "supple/contact/record.hpp"
#include "supple/force/force_field.hpp"
#include "supple/model/evaluation.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// Parts of the stress of a cell of area (3D: volume) A [MacKeith 2025, eq. 9.23-9.27], compression positive;
/// entry [i][j]: force along i, position along j. In F l^T of a contact F acts on a site, and l leads from
/// the other site to it.
template <int Dim>
struct BodyStresses {
  Mat<Dim> kinetic;  ///< (1/A) sum m u u^T, velocities relative to the flow
  Mat<Dim> shape;    ///< (1/A) sum F r^T over all sites, F of the shape energy or what keeps a body rigid, r
                     ///< unwrapped
  Mat<Dim>
      contact;    ///< (1/A) sum F l^T over contacts between bodies: what some codes call the pressure; with
                  ///< friction, viscosity and links, of a force field that has them, half to each body
  Mat<Dim> wall;  ///< (1/A) sum F l^T over sites on walls
  /// Of each body, its area times its static stress (9.27): the part of its shape and its shares of contacts
  /// [energy]. The sum over bodies is the area of the cell times virial().
  std::vector<Mat<Dim>> moment;

  /// The static stress, -(1/A) dU/d(strain). It is Evaluation::virial over A, except that `shape` also holds
  /// the inertia of sites of rigid bodies that turn.
  Mat<Dim> virial() const { return shape + contact + wall; }
  /// The full stress (9.26).
  Mat<Dim> total() const { return kinetic + virial(); }
  /// Stress of each body (9.27): its moment over its area, for which the caller chooses a definition, such as
  /// (9.21).
  std::vector<Mat<Dim>> of_bodies(std::span<const double> area) const;
};

/// Mean normal stress, positive in compression.
template <int Dim>
double pressure(const Mat<Dim>& stress) {
  double trace = stress[0][0];
  for (int d = 1; d < Dim; ++d) trace += stress[d][d];
  return Dim == 2 ? 0.5 * trace : trace / Dim;
}
/// Shear stress -Sigma_xy, of the symmetric part.
template <int Dim>
double shear_stress(const Mat<Dim>& stress) {
  return -0.5 * (stress[0][1] + stress[1][0]);
}

/// Stresses of a system with these forces of shape energy on the sites, contacts, and forces of walls. A
/// contact is shared between its two bodies in proportion to the parts of its line on either side of the
/// chord through the points where the two circles cross (the contact line of 9.27), in halves for sites of
/// equal radius. The shares add to one, so that the moments of bodies add to the whole.
template <int Dim>
BodyStresses<Dim> body_stresses(const System<Dim>& system,
                                std::type_identity_t<std::span<const Vec<Dim>>> shape_force,
                                const std::vector<ContactRecord<Dim>>& records, const ContactLaws& laws,
                                std::type_identity_t<std::span<const SiteForce<Dim>>> wall = {});

/// The same for a force field of bodies, at the instant of `evaluation`. The shape force on a site of a rigid
/// body is what keeps it in its place there: mass times acceleration less all other forces.
/// Evaluation::virial has these forces for bodies at rest.
template <int Dim>
BodyStresses<Dim> body_stresses(const System<Dim>& system, ForceField<Dim>& field,
                                const Evaluation<Dim>& evaluation);

}  // namespace supple
