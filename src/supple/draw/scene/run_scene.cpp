#include "supple/draw/scene/run_scene.hpp"

#include <cmath>
#include <limits>

namespace supple {

namespace {

const std::vector<double>* numbers_of_bodies(const PolygonScene& scene, const std::string& name) {
  for (const SceneArray& array : scene.of_bodies)
    if (array.name == name) return std::get_if<std::vector<double>>(&array.values);
  return nullptr;
}

}  // namespace

PolygonScene scene_of(const RunInfo& info, const Frame& frame) {
  PolygonScene scene;
  scene.box = info.box;
  scene.box.strain = frame.strain;
  scene.box.strain_rate = frame.strain_rate;
  if (frame.length[0] > 0) scene.box.length = frame.length;
  scene.time = frame.time;
  scene.numbers = frame.numbers;
  scene.begin = info.body_begin;
  scene.position = frame.position;
  scene.radius = info.radius;
  scene.of_sites = {{"velocity", frame.velocity}, {"force", frame.force}};
  if (info.body_begin.empty()) {
    scene.of_sites.push_back({"angle", frame.angle});
    scene.of_sites.push_back({"spin", frame.spin, true});
    scene.of_sites.push_back({"torque", frame.torque, true});
    scene.of_sites.push_back({"particle", info.particle});
  }
  for (const auto& [name, values] : frame.body) scene.of_bodies.push_back({name, values});
  for (const ContactRow& c : frame.contacts)
    scene.contacts.push_back({c.first, c.second, std::hypot(c.normal_force, c.tangential_force), 0, c.state,
                              c.state == ContactState::permanent && c.normal_force < 0});
  return scene;
}

CellNumbers cell_numbers(const PolygonScene& scene) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  CellNumbers cell{unknown, unknown};
  const auto *area = numbers_of_bodies(scene, "area"), *pressure = numbers_of_bodies(scene, "pressure");
  if (!area) return cell;
  double covered = 0, pressed = 0;
  for (std::size_t b = 0; b < area->size(); ++b) {
    covered += (*area)[b];
    if (pressure) pressed += (*area)[b] * (*pressure)[b];
  }
  cell.packing_fraction = covered / scene.box.volume();
  if (pressure) cell.pressure = pressed / scene.box.volume();
  return cell;
}

}  // namespace supple
