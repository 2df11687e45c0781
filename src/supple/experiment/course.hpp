/// A system on its way through a protocol: one loop for all that is sheared.
#pragma once
#include <cstdint>
#include <functional>

#include "supple/experiment/recorder.hpp"
#include "supple/solve/stepper.hpp"

namespace supple {

struct Course {
  const char* phase;  ///< for the progress
  std::int64_t steps,
      rows;  ///< rows: instants, one before each step, and the one after the last if it is to be seen
  std::int64_t frames;  ///< evenly spaced over the rows
  double time_step, damping;
  std::function<ShearRates(std::int64_t row, double time)> rates;
};

/// An instant whose forces are known; with energies where a frame is kept.
struct CourseRow {
  std::int64_t row;
  const Evaluation<2>& evaluation;
  ShearRates rates;
  bool keeps_frame;
};

/// Takes the steps from `row` on and shows `see` each row before its step. Each row is a safe point, which
/// `keep` saves, with the row. Throws what the stepper throws.
void move(const Course& course, System<2>& system, Stepper<2>& stepper, Recorder& recorder, std::int64_t& row,
          const Keep& keep, const std::function<void(const CourseRow&)>& see);

}  // namespace supple
