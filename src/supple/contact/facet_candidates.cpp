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

void FacetCandidates::update(const System<3>& system, double range) {
  if (!images_.update(system)) return;
  require_one_radius(system);
  fans_.update(system.topology, system.state.size());
  const std::vector<std::int32_t> body = bodies_of_sites(system.topology, system.state.size());
  list_partners(system, body);
  groups_.clear();
  facets_.clear();
  looked_at_.assign(system.topology.facet.size(), -1);
  const std::vector<Vec3>& shift = shifts(system.box);
  for (std::int32_t site = 0; site < system.state.size(); ++site) {
    find_facets(system, site, body, range, shift);
    add_groups(system, site, body[site]);
  }
}

const std::vector<Vec3>& FacetCandidates::shifts(const Box<3>& box) {
  // Image m of a row is subtracted from second - first: the first site is shifted by +m, the second by -m.
  const std::vector<Vec3>& of_rows = images_.shifts(box);
  shifts_ = of_rows;
  for (const Vec3& shift : of_rows) shifts_.push_back(-shift);
  return shifts_;
}

void FacetCandidates::list_partners(const System<3>& system, const std::vector<std::int32_t>& body) {
  const PairTable& pairs = system.pairs;
  const auto images = static_cast<std::int32_t>(images_.cells().size());
  round_rows_.clear();
  partner_begin_.assign(static_cast<std::size_t>(system.state.size()) + 1, 0);
  for (std::int32_t row = 0; row < pairs.size(); ++row) {
    const std::int32_t i = pairs.first[row], j = pairs.second[row];
    ++partner_begin_[i + 1];
    ++partner_begin_[j + 1];
    if (is_round(system.topology, body[i]) && is_round(system.topology, body[j])) round_rows_.push_back(row);
  }
  for (int i = 0; i < system.state.size(); ++i) partner_begin_[i + 1] += partner_begin_[i];
  partners_.resize(static_cast<std::size_t>(partner_begin_.back()));
  std::vector<std::int32_t> end(partner_begin_.begin(), partner_begin_.end() - 1);
  for (std::int32_t row = 0; row < pairs.size(); ++row) {
    const std::int32_t i = pairs.first[row], j = pairs.second[row], image = images_.index()[row];
    partners_[end[i]++] = {j, image};
    partners_[end[j]++] = {i, image + images};
  }
}

/// All corners of a triangle may have rows with the site: it is looked at once for each image.
void FacetCandidates::find_facets(const System<3>& system, std::int32_t site,
                                  const std::vector<std::int32_t>& body, double range,
                                  const std::vector<Vec3>& shift) {
  const State<3>& state = system.state;
  const auto images = static_cast<std::int64_t>(shift.size());
  found_.clear();
  for (std::int32_t k = partner_begin_[site]; k < partner_begin_[site + 1]; ++k) {
    const auto [vertex, image] = partners_[k];
    const double reach = range * (state.radius[site] + state.radius[vertex]) + system.pairs.skin;
    const Vec3 p = state.position[site] + shift[image];
    for (const std::int32_t facet : fans_.facets_round(vertex)) {
      if (looked_at_[facet] == site * images + image) continue;
      looked_at_[facet] = site * images + image;
      Vec3 x[3];
      for (std::size_t c = 0; c < 3; ++c) x[c] = state.position[system.topology.facet[facet][c]];
      if (!may_be_nearer(p, x, reach * reach)) continue;
      const Vec3 from = closest_on_triangle(p, x).from;
      if (dot(from, from) < reach * reach) found_.push_back({body[vertex], image, cells(image), facet});
    }
  }
}

void FacetCandidates::add_groups(const System<3>& system, std::int32_t site, std::int32_t own_body) {
  const auto group = [](const Found& f) { return std::tuple(f.body, f.cells[0], f.cells[1], f.cells[2]); };
  const auto key = [&](const Found& f) { return std::tuple_cat(group(f), std::tuple(f.facet)); };
  std::sort(found_.begin(), found_.end(), [&](const Found& a, const Found& b) { return key(a) < key(b); });
  const Topology<3>& topology = system.topology;
  const double scale = edge_scale(Ring{topology.body_begin(own_body), topology.body_end(own_body)});
  for (std::size_t k = 0; k < found_.size(); ++k) {
    const Found& f = found_[k];
    if (k > 0 && key(f) == key(found_[k - 1])) continue;
    const auto at = static_cast<std::int32_t>(facets_.size());
    if (k == 0 || group(f) != group(found_[k - 1])) groups_.push_back({site, f.body, f.image, at, at, scale});
    facets_.push_back(f.facet);
    groups_.back().end = at + 1;
  }
}

}  // namespace supple
