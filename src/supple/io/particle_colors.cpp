#include "supple/io/particle_colors.hpp"

#include <algorithm>
#include <array>
#include <set>

namespace supple {

namespace {

/// Particles that share an edge of their flattened discs with each particle.
std::vector<std::set<std::int32_t>> touching_particles(std::span<const std::int32_t> particle, std::size_t count,
                                                       const CellScene& scene) {
  std::vector<std::set<std::int32_t>> touching(count);
  for (const SceneDisc& disc : scene.discs)
    for (const std::int32_t other : disc.across)
      if (other >= 0 && particle[other] != particle[disc.site]) touching[particle[disc.site]].insert(particle[other]);
  return touching;
}

}  // namespace

std::vector<Color> disc_colors(std::span<const std::int32_t> particle, const CellScene& scene) {
  if (particle.empty()) return {};
  const std::size_t count = static_cast<std::size_t>(*std::max_element(particle.begin(), particle.end())) + 1;
  std::vector<int> discs(count, 0);
  for (const std::int32_t p : particle) ++discs[p];
  const auto touching = touching_particles(particle, count, scene);

  constexpr int none = -1, colors = static_cast<int>(area_palette.size());
  std::vector<int> choice(count, none);
  std::array<int, colors> uses{};
  for (std::size_t p = 0; p < count; ++p) {
    if (discs[p] < 2) continue;
    std::array<int, colors> clashes{};
    for (const std::int32_t other : touching[p])
      if (choice[other] != none) ++clashes[choice[other]];
    int best = 0;
    for (int c = 1; c < colors; ++c)
      if (std::pair(clashes[c], uses[c]) < std::pair(clashes[best], uses[best])) best = c;
    choice[p] = best;
    ++uses[best];
  }
  std::vector<Color> color;
  for (const std::int32_t p : particle) color.push_back(choice[p] == none ? pale_gray : area_palette[choice[p]]);
  return color;
}

}  // namespace supple
