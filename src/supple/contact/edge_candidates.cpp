#include "supple/contact/edge_candidates.hpp"

#include <algorithm>
#include <tuple>

#include "supple/geometry/closest_point.hpp"

namespace supple {

/// A site and an edge, before duplicates are gone: both ends of an edge may have a row with the site.
struct EdgeCandidates::Found {
  std::int32_t site, body, start, image;
  Vec2 cells;  ///< orders images whatever rows made them known

  auto group() const { return std::tuple(site, body, cells[0], cells[1]); }
  auto key() const { return std::tuple_cat(group(), std::tuple(start)); }
};

void EdgeCandidates::update(const System<2>& system, double range) {
  if (!images_.update(system)) return;
  const std::vector<std::int32_t> body = bodies_of_sites(system.topology, system.state.size());
  std::vector<Found> found;
  collect(system, body, range, found);
  arrange(system, body, found);
}

const std::vector<Vec2>& EdgeCandidates::shifts(const Box<2>& box) {
  // Image m of a row is subtracted from second - first: the first site is shifted by +m, the second by -m.
  const std::vector<Vec2>& of_rows = images_.shifts(box);
  shifts_ = of_rows;
  for (const Vec2& shift : of_rows) shifts_.push_back(-shift);
  return shifts_;
}

void EdgeCandidates::collect(const System<2>& system, const std::vector<std::int32_t>& body, double range,
                             std::vector<Found>& found) {
  const State<2>& state = system.state;
  const std::vector<Vec2>& shift = shifts(system.box);
  const auto images = static_cast<std::int32_t>(images_.cells().size());
  disc_rows_.clear();

  const auto consider = [&](std::int32_t site, std::int32_t vertex, std::int32_t image) {
    const Ring ring = ring_of(system.topology, body[vertex]);
    if (ring.is_disc()) return;
    const double reach = range * (state.radius[site] + state.radius[vertex]) + system.pairs.skin;
    for (const std::int32_t start : {ring.before(vertex), vertex}) {
      const Vec2 from = closest_on_segment(state.position[site] + shift[image], state.position[start],
                                           state.position[ring.after(start)])
                            .from;
      if (dot(from, from) < reach * reach) found.push_back({site, body[vertex], start, image, cells(image)});
    }
  };

  for (std::int32_t row = 0; row < system.pairs.size(); ++row) {
    const std::int32_t i = system.pairs.first[row], j = system.pairs.second[row],
                       image = images_.index()[row];
    if (ring_of(system.topology, body[i]).is_disc() && ring_of(system.topology, body[j]).is_disc())
      disc_rows_.push_back(row);
    consider(i, j, image);
    consider(j, i, image + images);
  }
}

/// Found edges come row after row: those of one site nearly in order, so that putting them there is quick.
void EdgeCandidates::arrange(const System<2>& system, const std::vector<std::int32_t>& body,
                             const std::vector<Found>& found) {
  const auto sites = static_cast<std::size_t>(system.state.size());
  std::vector<std::int32_t> begin(sites + 1);
  for (const Found& f : found) ++begin[f.site + 1];
  for (std::size_t i = 0; i < sites; ++i) begin[i + 1] += begin[i];
  std::vector<Found> sorted(found.size());
  std::vector<std::int32_t> end(begin.begin(), begin.end() - 1);
  for (const Found& f : found) {
    std::int32_t at = end[f.site]++;
    for (; at > begin[f.site] && f.key() < sorted[at - 1].key(); --at) sorted[at] = sorted[at - 1];
    sorted[at] = f;
  }

  all_.clear();
  group_begin_.clear();
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    const Found& f = sorted[k];
    const bool known = k > 0 && f.key() == sorted[k - 1].key();
    if (known) continue;
    const bool same_group = k > 0 && f.group() == sorted[k - 1].group();
    if (!same_group) group_begin_.push_back(static_cast<std::int32_t>(all_.size()));
    const Ring ring = ring_of(system.topology, f.body);
    const double scale = edge_scale(ring_of(system.topology, body[f.site]));
    const auto group = static_cast<std::int32_t>(group_begin_.size()) - 1;
    all_.push_back({f.site, ring.before(f.start), f.start, ring.after(f.start), f.image, group, scale});
  }
  group_begin_.push_back(static_cast<std::int32_t>(all_.size()));
}

}  // namespace supple
