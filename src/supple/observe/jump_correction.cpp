#include "supple/observe/jump_correction.hpp"

#include <algorithm>
#include <cmath>

namespace supple {
namespace {

/// `now` moved by whole cells to where it would be, had it not been wrapped since `before`.
Vec2 unwrapped(const Box<2>& box, const Vec2& before, Vec2 now) {
  const double up = std::round((before[gradient] - now[gradient]) / box.length[gradient]);
  now[gradient] += up * box.length[gradient];
  now[flow] += up * box.lattice().shift;
  now[flow] += std::round((before[flow] - now[flow]) / box.length[flow]) * box.length[flow];
  return now;
}

/// The same contacts and forces with the discs at these places: which contacts cross the cut follows from
/// them.
StressTensors tensors_with(const std::vector<Vec2>& position, System<2> system, Evaluation<2> evaluation,
                           double unit) {
  system.state.position = position;
  const double half_cell = 0.5 * std::min(system.box.length[0], system.box.length[1]);
  for (int row = 0; row < system.pairs.size(); ++row) {
    PairForce<2>& p = evaluation.pair[row];
    if (!p.active) continue;
    const Vec2 direct = position[system.pairs.second[row]] - position[system.pairs.first[row]];
    p.crosses = norm(p.distance * p.normal - direct) > half_cell;
  }
  return stress_tensors(system, evaluation, unit);
}

}  // namespace

double JumpCorrection::corrected(const System<2>& system, const Evaluation<2>& evaluation,
                                 const StressTensors& tensors, double unit) {
  const std::vector<Vec2>& now = system.state.position;
  const Vec2 half = 0.5 * system.box.length;
  bool wrapped = false;
  for (std::size_t i = 0; i < before_.size(); ++i)
    wrapped |= std::abs(now[i][0] - before_[i][0]) > half[0] || std::abs(now[i][1] - before_[i][1]) > half[1];
  if (wrapped) {
    std::vector<Vec2> position = now;
    for (std::size_t i = 0; i < now.size(); ++i) position[i] = unwrapped(system.box, before_[i], now[i]);
    removed_ += tensors.shear_external() - tensors_with(position, system, evaluation, unit).shear_external();
    most_removed_ = std::max(most_removed_, std::abs(removed_ - start_));
  }
  before_ = now;
  return tensors.shear_external() - removed_;
}

}  // namespace supple
