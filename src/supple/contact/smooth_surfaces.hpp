/// Smooth contacts in 3D: vertices slide over the triangles of other bodies.
#pragma once
#include "supple/contact/body_contacts.hpp"
#include "supple/contact/edge_candidates.hpp"
#include "supple/contact/facet_candidates.hpp"
#include "supple/contact/linked_touches.hpp"
#include "supple/contact/pushes.hpp"

namespace supple {

namespace smooth {
struct SurfaceFoot;
}

/// Vertices against triangulated boundaries [MacKeith 2025, eq. 9.5-9.9 corrected, in 3D:
/// docs/decisions/0010]. With phi(d) the energy of the law, 0 from d = sigma (times its range) on, sigma the
/// sum of the radii of the vertex and of those of the other body, the whole is half the sum over vertices i
/// and other bodies of
///     U_i = sum over faces phi(d) - sum over edges phi(d) + sum over vertices phi(d),
/// in which those parts count that are critical points of the distance from i to the *body*: faces from their
/// outer side, edges that i is in front of (+1) or over both of whose faces it is (-1), and vertices by
/// CornerFan. Where nothing within sigma is seen from behind this is inclusion and exclusion with distances
/// to closed triangles and segments. Forces are continuous round every convex, concave and saddle corner;
/// outside every convex body U_i = phi(nearest distance); outside any other body the same holds while the
/// part of the body within sigma of i is one piece without holes. feature_violations() counts the vertices
/// where it is not: chi, the number of pieces less that of holes, is not 1 there.
///
/// A vertex inside a body at a depth below sigma has the energy phi(-depth) besides: energy and force are
/// continuous where it crosses a face, and it is pushed toward the nearest point of the boundary. A vertex
/// that lies deeper is not pushed.
///
/// Smooth spheres are bodies of one site. Their centres act as vertices on surfaces, with the factor 1
/// instead of 1/2, and vertices of surfaces do not act on spheres. Two spheres have the energy phi(distance).
/// Edges do not act on edges: docs/decisions/0020 says how long they may be.
class SmoothSurfaces final : public BodyContacts<3> {
 public:
  using BodyContacts<3>::BodyContacts;
  std::unique_ptr<BodyContacts<3>> clone() const override { return std::make_unique<SmoothSurfaces>(*this); }
  Meeting meeting() const override { return Meeting::facets; }
  double scale(const Ring& of_site) const override { return edge_scale(of_site); }
  void evaluate(const System<3>& system, Detail detail, Evaluation<3>& out) override;
  /// Records are of the site and the one to three corners of the part, with weights 1 and minus the
  /// barycentric ones of the nearest point. Inside, the distance is negative. All records of a site and an
  /// image of a body are one touch.
  std::vector<ContactRecord<3>> records(const System<3>& system) override;
  int feature_violations() const override { return violations_; }

 private:
  struct Sum;
  /// A force on a site from the corners of a part of another body: weight[k] of it from corner[k].
  struct Push {
    std::int32_t site;
    std::int32_t corners;
    std::array<std::int32_t, 3> corner;
    std::array<double, 3> weight;
    Vec3 force;
    double distance, energy;
    Vec3 normal;
  };
  template <bool energies, class Laws>
  void add_all(const System<3>& system, const Laws& laws, Evaluation<3>& out, Sum& sum);

  void update(const System<3>& system);
  bool is_linked(const FacetGroup& group) const;
  /// visit(group, foot, sigma) for what acts in each of these groups, in order; close(met) behind each that
  /// met something.
  template <class Laws, class Visit, class Close>
  void walk_groups(const System<3>& system, const Laws& laws, const std::vector<Vec3>& shifts,
                   std::int64_t begin, std::int64_t end, const Visit& visit, const Close& close) const;
  template <class Laws, class Meet>
  void walk_spheres(const System<3>& system, const Laws& laws, const std::vector<Vec3>& shifts,
                    std::int64_t begin, std::int64_t end, const Meet& meet) const;

  FacetCandidates candidates_;
  LinkedTouches<3> linked_;
  std::vector<std::int32_t> body_;  ///< of each site, where something is linked
  Pushes<Push> pushes_;             ///< with several threads
  int violations_ = 0;
};

}  // namespace supple
