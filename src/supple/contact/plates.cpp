#include "supple/contact/plates.hpp"

#include <algorithm>

namespace supple {

void evaluate_plates(const System<2>& system, const Repulsion& repulsion, double k, Detail detail,
                     Evaluation<2>& out) {
  const auto touch = [&](std::int32_t i, int d, double height, double sign) {
    const double distance = 2 * height, d0 = 2 * system.state.radius[i];
    std::visit(
        [&](const auto& law) {
          Vec2 force{};
          force[d] = sign * law.force(distance, d0, k);
          out.force[i] += force;
          out.wall.push_back({i, force});
          // The mirror image moves with the disc: the distance changes twice as fast as the height, so half
          // of the energy.
          if (detail == Detail::energies) out.energy.wall += 0.5 * law.energy(distance, d0, k);
        },
        repulsion);
  };
  // A disc that was thrown beyond a wall is pushed back as from its surface.
  const auto height_over = [](double y, double r) { return std::max(y, 1e-3 * r); };
  for (std::int32_t i = 0; i < system.state.size(); ++i) {
    if (system.state.mobility[i] != Mobility::free) continue;
    const double r = system.state.radius[i];
    for (int d = 0; d < 2; ++d) {
      if (d != gradient && system.box.periodic[d]) continue;
      const double x = system.state.position[i][d], top = system.box.length[d];
      if (x < r) touch(i, d, height_over(x, r), 1);
      if (top - x < r) touch(i, d, height_over(top - x, r), -1);
    }
  }
}

}  // namespace supple
