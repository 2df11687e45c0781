/// A triangle that sticks out of its cell, a disc and a pentagon, with numbers that have no short decimals.
#pragma once
#include <cmath>

#include "supple/draw/scene/scene.hpp"

namespace supple::testing {

inline Scene sample_scene() {
  Scene scene;
  scene.box.length = {10, 8};
  scene.time = 1.0 / 3;
  scene.begin = {0, 3, 4, 9};
  scene.position = {{9.1, 1.0 / 7}, {10.6, 0.2}, {9.7, 1.1}, {2.0 / 3, 4.1}};
  for (int k = 0; k < 5; ++k) scene.position.push_back({5 + std::cos(1.2566 * k), 6 + std::sin(1.2566 * k)});
  scene.radius = {0.3, 0.3, 0.3, 0.7, 0.1, 0.1, 0.1, 0.1, 0.1};
  std::vector<Vec2> force;
  for (int i = 0; i < 9; ++i) force.push_back({std::sqrt(i), -1.0 / (3 + i)});
  scene.of_sites = {{"force", force},
                    {"contact_count", std::vector<std::int32_t>{0, 1, 2, 3, 4, 5, 6, 7, -8}}};
  scene.of_bodies = {{"pressure", std::vector<double>{1e-7 / 3, 0, 2.5}},
                     {"velocity", std::vector<Vec2>{{1, 2}, {3, 1.0 / 9}, {5, 6}}}};
  return scene;
}

}  // namespace supple::testing
