#include "supple/experiment/suspension.hpp"

#include <numbers>

#include "supple/experiment/experiments.hpp"
#include "supple/experiment/frame.hpp"
#include "supple/experiment/microgel.hpp"
#include "supple/model/convert.hpp"
#include "supple/model/sanity.hpp"
#include "supple/observe/body_stress.hpp"
#include "supple/observe/energy_balance.hpp"
#include "supple/observe/stress.hpp"

namespace supple {

Box<2> make_box(const Case& c, const Units& units) {
  Box<2> box;
  const double per_metre = 1 / units.length;  // a power of ten: 500 um stay 500 exactly
  box.length = {c.box.width * per_metre, c.box.height * per_metre};
  if (c.box.boundary == "fixed") box.periodic = {false, false};
  return box;
}

CrosslinkSpec crosslink_spec(const Case& c) {
  const Particles& p = c.particles;
  return {p.cut == "lines" ? CutKind::lines : CutKind::voronoi,
          p.cut_lines,
          p.edge_fuzziness,
          p.avoid_horizontal_angle_degree * std::numbers::pi / 180,
          p.avoid_height_spanning_particles,
          p.max_cut_tries,
          p.cut_top_bottom,
          p.remove_link_fraction};
}

void take_state(Suspension& s, const Case& c, const InitialState& initial, int history_width) {
  s.system = system_of<2>(initial);
  convert(s.system, initial.units, s.units);
  set_history_width(s.system.pairs, history_width);
  if (c.is_given("box.boundary")) s.system.box.periodic = make_box(c, s.units).periodic;
  const Plates kind = plates_of(c);
  s.stepper->set_plates(kind);
  if (kind == Plates::capture) return capture_at_boundaries(s.system, kind);
  leave_plates(s.system);
}

namespace {

/// Of free discs and of all spins, with the velocities that the frame gives: the flow has the rate of this
/// instant.
double kinetic_energy_of(const Frame<2>& frame, const State<2>& s) {
  double sum = 0;
  for (std::size_t i = 0; i < frame.velocity.size(); ++i) {
    if (frame.mobility[i] == Mobility::free)
      sum += 0.5 * s.mass[i] * dot(frame.velocity[i], frame.velocity[i]);
    sum += 0.5 * s.inertia[i] * frame.spin[i] * frame.spin[i];
  }
  return sum;
}

/// Energies by term, and the stress of all contacts: (1/A) sum F l^T.
void add_numbers(Frame<2>& frame, const Suspension& s, const Evaluation<2>& evaluation) {
  const Mat2 contact = stress_tensors(s.system, evaluation).virial;
  frame.numbers["pressure"] = pressure(contact);
  add_tensor(frame.numbers, "contact_stress", contact);
  if (!s.stepper->has_energies()) return;
  const EnergyState e = energy_state(s.system, evaluation);
  frame.numbers["kinetic_energy"] = kinetic_energy_of(frame, s.system.state);
  frame.numbers["contact_energy"] = e.elastic;
  frame.numbers["tangential_energy"] = e.tangential;
  frame.numbers["wall_energy"] = e.wall;
}

}  // namespace

Frame<2> frame_of(const Suspension& s, const Evaluation<2>& evaluation, ShearRates rates) {
  Frame<2> frame = make_frame(s.system, evaluation);
  s.stepper->bring_to_instant(s.system, rates.now, frame.velocity, frame.spin);
  frame.strain_rate = rates.now;
  add_numbers(frame, s, evaluation);
  return frame;
}

template <int Dim>
void start_clock(System<Dim>& system, const Case& c, const Recorder& recorder) {
  if (c.initial.keep_time || resumed_part(recorder) == sheared_part) return;
  system.time = 0;
  system.step = 0;
}
template void start_clock(System<2>&, const Case&, const Recorder&);
template void start_clock(System<3>&, const Case&, const Recorder&);

void record_constants(const Suspension& s, const InitialState* initial, const std::vector<Derived>& derived,
                      Recorder& recorder) {
  if (resumed_part(recorder) == sheared_part) return;  // they are recorded
  for (const Derived& d : derived) recorder.value("constants", d.name, d.value);
  for_each_constant(s.material, [&](const char* name, const auto& constant) {
    if (constant)
      recorder.value(material_group, {name, "", "constant of the contact law, in the units of the run"},
                     *constant);
  });
  const auto take_over = [&](const char* name, const char* meaning, double value) {
    recorder.value(protocol_group, {name, "", meaning}, value);
  };
  take_over("dt", "time step, in the units of the run", s.time_step);
  take_over("cool_factor", "factor per step on velocity relative to the flow", s.damping);
  take_over("reset_force_each_step", "0: forces on discs of the plates pile up, as in the package",
            !initial || initial->reset_force_each_step);
}

const SuspensionModel& suspension_model(const Case& c) { return *experiment_of(c).matter->suspension; }

Suspension make_suspension(const Case& c, const InitialState* initial, Recorder& recorder) {
  Suspension s = suspension_model(c).make(c, initial, recorder);
  if (resumed_part(recorder) == sheared_part) Keeper::restoring (*recorder.resumed())("system", s.system);
  require_sane(s.system, "this suspension");
  return s;
}

}  // namespace supple
