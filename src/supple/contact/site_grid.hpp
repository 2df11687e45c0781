/// Sites sorted into cells, by classes of size: which sites may be near one of them.
#pragma once
#include <cstdint>
#include <vector>

#include "supple/model/system.hpp"

namespace supple {

/// One grid for each class of sizes, a factor of two in radius, as wide as the pairs of its own class: a site
/// looks into each grid as far as it reaches there. So a few large sites cost the small ones nothing [Ogarko
/// & Luding 2012]. Cells of a grid are a few for each site, however empty or long the box. Every periodic
/// image within reach is looked at, at any strain, for positions anywhere.
template <int Dim>
class SiteGrid {
 public:
  /// Sites are near each other within the sum of their radii (as given here) and the skin.
  SiteGrid(const System<Dim>& system, const std::vector<double>& radius, double skin);

  /// Appends the sites j > i of other bodies that have an image near site i; in no order, some of them twice.
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
