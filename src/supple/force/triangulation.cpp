#include "supple/force/triangulation.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "supple/core/error.hpp"

namespace supple {

namespace {

constexpr Triangulation::Place point = 4, none = std::numeric_limits<Triangulation::Place>::max();

/// Facets or hinges [begin, end) of a topology by numbers that begin at the site `first`.
template <std::size_t N>
std::vector<std::array<std::int32_t, N>> moved(const std::vector<std::array<std::int32_t, N>>& all, int begin,
                                               int end, std::int32_t first) {
  std::vector<std::array<std::int32_t, N>> own(all.begin() + begin, all.begin() + end);
  for (auto& sites : own)
    for (std::int32_t& site : sites) site -= first;
  return own;
}

/// Whether `all`, from `begin` on, has the sites `own` counted from the site `first`. In rows without a
/// branch, which become vector instructions.
template <std::size_t N>
bool same_sites(const std::vector<std::array<std::int32_t, N>>& all, int begin, std::int32_t first,
                const std::vector<std::array<std::int32_t, N>>& own) {
  constexpr std::size_t row = 16;
  const std::int32_t *a = all.data()[begin].data(), *o = own.data()->data();
  const std::size_t n = N * own.size(), rows_end = n / row * row;
  std::int32_t differ[row]{};
  for (std::size_t k = 0; k < rows_end; k += row)
    for (std::size_t i = 0; i < row; ++i) differ[i] |= (a[k + i] - first) ^ o[k + i];
  for (std::size_t k = rows_end; k < n; ++k) differ[0] |= (a[k] - first) ^ o[k];
  return std::all_of(differ, differ + row, [](std::int32_t d) { return d == 0; });
}

int blocks_of(int n) { return (n + Triangulation::block - 1) / Triangulation::block; }

/// Fills a list of whole blocks up with its number at `last`.
void repeat_last(std::vector<Triangulation::Place>& list, int last) {
  std::fill(list.begin() + last + 1, list.end(), list[last]);
}

}  // namespace

Triangulation::Triangulation(const Topology<3>& t, int b)
    : sites(t.begin[b + 1] - t.begin[b]),
      facets(t.facet_begin[b + 1] - t.facet_begin[b]),
      hinges(t.hinge_begin[b + 1] - t.hinge_begin[b]),
      facet_blocks(blocks_of(facets)),
      hinge_blocks(blocks_of(hinges)),
      facet(moved(t.facet, t.facet_begin[b], t.facet_begin[b + 1], t.begin[b])),
      hinge(moved(t.hinge, t.hinge_begin[b], t.hinge_begin[b + 1], t.begin[b])) {
  const auto is_own = [&](std::int32_t site) { return site >= 0 && site < sites; };
  const auto of_own = [&](const auto& all) {
    return std::all_of(all.begin(), all.end(),
                       [&](const auto& s) { return std::all_of(s.begin(), s.end(), is_own); });
  };
  if (!of_own(facet) || !of_own(hinge))
    throw input_error(fmt::format("the surface of body {}", b), "a triangle or a hinge has sites of others");
  list_corners();
  join_hinges(b);
}

void Triangulation::list_corners() {
  corner_site.resize(static_cast<std::size_t>(3 * block) * facet_blocks);
  for (int t = 0; t < facet_blocks * block; ++t)
    for (int k = 0; k < 3; ++k)
      corner_site[corner_number(t, k)] = point * static_cast<Place>(facet[std::min(t, facets - 1)][k]);
  site_begin.assign(static_cast<std::size_t>(sites) + 1, 0);
  for (const auto& f : facet)
    for (const std::int32_t site : f) ++site_begin[site + 1];
  for (int i = 0; i < sites; ++i) site_begin[i + 1] = site_begin[i] + (site_begin[i + 1] + 1) / 2 * 2;
  site_corner.assign(site_begin.back(), no_corner());
  std::vector<std::int32_t> next(site_begin.begin(), site_begin.end());
  for (int t = 0; t < facets; ++t)
    for (int k = 0; k < 3; ++k)
      site_corner[next[facet[t][k]]++] = point * static_cast<Place>(corner_number(t, k));
}

/// Finds the two triangles of a hinge among those round its first site.
bool Triangulation::join(int h) {
  const auto& [from, to, outer, other] = hinge[h];
  int joined = 0;
  for (std::int32_t c = site_begin[from]; c < site_begin[from + 1] && site_corner[c] != no_corner(); ++c) {
    const int corner = static_cast<int>(site_corner[c] / point);
    const int t = corner / (3 * block) * block + corner % block, k = corner / block % 3, ahead = (k + 1) % 3,
              behind = (k + 2) % 3;
    const bool forwards = facet[t][ahead] == to && facet[t][behind] == outer,
               backwards = facet[t][behind] == to && facet[t][ahead] == other;
    if (!forwards && !backwards) continue;
    const int opposite = corner_number(t, forwards ? behind : ahead);
    if (corner_hinge[opposite] != none) return false;
    corner_hinge[opposite] = static_cast<Place>(h);
    hinge_facet[forwards ? 0 : 1][h] = point * static_cast<Place>(t);
    if (forwards) hinge_corner[h] = static_cast<Place>(opposite);
    joined |= forwards ? 1 : 2;
  }
  hinge_outer[0][h] = point * static_cast<Place>(outer);
  hinge_outer[1][h] = point * static_cast<Place>(other);
  return joined == 3;
}

void Triangulation::join_hinges(int b) {
  if (2 * hinges != 3 * facets)
    throw input_error(fmt::format("body {} has {} triangles and {} hinges", b, facets, hinges),
                      "a closed surface has three hinges for two triangles", "make the body by add_surface");
  const std::size_t padded = static_cast<std::size_t>(block) * hinge_blocks;
  const auto lists = {&hinge_facet[0], &hinge_facet[1], &hinge_outer[0], &hinge_outer[1], &hinge_corner};
  for (auto* list : lists) list->resize(padded);
  corner_hinge.assign(corner_site.size(), none);
  for (int h = 0; h < hinges; ++h)
    if (!join(h))
      throw input_error(
          fmt::format("body {}: the hinge of its sites {} and {}", b, hinge[h][0], hinge[h][1]),
          "it is not that of two triangles of the body which have this edge, once in each direction",
          "make the body by add_surface");
  for (auto* list : lists) repeat_last(*list, hinges - 1);
  for (int t = facets; t < facet_blocks * block; ++t)
    for (int k = 0; k < 3; ++k)
      corner_hinge[corner_number(t, k)] = corner_hinge[corner_number(facets - 1, k)];
}

bool Triangulation::is_of(const Topology<3>& t, int b) const {
  const std::int32_t first = t.begin[b];
  return t.begin[b + 1] - first == sites && t.facet_begin[b + 1] - t.facet_begin[b] == facets &&
         t.hinge_begin[b + 1] - t.hinge_begin[b] == hinges &&
         same_sites(t.facet, t.facet_begin[b], first, facet) &&
         same_sites(t.hinge, t.hinge_begin[b], first, hinge);
}

const Triangulation& triangulation_of(const Topology<3>& topology, int b) {
  constexpr std::size_t most = 16;
  static thread_local std::vector<std::unique_ptr<const Triangulation>> kept;  // the last used first
  auto at = std::find_if(kept.begin(), kept.end(), [&](const auto& k) { return k->is_of(topology, b); });
  if (at == kept.end()) {
    auto made = std::make_unique<const Triangulation>(topology, b);
    if (kept.size() == most) kept.pop_back();
    at = kept.insert(kept.begin(), std::move(made));
  }
  std::rotate(kept.begin(), at, at + 1);
  return *kept.front();
}

}  // namespace supple
