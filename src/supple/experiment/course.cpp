#include "supple/experiment/course.hpp"

#include "supple/experiment/frame_schedule.hpp"

namespace supple {

void move(const Course& course, System<2>& system, Stepper<2>& stepper, Recorder& recorder, std::int64_t& row,
          const Keep& keep, const std::function<void(const CourseRow&)>& see) {
  FrameSchedule frames(course.rows - 1, course.frames);
  frames.skip_to(row);
  for (; row < course.rows; ++row) {
    recorder.safe_point(keep, "at step", row);
    const ShearRates rates = course.rates(row, system.time);
    const bool keeps_frame = frames.due(row);
    see({row, keeps_frame ? stepper.evaluate_energies(system, rates) : stepper.evaluate(system, rates), rates,
         keeps_frame});
    if (row < course.steps) stepper.advance(system, rates, course.time_step, course.damping);
    if (row % 256 == 0) recorder.progress(course.phase, row, course.steps);
  }
  recorder.progress(course.phase, course.steps, course.steps);
}

}  // namespace supple
