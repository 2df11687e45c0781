#include "supple/contact/facet_candidates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "supple/contact/edge_candidates.hpp"
#include "supple/core/error.hpp"
#include "supple/geometry/closest_point.hpp"

namespace supple {

namespace {

/// All parts of one boundary must reach equally far, or what they count twice would not be taken back.
void require_one_radius(const System<3>& system) {
  const Topology<3>& topology = system.topology;
  const std::vector<double>& radius = system.state.radius;
  for (int b = 0; b < topology.body_count(system.state.size()); ++b)
    for (std::int32_t i = topology.body_begin(b); i < topology.body_end(b); ++i)
      if (radius[i] != radius[topology.body_begin(b)])
        throw input_error(fmt::format("the vertices of body {} differ in radius", b),
                          "a smooth boundary is as thick everywhere", "give all of them one radius");
}

bool is_round(const Topology<3>& topology, std::int32_t body) {
  return Ring{topology.body_begin(body), topology.body_end(body)}.is_disc();
}

}  // namespace

/// A site and a triangle, before duplicates are gone: all corners of a triangle may have a row with the site.
struct FacetCandidates::Found {
  std::int32_t site, body, facet, image;
  Vec3 cells;  ///< orders images whatever rows made them known

  auto group() const { return std::tuple(site, body, cells[0], cells[1], cells[2]); }
  auto key() const { return std::tuple_cat(group(), std::tuple(facet)); }
};

void FacetCandidates::update(const System<3>& system, double range) {
  if (!images_.update(system)) return;
  require_one_radius(system);
  fans_.update(system.topology, system.state.size());
  const std::vector<std::int32_t> body = bodies_of_sites(system.topology, system.state.size());
  std::vector<Found> found;
  collect(system, body, range, found);
  arrange(system, body, found);
}

const std::vector<Vec3>& FacetCandidates::shifts(const Box<3>& box) {
  // Image m of a row is subtracted from second - first: the first site is shifted by +m, the second by -m.
  const std::vector<Vec3>& of_rows = images_.shifts(box);
  shifts_ = of_rows;
  for (const Vec3& shift : of_rows) shifts_.push_back(-shift);
  return shifts_;
}

void FacetCandidates::collect(const System<3>& system, const std::vector<std::int32_t>& body, double range,
                              std::vector<Found>& found) {
  const State<3>& state = system.state;
  const std::vector<Vec3>& shift = shifts(system.box);
  const auto images = static_cast<std::int32_t>(images_.cells().size());
  round_rows_.clear();

  const auto consider = [&](std::int32_t site, std::int32_t vertex, std::int32_t image) {
    const double reach = range * (state.radius[site] + state.radius[vertex]) + system.pairs.skin;
    const Vec3 p = state.position[site] + shift[image];
    for (const std::int32_t facet : fans_.facets_round(vertex)) {
      Vec3 x[3];
      for (std::size_t k = 0; k < 3; ++k) x[k] = state.position[system.topology.facet[facet][k]];
      const Vec3 from = closest_on_triangle(p, x).from;
      if (dot(from, from) < reach * reach) found.push_back({site, body[vertex], facet, image, cells(image)});
    }
  };

  for (std::int32_t row = 0; row < system.pairs.size(); ++row) {
    const std::int32_t i = system.pairs.first[row], j = system.pairs.second[row],
                       image = images_.index()[row];
    if (is_round(system.topology, body[i]) && is_round(system.topology, body[j])) round_rows_.push_back(row);
    consider(i, j, image);
    consider(j, i, image + images);
  }
}

void FacetCandidates::arrange(const System<3>& system, const std::vector<std::int32_t>& body,
                              const std::vector<Found>& found) {
  const auto sites = static_cast<std::size_t>(system.state.size());
  std::vector<std::int32_t> begin(sites + 1);
  for (const Found& f : found) ++begin[f.site + 1];
  for (std::size_t i = 0; i < sites; ++i) begin[i + 1] += begin[i];
  std::vector<Found> sorted(found.size());
  std::vector<std::int32_t> end(begin.begin(), begin.end() - 1);
  for (const Found& f : found) sorted[end[f.site]++] = f;

  groups_.clear();
  facets_.clear();
  for (std::size_t i = 0; i < sites; ++i) {
    const auto first = sorted.begin() + begin[i], last = sorted.begin() + end[i];
    std::sort(first, last, [](const Found& a, const Found& b) { return a.key() < b.key(); });
    const Topology<3>& topology = system.topology;
    const double scale = edge_scale(Ring{topology.body_begin(body[i]), topology.body_end(body[i])});
    for (auto f = first; f != last; ++f) {
      if (f != first && f->key() == (f - 1)->key()) continue;
      const auto at = static_cast<std::int32_t>(facets_.size());
      if (f == first || f->group() != (f - 1)->group())
        groups_.push_back({f->site, f->body, f->image, at, at, scale});
      facets_.push_back(f->facet);
      groups_.back().end = at + 1;
    }
  }
}

}  // namespace supple
