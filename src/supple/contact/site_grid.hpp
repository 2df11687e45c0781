/// Sites sorted into grids of cells, to find those that may be near a given one.
#pragma once
#include <cstdint>
#include <vector>

#include "supple/model/system.hpp"

namespace supple {

/// One grid for each class of sizes, a factor of two in radius, with cells as wide as pairs of its own class
/// reach. A site looks into every grid as far as it may meet the sites there, so that a few large sites do
/// not slow down the small ones [Ogarko & Luding 2012]. A grid has at most a few cells for each site, however
/// empty or long the box. Every periodic image within reach is looked at, at any strain, wherever the sites
/// are.
template <int Dim>
class SiteGrid {
 public:
  /// Two sites are near each other if their distance is below the sum of their radii (as given here) and the
  /// skin. Those of a negative radius are near nothing.
  SiteGrid(const System<Dim>& system, const std::vector<double>& radius, double skin);

  /// Appends the sites j > i of other bodies that have an image near site i, in no order and some of them
  /// twice.
  void append_near(std::int32_t i, std::vector<std::int32_t>& near) const;

 private:
  struct Entry {
    Vec<Dim> position;
    double radius;
    std::int32_t site;
  };
  struct Level {
    double radius = 0;  ///< the largest
    std::vector<std::int32_t> site;
    long count[Dim];
    double per_cell[Dim];
    std::vector<std::int32_t> begin;
    std::vector<Entry> entries;  ///< cell after cell
  };
  struct Search;

  void choose_cells(Level& level) const;
  void sort(Level& level) const;
  void search_rows(int d, long row, Search& search) const;
  void search_row(long row, Search& search) const;

  const Box<Dim>& box_;
  const std::vector<double>& radius_;
  std::vector<Vec<Dim>> position_;  ///< wrapped into the cell
  std::vector<std::int32_t> body_;  ///< of each site; empty: every site is a body
  double skin_;
  std::vector<Level> levels_;
};

}  // namespace supple
