#include "supple/model/crosslink.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "supple/core/disjoint_sets.hpp"
#include "supple/core/random.hpp"
#include "supple/core/require.hpp"
#include "supple/model/cuts.hpp"

namespace supple {
namespace {

void check(const CrosslinkSpec& spec) {
  require(spec.cut_lines >= 0, "cut_lines", spec.cut_lines, "0 or more");
  require(spec.edge_fuzziness >= 0, "edge_fuzziness", spec.edge_fuzziness, "0 or more");
  require(spec.avoid_horizontal >= 0 && spec.avoid_horizontal < std::numbers::pi / 2,
          "angle to avoid [radian]", spec.avoid_horizontal, "at least 0 and less than a right angle");
  require(spec.max_tries >= 1, "max_cut_tries", spec.max_tries, "at least 1");
  require(spec.remove_link_fraction >= 0 && spec.remove_link_fraction <= 1, "remove_link_fraction",
          spec.remove_link_fraction, "a number from 0 to 1");
}

void link_all(System<2>& system, const std::vector<TouchingPair>& touching) {
  for (const std::int32_t row : link_rows(system, LinkKind::all)) cut(system.pairs, row);
  for (const TouchingPair& pair : touching) link(system.pairs, pair.row);
}

void cut_into_particles(System<2>& system, const std::vector<TouchingPair>& touching,
                        const CrosslinkSpec& spec, std::uint64_t seed, int attempt) {
  if (spec.cut_top_bottom) cut_along_plates(system, touching);
  if (spec.is_bulk()) return;
  if (spec.cut == CutKind::voronoi) {
    const auto& radius = system.state.radius;
    const double largest = *std::max_element(radius.begin(), radius.end());
    const auto points = random_particle_seeds(system.box, spec.cut_lines, seed, attempt);
    cut_between_cells(system.pairs, touching,
                      voronoi_cells(system, points, spec.edge_fuzziness * largest, seed, attempt));
  } else {
    for (int line = 0; line < spec.cut_lines; ++line)
      cut_along_line(system, touching,
                     random_cut_line(system.box, spec.avoid_horizontal, seed, attempt, line));
  }
}

double tallest_particle(const System<2>& system) {
  const auto height = particle_heights(system.state, connected_particles(system));
  return *std::max_element(height.begin(), height.end());
}

}  // namespace

CrosslinkReport crosslink(System<2>& system, const CrosslinkSpec& spec, std::uint64_t seed) {
  check(spec);
  const std::vector<TouchingPair> touching = touching_pairs(system);
  CrosslinkReport report;
  if (system.state.size() == 0) return report;

  const bool any_height = !spec.avoid_height_spanning || spec.is_bulk();
  const double height_limit = tallest_share * system.box.length[gradient];
  bool too_tall = true;
  while (too_tall) {
    if (report.tries == spec.max_tries)
      throw input_error(fmt::format("{} cuts each left a particle taller than {} of the cell", spec.max_tries,
                                    tallest_share),
                        fmt::format("cut_lines = {} makes particles too large", spec.cut_lines),
                        "raise cut_lines or max_cut_tries, or set avoid_height_spanning_particles = false");
    const int attempt = report.tries++;
    link_all(system, touching);
    cut_into_particles(system, touching, spec, seed, attempt);
    if (spec.join == IsolatedJoin::before_height_check)
      report.joined = join_isolated_discs(system, touching, seed, attempt);
    too_tall = !any_height && tallest_particle(system) > height_limit;
  }

  const std::size_t physical = link_rows(system, LinkKind::physical).size();
  report.removed = remove_links(system, spec.remove_link_fraction, seed);
  report.removed_fraction =
      physical == 0 ? 0 : static_cast<double>(report.removed) / static_cast<double>(physical);
  if (spec.join == IsolatedJoin::last)
    report.joined = join_isolated_discs(system, touching, seed, report.tries);
  report.links = static_cast<int>(link_rows(system, LinkKind::all).size());
  report.particle = connected_particles(system);
  report.height = particle_heights(system.state, report.particle);
  return report;
}

int join_isolated_discs(System<2>& system, const std::vector<TouchingPair>& touching, std::uint64_t seed,
                        int attempt) {
  std::vector<bool> isolated(system.state.size(), true);
  for (const std::int32_t row : link_rows(system, LinkKind::physical))
    isolated[system.pairs.first[row]] = isolated[system.pairs.second[row]] = false;

  std::vector<std::vector<const TouchingPair*>> contacts(system.state.size());
  for (const TouchingPair& pair : touching)
    for (const std::int32_t disc : {pair.first, pair.second}) contacts[disc].push_back(&pair);

  int joined = 0;
  for (int disc = 0; disc < system.state.size(); ++disc) {
    if (!isolated[disc]) continue;
    auto& unlinked = contacts[disc];
    std::erase_if(unlinked,
                  [&](auto* pair) { return system.pairs.state[pair->row] == ContactState::permanent; });
    if (unlinked.empty()) continue;
    RandomStream draw(seed, Purpose::isolated_join, stream_index(attempt, disc));
    const TouchingPair& pair = *unlinked[draw.below(unlinked.size())];
    link(system.pairs, pair.row);
    if (!pair.crosses) isolated[pair.first] = isolated[pair.second] = false;
    ++joined;
  }
  return joined;
}

int remove_links(System<2>& system, double fraction, std::uint64_t seed) {
  PairTable& pairs = system.pairs;
  std::vector<std::int32_t> order = link_rows(system, LinkKind::physical);
  const auto wanted = std::llround(fraction * static_cast<double>(order.size()));
  if (wanted == 0) return 0;

  // Each link draws its place in the order of removal by itself.
  std::vector<double> place(pairs.size());
  for (const std::int32_t row : order) {
    const std::uint64_t index = stream_index(pairs.first[row], pairs.second[row]);
    place[row] = RandomStream(seed, Purpose::link_removal, index).uniform();
  }
  std::sort(order.begin(), order.end(),
            [&](auto a, auto b) { return place[a] != place[b] ? place[a] < place[b] : a < b; });

  // In this order a link may be removed if the links after it connect its two discs all the same. The links
  // that must stay are therefore the spanning forest that grows from the end of the order (Kruskal 1956).
  std::vector<std::int32_t> removable;
  DisjointSets later(system.state.size());
  for (auto row = order.rbegin(); row != order.rend(); ++row)
    if (!later.merge(pairs.first[*row], pairs.second[*row])) removable.push_back(*row);

  const int removed = static_cast<int>(std::min<long long>(wanted, static_cast<long long>(removable.size())));
  for (int k = 0; k < removed; ++k) cut(pairs, removable[removable.size() - 1 - k]);
  return removed;
}

}  // namespace supple
