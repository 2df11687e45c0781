/// Which vertices may soon touch which edges of other bodies.
#pragma once
#include <cstdint>
#include <vector>

#include "supple/contact/row_images.hpp"
#include "supple/model/ring.hpp"

namespace supple {

/// A site that may soon touch an edge of another body, or the corner where that edge starts.
struct EdgeCandidate {
  std::int32_t site;
  std::int32_t before, start, end;  ///< the corner at the start of the edge: vertices of the ring
  std::int32_t image;               ///< index into EdgeCandidates::shifts()
  std::int32_t group;               ///< index into EdgeCandidates::group_begin()
  double scale;                     ///< factor on energy and force
};

/// Factor on energy and force of a site against a boundary. Vertices of two bodies act on each other's
/// boundary: 1/2 [MacKeith 2025, eq. 9.5]. A disc acts on a boundary, and the vertices of that body not on
/// the disc: 1.
inline double edge_scale(const Ring& of_site) { return of_site.is_disc() ? 1.0 : 0.5; }

/// All candidates, found from the rows of a pair table of Meeting::facets whenever these change. They are in
/// the order (site, body, image, edge), in which forces are summed; those of the same site, body and image
/// form a group. Pairs of discs, which have no edges, are in disc_rows().
class EdgeCandidates {
 public:
  /// Finds the candidates again if the rows have changed. `range`: of the law, over where surfaces meet.
  void update(const System<2>& system, double range = 1);

  const std::vector<EdgeCandidate>& all() const { return all_; }
  /// Group g: candidates [group_begin()[g], group_begin()[g+1]).
  const std::vector<std::int32_t>& group_begin() const { return group_begin_; }
  /// For each image, the vector to add to the site's position before it is compared with the edge [length],
  /// for the box as it is now.
  const std::vector<Vec2>& shifts(const Box<2>& box);
  /// Cells by which this image shifts the site.
  Vec2 cells(std::int32_t image) const {
    const auto half = static_cast<std::int32_t>(images_.cells().size());
    return image < half ? images_.cells()[image] : -images_.cells()[image - half];
  }
  /// Cells that a row subtracts from second - first.
  const Vec2& cells_of_row(std::int32_t row) const { return images_.cells()[images_.index()[row]]; }
  /// Rows of two bodies of one site each, and their images (RowImages).
  const std::vector<std::int32_t>& disc_rows() const { return disc_rows_; }
  RowImages<2>& images() { return images_; }
  const RowImages<2>& images() const { return images_; }

 private:
  struct Found;
  void collect(const System<2>& system, const std::vector<std::int32_t>& body, double range,
               std::vector<Found>& found);
  void arrange(const System<2>& system, const std::vector<std::int32_t>& body,
               const std::vector<Found>& found);

  RowImages<2> images_;
  std::vector<EdgeCandidate> all_;
  std::vector<std::int32_t> group_begin_{0}, disc_rows_;
  std::vector<Vec2> shifts_;
};

}  // namespace supple
