/// Which vertices may soon touch which triangles of other bodies.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "supple/contact/row_images.hpp"
#include "supple/contact/surface_fans.hpp"

namespace supple {

/// A site that may soon touch an image of another body, and the triangles where it may.
struct FacetGroup {
  std::int32_t site, body;
  std::int32_t image;       ///< index into FacetCandidates::shifts()
  std::int32_t begin, end;  ///< of the triangles, in FacetCandidates
  double scale;             ///< factor on energy and force
};

/// All of them, found from the rows of a pair table of Meeting::facets whenever these change. Groups are in
/// the order (site, body, image), in which forces are summed, and their triangles ascend. Pairs of spheres,
/// which have no triangles, are in round_rows().
class FacetCandidates {
 public:
  /// Finds them again if the rows have changed. `range`: of the law, over where surfaces meet. Input error
  /// where the vertices of one body differ in radius, or its triangles do not close it.
  void update(const System<3>& system, double range = 1);

  const std::vector<FacetGroup>& groups() const { return groups_; }
  std::span<const std::int32_t> facets(const FacetGroup& group) const {
    return std::span(facets_).subspan(static_cast<std::size_t>(group.begin),
                                      static_cast<std::size_t>(group.end - group.begin));
  }
  const SurfaceFans& fans() const { return fans_; }
  /// For each image, the vector to add to the site's position before it is compared with the body [length],
  /// for the box as it is now.
  const std::vector<Vec3>& shifts(const Box<3>& box);
  /// Cells by which this image shifts the site.
  Vec3 cells(std::int32_t image) const {
    const auto half = static_cast<std::int32_t>(images_.cells().size());
    return image < half ? images_.cells()[image] : -images_.cells()[image - half];
  }
  /// Rows of two bodies of one site each, and their images (RowImages).
  const std::vector<std::int32_t>& round_rows() const { return round_rows_; }
  RowImages<3>& images() { return images_; }
  const RowImages<3>& images() const { return images_; }

 private:
  /// A site and a triangle, before duplicates are gone.
  struct Found {
    std::int32_t body, image;
    Vec3 cells;  ///< orders images whatever rows made them known
    std::int32_t facet;
  };
  /// A vertex that has a row with a site, and the image of the site that it is about.
  struct Partner {
    std::int32_t vertex, image;
  };
  void list_partners(const System<3>& system, const std::vector<std::int32_t>& body);
  void find_facets(const System<3>& system, std::int32_t site, const std::vector<std::int32_t>& body,
                   double range, const std::vector<Vec3>& shift);
  void add_groups(const System<3>& system, std::int32_t site, std::int32_t own_body);

  RowImages<3> images_;
  SurfaceFans fans_;
  std::vector<FacetGroup> groups_;
  std::vector<std::int32_t> facets_, round_rows_;
  std::vector<Vec3> shifts_;
  // Kept, as their memory is used again:
  std::vector<std::int32_t> partner_begin_;  ///< of each site
  std::vector<Partner> partners_;
  std::vector<std::int64_t> looked_at_;  ///< of each triangle: by which site and image last
  std::vector<Found> found_;             ///< of one site
};

}  // namespace supple
