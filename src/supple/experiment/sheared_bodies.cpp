#include "supple/experiment/sheared_bodies.hpp"

#include <string>

#include "supple/core/error.hpp"
#include "supple/experiment/body_rheology.hpp"
#include "supple/experiment/frame_schedule.hpp"
#include "supple/experiment/sound_states.hpp"

namespace supple {

namespace {

/// Velocities of the instant of the positions; the packing's own report of everything else.
Frame sheared_frame(Packing& packing, const DiscDynamics& dynamics, double rate_now) {
  Frame frame = packing_frame(packing, report_packing(packing));
  dynamics.bring_to_instant(packing.system, rate_now, frame.velocity, frame.spin);
  frame.strain_rate = rate_now;
  return frame;
}

}  // namespace

Making sheared(Making making) {
  making.flow = Flow::kept;
  return making;
}

void refuse_rigid(const Packing& packing) {
  if (!packing.system.rigid.empty())
    throw input_error("shear of rigid particles", "rigid polygons cross no sheared boundary yet",
                      "choose another family, or discs (bodies.family = \"disc\")");
}

/// Links the particles, if the case asks for it and they are not linked yet.
void link_packing(const Case& c, Packing& packing, Recorder& recorder) {
  if (c.particles.permanent_links && packing.system.links.empty())
    recorder.value("results", {"clusters", "", "clusters of particles that links hold together"},
                   crosslink_bodies(c, packing));
  recorder.value("results", {"links", "", "permanent links of vertices"},
                 static_cast<double>(packing.system.links.size()));
}

ShearedBodies::ShearedBodies(const Case& c, const InitialState* initial, Packing& packing, Recorder& recorder)
    : packing_(packing),
      recorder_(recorder),
      dynamics_(*packing.field),
      table_(packing, c.output.tensors, recorder),
      energies_(recorder, dynamics_, packing.system, reduced_units(), c, initial) {}

void ShearedBodies::move(const char* phase, std::int64_t steps, double dt, double damping, int frames,
                         const std::function<ShearRates(std::int64_t)>& rates_at) {
  System<2>& s = packing_.system;
  FrameSchedule schedule(steps, frames);
  LastGood good(packing_);
  try {
    for (std::int64_t i = 0; i <= steps; ++i) {
      const ShearRates rates = rates_at(i);
      const bool keeps_frame = schedule.due(i);
      if (keeps_frame || i % look_interval(steps) == 0) good.look();
      const Evaluation<2>& now = dynamics_.evaluate_energies(s, rates);
      table_.append(now, rates.now);
      energies_.append(s, now);
      if (keeps_frame) recorder_.frame(sheared_frame(packing_, dynamics_, rates.now));
      if (recorder_.stop_requested())
        throw Error(ErrorKind::interrupted, "interrupted at step " + std::to_string(i));
      if (i < steps) dynamics_.advance(s, rates, dt, damping);
      if (i % 256 == 0) recorder_.progress(phase, i, steps);
    }
  } catch (const Error&) {
    energies_.finish();
    hand_over(packing_, recorder_);
    throw;
  }
  recorder_.progress(phase, steps, steps);
}

void ShearedBodies::finish() {
  const Evaluation<2>& last = dynamics_.evaluate_energies(packing_.system, {});
  energies_.finish();
  recorder_.value("results",
                  {"energy_residual", "", "what the balance of energy lacks, over all that was lost"},
                  energies_.relative_residual(packing_.system, last));
  record_packing(packing_, {}, recorder_);
}

}  // namespace supple
