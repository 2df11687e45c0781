/// Counts what is found wrong with bodies.
#pragma once
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "supple/observe/soundness.hpp"

namespace supple {

class SoundnessTally {
 public:
  explicit SoundnessTally(std::size_t bodies) : inside_(bodies), crossing_(bodies) {
    found.unsound.resize(bodies);
  }

  /// Adds one to a number of `found` if this is wrong with the body.
  void count(int body, int Soundness::*number, bool wrong) {
    if (!wrong) return;
    ++(found.*number);
    found.unsound[body] = 1;
  }
  /// Each body counts once, however many others it is in or crosses.
  void note_inside(int body) { inside_[body] = 1; }
  void note_crossing(int body) { crossing_[body] = 1; }

  /// Of two round bodies: the smaller one may lie in the larger one.
  void look_at_round(int a, double radius, int b, double other, double distance) {
    if (distance < std::abs(radius - other)) note_inside(radius < other ? a : b);
  }

  Soundness result() {
    for (int b = 0; b < static_cast<int>(inside_.size()); ++b) {
      count(b, &Soundness::inside, inside_[b]);
      count(b, &Soundness::crossing, crossing_[b]);
    }
    return std::move(found);
  }

  Soundness found;

 private:
  std::vector<std::uint8_t> inside_, crossing_;
};

}  // namespace supple
