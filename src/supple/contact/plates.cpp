#include "supple/contact/plates.hpp"

namespace supple {

void evaluate_plates(const System<2>& system, const Repulsion& repulsion, double k, Detail detail, Evaluation<2>& out) {
  const double top = system.box.length[gradient];
  const auto touch = [&](std::int32_t i, double height, double direction) {
    const double d = 2 * height, d0 = 2 * system.state.radius[i];
    std::visit([&](const auto& law) {
      const Vec2 force{0, direction * law.force(d, d0, k)};
      out.force[i] += force;
      out.wall.push_back({i, force});
      // The mirror image moves with the disc: d changes twice as fast as the height, so half of the pair's energy.
      if (detail == Detail::energies) out.energy.wall += 0.5 * law.energy(d, d0, k);
    }, repulsion);
  };
  for (std::int32_t i = 0; i < system.state.size(); ++i) {
    const double y = system.state.position[i][gradient], r = system.state.radius[i];
    if (system.state.mobility[i] != Mobility::free) continue;
    if (y < r) touch(i, y, 1);
    if (top - y < r) touch(i, top - y, -1);
  }
}

}  // namespace supple
