#include "supple/draw/scene/particle_colors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <tuple>

namespace supple {

namespace {

/// Particles that share an edge of their flattened discs with each particle.
std::vector<std::set<std::int32_t>> touching_particles(std::span<const std::int32_t> particle,
                                                       std::size_t count, const CellScene& scene) {
  std::vector<std::set<std::int32_t>> touching(count);
  for (const SceneDisc& disc : scene.discs)
    for (const std::int32_t other : disc.across)
      if (other >= 0 && particle[other] != particle[disc.site])
        touching[particle[disc.site]].insert(particle[other]);
  return touching;
}

double distance(Color a, Color b) { return std::hypot(a.red - b.red, a.green - b.green, a.blue - b.blue); }

}  // namespace

std::vector<Color> neighbour_colors(const std::vector<std::set<std::int32_t>>& touching,
                                    const std::vector<bool>& wanted) {
  constexpr int none = -1, colors = static_cast<int>(area_palette.size());
  const std::size_t count = touching.size();
  std::vector<int> choice(count, none);
  std::array<int, colors> uses{};
  for (std::size_t p = 0; p < count; ++p) {
    if (!wanted[p]) continue;
    std::array<int, colors> clashes{};
    std::array<double, colors> likeness{};  // to the most similar neighbour
    for (const std::int32_t other : touching[p]) {
      if (choice[other] == none) continue;
      ++clashes[choice[other]];
      for (int c = 0; c < colors; ++c)
        likeness[c] =
            std::max(likeness[c], 1 / (0.01 + distance(area_palette[c], area_palette[choice[other]])));
    }
    const auto cost = [&](int c) { return std::tuple(clashes[c], uses[c], likeness[c]); };
    int best = 0;
    for (int c = 1; c < colors; ++c)
      if (cost(c) < cost(best)) best = c;
    choice[p] = best;
    ++uses[best];
  }
  std::vector<Color> color;
  for (const int c : choice) color.push_back(c == none ? pale_gray : area_palette[c]);
  return color;
}

std::vector<Color> disc_colors(std::span<const std::int32_t> particle, const CellScene& scene) {
  if (particle.empty()) return {};
  const std::size_t count = static_cast<std::size_t>(*std::max_element(particle.begin(), particle.end())) + 1;
  std::vector<int> discs(count, 0);
  for (const std::int32_t p : particle) ++discs[p];
  std::vector<bool> crosslinked;
  for (const int d : discs) crosslinked.push_back(d > 1);
  const std::vector<Color> of_particle =
      neighbour_colors(touching_particles(particle, count, scene), crosslinked);
  std::vector<Color> color;
  for (const std::int32_t p : particle) color.push_back(of_particle[p]);
  return color;
}

std::vector<Color> disc_colors(const RunInfo& info, const Frame& frame) {
  return disc_colors(info.particle, lay_out_cell(sheared(info.box, frame.strain), info.radius, frame, 0));
}

}  // namespace supple
