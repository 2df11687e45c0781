#include "supple/experiment/heap.hpp"

#include <algorithm>
#include <cmath>

#include "supple/model/bodies.hpp"
#include "supple/observe/summary.hpp"

namespace supple {

namespace {

std::vector<double> diameters(const System<2>& s) {
  std::vector<double> out;
  for (int b = 0; b < s.topology.body_count(s.state.size()); ++b) out.push_back(2 * outer_radius(s, b));
  return out;
}

/// Slope of the least-squares line through the highest points in columns as wide as the widest particle,
/// downward to the right.
double surface_slope(const System<2>& s, double front) {
  const double wide = front / widest_diameter(s), most = 1e6;  // of a particle that has flown far away
  const int columns = static_cast<int>(wide < most ? std::max(2.0, wide) : most);
  std::vector<double> top(static_cast<std::size_t>(columns));
  for (int i = 0; i < s.state.size(); ++i) {
    const auto k = static_cast<std::size_t>(
        std::fmin(std::fmax(s.state.position[i][flow] / front * columns, 0), columns - 1));
    top[k] = std::max(top[k], s.state.position[i][gradient] + s.state.radius[i]);
  }
  double x = 0, y = 0, xx = 0, xy = 0;
  for (int k = 0; k < columns; ++k) {
    const double at = (k + 0.5) * front / columns, h = top[static_cast<std::size_t>(k)];
    x += at / columns;
    y += h / columns;
    xx += at * at / columns;
    xy += at * h / columns;
  }
  return -(xy - x * y) / (xx - x * x);
}

double largest_imbalance(const System<2>& s, const Evaluation<2>& evaluation, double gravity) {
  double most = 0;
  for (int b = 0; b < s.topology.body_count(s.state.size()); ++b) {
    Vec2 force{};
    double mass = 0;
    const int begin = s.topology.body_begin(b);
    for (int i = begin; i < begin + s.topology.body_size(b); ++i) {
      force += evaluation.force[i];
      mass += s.state.mass[i];
    }
    most = std::max(most, norm(force) / (mass * gravity));
  }
  return most;
}

}  // namespace

double mean_diameter(const System<2>& system) {
  const std::vector<double> all = diameters(system);
  double sum = 0;
  for (const double d : all) sum += d;
  return sum / static_cast<double>(all.size());
}

double widest_diameter(const System<2>& system) {
  const std::vector<double> all = diameters(system);
  return *std::max_element(all.begin(), all.end());
}

double weight(const System<2>& system, ForceField<2>& field) {
  double mass = 0;
  for (const double m : system.state.mass) mass += m;
  return -mass * field.external().gravity[gradient];
}

Heap measure_heap(const System<2>& system, ForceField<2>& field, const Evaluation<2>& evaluation) {
  const State<2>& s = system.state;
  Heap h;
  h.time = system.time;
  h.kinetic = kinetic_energy(system).total();
  h.potential = evaluation.energy.stored();
  double mass = 0;
  for (int i = 0; i < s.size(); ++i) {
    mass += s.mass[i];
    h.height += s.mass[i] * s.position[i][gradient];
    h.spread += 2 * s.mass[i] * s.position[i][flow];
    h.front = std::max(h.front, s.position[i][flow] + s.radius[i]);
    h.top = std::max(h.top, s.position[i][gradient] + s.radius[i]);
  }
  h.height /= mass;
  h.spread /= mass;
  h.slope = surface_slope(system, h.front);
  const double w = weight(system, field);
  h.walls = sum_wall_forces(evaluation.wall);
  for (double* force : {&h.walls.left, &h.walls.right, &h.walls.floor, &h.walls.lid, &h.walls.drag})
    *force /= w;
  h.imbalance = largest_imbalance(system, evaluation, -field.external().gravity[gradient]);
  h.motion = h.kinetic / (w * mean_diameter(system));
  return h;
}

bool is_at_rest(const Heap& heap, double motion) { return heap.motion < motion && heap.imbalance < 0.01; }

const Observables<Heap>& heap_observables() {
  using H = Heap;
  static const Observables<H> all{
      {{"time", "", "time"}, [](const H& h) { return h.time; }},
      {{"kinetic_energy", "", "kinetic energy"}, [](const H& h) { return h.kinetic; }},
      {{"potential_energy", "", "energy of shapes, contacts, walls, gravity"},
       [](const H& h) { return h.potential; }},
      {{"total_energy", "", "their sum"}, [](const H& h) { return h.kinetic + h.potential; }},
      {{"height", "", "mean height of the mass"}, [](const H& h) { return h.height; }},
      {{"front", "", "rightmost end of a particle"}, [](const H& h) { return h.front; }},
      {{"top", "", "highest end of a particle"}, [](const H& h) { return h.top; }},
      {{"spread", "", "twice the mean distance of the mass from the left wall"},
       [](const H& h) { return h.spread; }},
      {{"slope", "", "slope of the line through the surface, downward to the right"},
       [](const H& h) { return h.slope; }},
      {{"floor_force", "weight", "upward force of the floor; 1 at rest"},
       [](const H& h) { return h.walls.floor; }},
      {{"left_force", "weight", "force of the left wall, to the right"},
       [](const H& h) { return h.walls.left; }},
      {{"right_force", "weight", "force of the right wall, to the left"},
       [](const H& h) { return h.walls.right; }},
      {{"drag", "weight", "friction of the floor, to the right; at rest all three add to 0"},
       [](const H& h) { return h.walls.drag; }},
      {{"motion", "", "kinetic energy over that of a fall by one diameter"},
       [](const H& h) { return h.motion; }},
      {{"imbalance", "weight", "largest net force on a particle over its weight"},
       [](const H& h) { return h.imbalance; }}};
  return all;
}

}  // namespace supple
