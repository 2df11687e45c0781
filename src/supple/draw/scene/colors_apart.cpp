#include "supple/draw/scene/colors_apart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace supple {

namespace {

constexpr int colors = static_cast<int>(area_palette.size());

double distance(Color a, Color b) { return std::hypot(a.red - b.red, a.green - b.green, a.blue - b.blue); }

/// Particles that touch each particle.
std::map<std::int32_t, std::set<std::int32_t>> touching_particles(std::span<const Scene> scenes) {
  std::map<std::int32_t, std::set<std::int32_t>> touching;
  for (const Scene& scene : scenes) {
    const std::vector<std::int32_t> body = body_of_sites(scene);
    for (const SceneContact& c : scene.contacts) {
      const std::int32_t p = scene.particle_of(body[c.first]), q = scene.particle_of(body[c.second]);
      if (p == q) continue;
      touching[p].insert(q);
      touching[q].insert(p);
    }
  }
  return touching;
}

}  // namespace

std::map<std::int32_t, int> palette_apart(std::span<const std::int32_t> particles,
                                          const std::map<std::int32_t, std::set<std::int32_t>>& touching) {
  std::map<std::int32_t, int> choice;
  std::array<int, colors> uses{};
  for (const std::int32_t p : particles) {
    std::array<int, colors> clashes{};
    std::array<double, colors> likeness{};  // to the most similar neighbour
    const auto at = touching.find(p);
    for (const std::int32_t other : at == touching.end() ? std::set<std::int32_t>{} : at->second) {
      if (!choice.contains(other)) continue;
      const int its = choice[other];
      ++clashes[its];
      for (int c = 0; c < colors; ++c)
        likeness[c] = std::max(likeness[c], 1 / (0.01 + distance(area_palette[c], area_palette[its])));
    }
    const auto cost = [&](int c) { return std::tuple(clashes[c], uses[c], likeness[c]); };
    int best = 0;
    for (int c = 1; c < colors; ++c)
      if (cost(c) < cost(best)) best = c;
    ++uses[choice[p] = best];
  }
  return choice;
}

std::vector<Color> colors_apart(std::span<const Scene> scenes) {
  const Scene& scene = scenes.front();
  const std::vector<bool> single = single_discs(scene);
  std::vector<std::int32_t> particles;  // in the order of their first bodies
  std::set<std::int32_t> known;
  for (std::int32_t b = 0; b < scene.bodies(); ++b)
    if (const std::int32_t p = scene.particle_of(b); !single[b] && known.insert(p).second)
      particles.push_back(p);
  std::map<std::int32_t, int> choice = palette_apart(particles, touching_particles(scenes));
  std::vector<Color> color;
  for (std::int32_t b = 0; b < scene.bodies(); ++b)
    color.push_back(single[b] ? pale_gray : area_palette[choice[scene.particle_of(b)]]);
  return color;
}

}  // namespace supple
