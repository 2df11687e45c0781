/// Smooth contacts: vertices slide along the edges of other bodies.
#pragma once
#include "supple/contact/body_contacts.hpp"
#include "supple/contact/edge_candidates.hpp"
#include "supple/contact/linked_touches.hpp"

namespace supple {

/// Vertex against boundary [MacKeith 2025, eq. 9.5-9.9, corrected]. With phi(d) the law below d =
/// sigma, or as far as it goes, half the sum over vertices i and other bodies of
///     U_i = sum phi(d) over the edges that i faces  +  sum phi(|r_i - r_j|) over convex corners j that it is
///     in front of
///         - sum phi(|r_i - r_j|) over concave corners j where the strips of both edges overlap.
/// It is the inclusion and exclusion of edges and vertices, seen from outside: forces are continuous round
/// every corner. An edge is faced from the outer half of the strip over it, so that nothing acts through a
/// thin body and that U_i = phi(nearest distance) outside of every convex body. It is so outside any body
/// while sigma is below the local feature size, that is while what lies within sigma of i is one arc of the
/// boundary: feature_violations() counts where it is not.
///
/// A vertex that is inside a body, not deeper than sigma, feels phi(-depth) beside: energy and force go on
/// where it crosses an edge, and it is pushed out to the nearest point of the boundary; nothing
/// pushes out a deeper one. look_at() (observe/soundness) finds both.
///
/// Smooth discs are bodies of one site. Their centres act as vertices against polygons, with factor 1 instead
/// of 1/2, and the polygon's vertices do not act on the disc; two discs meet once, phi(distance).
class SmoothContacts final : public BodyContacts {
 public:
  using BodyContacts::BodyContacts;
  Meeting meeting() const override { return Meeting::facets; }
  double scale(const Ring& of_site) const override { return edge_scale(of_site); }
  void evaluate(const System<2>& system, Detail detail, Evaluation<2>& out) override;
  /// Edges as (vertex, start, end) with weights (1, -(1-t), -t), corners as (vertex, corner); inside, the
  /// distance is negative.
  std::vector<ContactRecord<2>> records(const System<2>& system) override;
  /// Vertices that the last evaluation found near a part of a body that is no simple arc. Also on the way
  /// into a concave corner, where both of its edges are already within sigma and the corner is not yet.
  int feature_violations() const override { return violations_; }

 private:
  struct Sum;
  template <bool energies, class Law>
  void add_all(const System<2>& system, const Law& law, Evaluation<2>& out, Sum& sum);

  void update(const System<2>& system);
  void select_acting(const System<2>& system);
  template <class Meet>
  void walk_discs(const System<2>& system, const Meet& meet);

  EdgeCandidates candidates_;
  LinkedTouches linked_;
  std::vector<std::int32_t> body_;  ///< of each site, where something is linked
  std::vector<std::int32_t> selected_;
  int violations_ = 0;
};

}  // namespace supple
