#include "supple/experiment/course.hpp"

#include "supple/experiment/frame_schedule.hpp"

namespace supple {

std::optional<std::int64_t> move(const Course& course, System<2>& system, Stepper& stepper,
                                 Recorder& recorder, const std::function<void(const CourseRow&)>& see) {
  FrameSchedule frames(course.rows - 1, course.frames);
  for (std::int64_t row = 0; row < course.rows; ++row) {
    const ShearRates rates = course.rates(row, system.time);
    const bool keeps_frame = frames.due(row);
    see({row, keeps_frame ? stepper.evaluate_energies(system, rates) : stepper.evaluate(system, rates), rates,
         keeps_frame});
    if (recorder.stop_requested()) return row;
    if (row < course.steps) stepper.advance(system, rates, course.time_step, course.damping);
    if (row % 256 == 0) recorder.progress(course.phase, row, course.steps);
  }
  recorder.progress(course.phase, course.steps, course.steps);
  return std::nullopt;
}

}  // namespace supple
