#include "bench/dense_discs.hpp"

#include <algorithm>
#include <numbers>
#include <numeric>

#include "supple/core/random.hpp"
#include "supple/model/discs.hpp"

namespace supple::bench {
namespace {

/// Place of a cell along Morton's curve: the bits of its two indices interleaved.
std::uint64_t morton(std::uint32_t x, std::uint32_t y) {
  std::uint64_t place = 0;
  for (int bit = 0; bit < 32; ++bit)
    place |= (static_cast<std::uint64_t>(x >> bit & 1) << (2 * bit)) |
             (static_cast<std::uint64_t>(y >> bit & 1) << (2 * bit + 1));
  return place;
}

/// Numbers discs at rest along the curve, so that neighbours in space are neighbours in memory.
void number_in_space(State<2>& s, double cell) {
  std::vector<int> order(s.position.size());
  std::iota(order.begin(), order.end(), 0);
  const auto place = [&](int i) {
    return morton(static_cast<std::uint32_t>(s.position[i][0] / cell),
                  static_cast<std::uint32_t>(s.position[i][1] / cell));
  };
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return std::pair(place(a), a) < std::pair(place(b), b); });
  const State<2> old = s;
  for (std::size_t i = 0; i < order.size(); ++i) {
    s.position[i] = old.position[order[i]];
    s.radius[i] = old.radius[order[i]];
    s.mass[i] = old.mass[order[i]];
    s.inertia[i] = old.inertia[order[i]];
  }
}

void relax(System<2>& system) {
  DiscLaw law = dense_law();
  law.friction = 0;
  Mover dynamics{ForceField<2>(DiscContacts(Divergent(0), law))};
  for (int step = 0; step < 1000; ++step) {
    dynamics.evaluate(system, {});
    dynamics.advance(system, {}, 0.1, 0.9);
  }
}

void set_in_motion(System<2>& system, double speed) {
  State<2>& s = system.state;
  Vec2 mean{};
  for (int i = 0; i < s.size(); ++i) {
    RandomStream draw(1, Purpose::test, static_cast<std::uint64_t>(i));
    const double width = std::sqrt(3.0) * speed;  // uniform in [-width, width): the variance is speed^2
    s.velocity[i] = {draw.uniform(-width, width), draw.uniform(-width, width)};
    s.spin[i] = 0;
    mean += (1.0 / s.size()) * s.velocity[i];
  }
  for (Vec2& v : s.velocity) v -= mean;
}

}  // namespace

DiscLaw dense_law() {
  const PairStiffness s{1, 0.01, 1, 0.01};
  return {s, s, Tensile{}, 0.5, Slip::clamp, LeverArm::distance};
}

Mover<2> dense_dynamics(double relative_skin) {
  return Mover(ForceField<2>(DiscContacts(Divergent(0), dense_law()), relative_skin));
}

System<2> dense_discs(const DenseSpec& spec) {
  const double pi = std::numbers::pi, b = spec.size_ratio, small = 0.5;
  const int n = spec.discs, small_count = n / 2;
  const double area = pi * small * small * (small_count + (n - small_count) * b * b);
  Box<2> box;
  box.length[flow] = std::sqrt(area / spec.packing_fraction / spec.aspect_ratio);
  box.length[gradient] = spec.aspect_ratio * box.length[flow];
  System<2> system = random_discs(box, {n, spec.packing_fraction, b, 1 / (pi * small * small)}, 1);
  number_in_space(system.state, 2 * small);
  relax(system);
  set_in_motion(system, spec.speed);
  system.pairs = {};
  system.time = system.lag = 0;
  system.step = 0;
  return system;
}

double contacts_per_disc(const System<2>& system) {
  long touching = 0;
  for (ContactState s : system.pairs.state) touching += s != ContactState::open;
  return 2.0 * static_cast<double>(touching) / system.state.size();
}

double rms_speed(const System<2>& system) {
  const State<2>& s = system.state;
  double twice_energy = 0, mass = 0;
  for (int i = 0; i < s.size(); ++i) {
    twice_energy += s.mass[i] * dot(s.velocity[i], s.velocity[i]);
    mass += s.mass[i];
  }
  return std::sqrt(twice_energy / (2 * mass));
}

}  // namespace supple::bench
