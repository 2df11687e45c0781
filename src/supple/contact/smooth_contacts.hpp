/// Smooth contacts: vertices slide along the edges of other bodies.
#pragma once
#include "supple/contact/body_contacts.hpp"
#include "supple/contact/edge_candidates.hpp"
#include "supple/contact/linked_touches.hpp"
#include "supple/contact/pushes.hpp"

namespace supple {

/// Vertices against boundaries [MacKeith 2025, eq. 9.5-9.9, corrected: docs/decisions/0010]. With phi(d) the
/// energy of the law, 0 from d = sigma (times its range) on, the whole is half the sum over vertices i and
/// other bodies of
///     U_i = sum phi(d) over the edges that i faces
///         + sum phi(|r_i - r_j|) over the convex corners j that i is in front of
///         - sum phi(|r_i - r_j|) over the concave corners j where i is in the strips of both edges.
/// This is inclusion and exclusion of edges and vertices, seen from outside, and makes forces continuous
/// round every corner. The strip of an edge is what lies straight over it. A vertex faces an edge from the
/// outer half of its strip: nothing acts through a thin body, and U_i = phi(nearest distance) outside every
/// convex body. Outside any other body the same holds while the part of the boundary within sigma of i is one
/// arc; feature_violations() counts the vertices where it is not.
///
/// A vertex inside a body at a depth below sigma has the energy phi(-depth) besides: energy and force are
/// continuous where it crosses an edge, and it is pushed toward the nearest point of the boundary. A vertex
/// that lies deeper is not pushed. look_at() (observe/soundness) finds both.
///
/// Smooth discs are bodies of one site. Their centres act as vertices on polygons, with the factor 1 instead
/// of 1/2, and vertices of polygons do not act on discs. Two discs have the energy phi(distance).
class SmoothContacts final : public BodyContacts<2> {
 public:
  using BodyContacts<2>::BodyContacts;
  std::unique_ptr<BodyContacts<2>> clone() const override { return std::make_unique<SmoothContacts>(*this); }
  Meeting meeting() const override { return Meeting::facets; }
  double scale(const Ring& of_site) const override { return edge_scale(of_site); }
  void evaluate(const System<2>& system, Detail detail, Evaluation<2>& out) override;
  /// Edge records are of the sites (vertex, start, end) with weights (1, -(1-t), -t), t the place of the
  /// nearest point on the edge; corner records are of (vertex, corner). Inside, the distance is negative.
  std::vector<ContactRecord<2>> records(const System<2>& system) override;
  /// Number of vertices that the last evaluation found near a part of a boundary that is no single arc. A
  /// vertex on its way into a concave corner is among them while both edges, but not yet the corner, are
  /// within sigma.
  int feature_violations() const override { return violations_; }

 private:
  struct Sum;
  /// A force on a site from the start of an edge, or a corner, of another body; `at_end` of it from the end.
  struct Push {
    std::int32_t site, start, end;
    Vec2 force, at_end;
    double distance, energy;
    Vec2 normal;
  };
  template <bool energies, class Laws>
  void add_all(const System<2>& system, const Laws& laws, Evaluation<2>& out, Sum& sum);

  void update(const System<2>& system);
  void leave_out_linked(std::vector<std::int32_t>& selected) const;
  template <class Laws, class Meet>
  void walk_discs(const System<2>& system, const Laws& laws, const std::vector<Vec2>& shifts,
                  std::int64_t begin, std::int64_t end, const Meet& meet) const;

  EdgeCandidates candidates_;
  LinkedTouches<2> linked_;
  std::vector<std::int32_t> body_;  ///< of each site, where something is linked
  Pushes<Push> pushes_;             ///< with several threads
  int violations_ = 0;
};

}  // namespace supple
