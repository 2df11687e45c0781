#include "supple/draw/scene/frame_scene.hpp"

#include <cmath>
#include <limits>
#include <set>

namespace supple {

namespace {

/// A vector along the normal n of a contact, which follows from its force F = -N n + T t, t being n turned
/// left.
Vec2 direction(const ContactRow<2>& c) {
  return -c.normal_force * c.force - c.tangential_force * turned_left(c.force);
}

/// The particle of each body: discs that crosslinks join share one, a polygon is one of its own. Empty where
/// no bodies are joined.
std::vector<std::int32_t> particles_of_bodies(const RunInfo<2>& info, const Scene& scene) {
  if (info.body_begin.empty()) return info.particle;
  std::vector<std::int32_t> particle;
  std::set<std::int32_t> different;
  for (std::int32_t b = 0; b < scene.bodies(); ++b) {
    particle.push_back(scene.is_disc(b) ? info.particle[scene.body(b).first] : scene.sites() + b);
    different.insert(particle.back());
  }
  if (different.size() == particle.size()) particle.clear();
  return particle;
}

}  // namespace

template <int Dim>
BodyScene<Dim> body_scene_of(const RunInfo<Dim>& info, const Frame<Dim>& frame) {
  BodyScene<Dim> scene;
  scene.units = info.units;
  scene.box = info.box;
  scene.box.strain = frame.strain;
  scene.box.strain_rate = frame.strain_rate;
  if (frame.length[0] > 0) scene.box.length = frame.length;
  scene.time = frame.time;
  scene.numbers = frame.numbers;
  scene.begin = info.body_begin;
  scene.position = frame.position;
  scene.radius = info.radius;
  scene.facet = info.facet;
  scene.boundary_sites = info.boundary_sites;
  scene.bond = info.bond;
  const auto add = [&](const char* name, const auto& values, bool about_normal = false) {
    if (!values.empty()) scene.of_sites.push_back({name, values, about_normal});
  };
  add("velocity", frame.velocity);
  add("force", frame.force);
  if (info.body_begin.empty()) {
    add("angle", frame.angle);
    add("spin", frame.spin, Dim == 2);
    add("torque", frame.torque, Dim == 2);
    add("particle", info.particle);
  }
  for (const auto& [name, values] : frame.body) scene.of_bodies.push_back({name, values});
  return scene;
}

Scene scene_of(const RunInfo<2>& info, const Frame<2>& frame) {
  Scene scene{body_scene_of(info, frame)};
  scene.mobility = frame.mobility;
  scene.particle = particles_of_bodies(info, scene);
  for (const ContactRow<2>& c : frame.contacts) {
    const bool is_link = c.state == ContactState::permanent;
    scene.contacts.push_back({c.first, c.second, std::hypot(c.normal_force, c.tangential_force), 0, c.state,
                              is_link && c.normal_force < 0, is_link ? direction(c) : Vec2{}});
  }
  return scene;
}

const std::vector<double>* numbers_of_bodies(const Scene& scene, const std::string& name) {
  for (const SceneArray& array : scene.of_bodies)
    if (array.name == name) return std::get_if<std::vector<double>>(&array.values);
  return nullptr;
}

CellNumbers cell_numbers(const Scene& scene) {
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

template BodyScene<2> body_scene_of(const RunInfo<2>&, const Frame<2>&);
template BodyScene<3> body_scene_of(const RunInfo<3>&, const Frame<3>&);

}  // namespace supple
