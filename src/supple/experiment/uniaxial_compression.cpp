#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "supple/core/error.hpp"
#include "supple/core/whole_number.hpp"
#include "supple/experiment/body_motion.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/experiment/frame_schedule.hpp"
#include "supple/experiment/key_sets.hpp"
#include "supple/experiment/packing_record.hpp"
#include "supple/experiment/sound_states.hpp"
#include "supple/model/bodies.hpp"
#include "supple/observe/wall_forces.hpp"

namespace supple {

namespace {

/// The packing between four walls, of the case or of a state; the strain counts from here.
Packing<2> boxed_packing(const Case& c, const InitialState* initial, const Making& making) {
  Packing<2> p = make_boxed_packing(c, initial, c.uniaxial.packing_fraction, c.uniaxial.aspect_ratio, making);
  put_at_rest(p.system);
  return p;
}

/// Area that the particles would cover if none overlapped [length^2].
double lone_area(const Packing<2>& packing) {
  System<2> apart = packing.system;
  const int bodies = apart.topology.body_count(apart.state.size());
  double at = 0;
  for (int b = 0; b < bodies; ++b) {
    const double radius = outer_radius(apart, b);
    at += 1.1 * radius;
    move_body(apart, b, Vec2{at, 0} - body_centre(apart, b));
    at += 1.1 * radius;
  }
  place_sites(apart);
  apart.box.length = {at, 1};
  return packing_fraction(apart, packing.outline).total * apart.box.volume();
}

struct WallInstant : PackingInstant<2> {
  double strain;
  WallForces walls() const { return sum_wall_forces(report.evaluation.wall); }
  double pairs() const { return static_cast<double>(report.network.pairs.size()); }
  double sites() const { return static_cast<double>(report.contacts.size()); }
  double covered_area() const { return report.fraction.total * packing.system.box.volume(); }
};

Observables<WallInstant> wall_observables(const Packing<2>& packing) {
  using W = WallInstant;
  Observables<W> all{{{"strain", "", "how far the upper wall has come down, over the first height"},
                      [](const W& w) { return w.strain; }}};
  all.add(packing_observables<2>(packing.pressure_symbol));
  all.add(
      {{{"wall_force", "", "force of the particles on the upper wall"},
        [](const W& w) { return w.walls().lid; }},
       {{"floor_force", "", "force of the particles on the lower wall"},
        [](const W& w) { return w.walls().floor; }},
       {{"vertex_contacts", "", "vertices that touch another particle"},
        [](const W& w) { return w.sites(); }},
       {{"contact_length", "",
         "vertices in contact per pair of particles that touch: 1 or 2 at a point, more on a facet"},
        [](const W& w) { return w.pairs() > 0 ? w.sites() / w.pairs() : 0; }},
       {{"mean_overlap", "contact distance", "mean depth of contacts over the distance at which they begin"},
        [](const W& w) {
          return mean_overlap(w.packing.system, w.report.records, w.packing.field->bodies()->laws());
        }},
       {{"overlap_area", "", "share of the particles' area that lies in another one"},
        [](const W& w) { return std::max(0.0, 1 - w.covered_area() / lone_area(w.packing)); }},
       {{"mean_shape_parameter", "", "mean p^2/(4 pi a) of the polygons; 1 without any"},
        [](const W& w) { return mean_shape_parameter(w.report.shapes).value_or(1); }}});
  return all;
}

/// Steps of the upper wall on its way down.
std::int64_t wall_steps(const Case& c) {
  return std::max<std::int64_t>(
      1, whole_number(c.uniaxial.strain / c.uniaxial.step, "steps of the wall", "raise uniaxial.step", 1e9));
}

/// Lowers the upper wall to `height`; what is below moves with the strain, bodies as wholes.
void lower_wall(System<2>& s, double height) {
  scale_cell(s, {1, height / s.box.length[gradient]});
  s.box.length[gradient] = height;
}

/// How far the compression has got.
struct Compressed {
  JamState<2> squeeze;
  bool is_squeezed = false;
  double height = 0;      ///< of the box where the strain begins
  std::int64_t step = 0;  ///< of the wall
  JamProgress<2> work;

  void keep(Keeper& k) {
    k("squeeze", squeeze);
    k("is_squeezed", is_squeezed);
    k("height", height);
    k("step", step);
    k("work", work);
  }
};

/// Moves all walls together until the pressure is that from which the compression starts.
void squeeze(const Case& c, Packing<2>& packing, Compressed& state, const Keep& keep, Recorder& recorder) {
  JamSpec spec;
  spec.pressure = c.uniaxial.pressure;
  spec.step = 5e-3;
  state.work = jam(
      packing, spec, state.squeeze,
      [&] { recorder.hold(keep, "after minimisation", state.squeeze.minimisations()); },
      [&](const JamProgress<2>& p) {
        recorder.progress(
            fmt::format("squeeze: to P = {:.1e}, phi = {:.4f}", spec.pressure, reached_fraction(packing, p)),
            0, 0);
        return true;
      });
}

void count(JamProgress<2>& work, const MinimiseReport& done) {
  work.last = done;
  ++work.minimisations;
  work.evaluations += done.evaluations;
  work.unconverged += !done.converged;
}

/// The course from the first to the last strain; a row of the table for each step, and frames.
void compress(const Case& c, Packing<2>& packing, Compressed& state, LastGood<2>& good, const Keep& keep,
              Recorder& recorder) {
  const Observables<WallInstant> observables = wall_observables(packing);
  const std::int64_t steps = wall_steps(c);
  FrameSchedule frames(steps, c.output.frames);
  frames.skip_to(state.step);
  for (; state.step <= steps; ++state.step) {
    recorder.hold(keep, "before step of the wall", state.step);
    const double strain = c.uniaxial.strain * static_cast<double>(state.step) / static_cast<double>(steps);
    lower_wall(packing.system, state.height * (1 - strain));
    const MinimiseReport report = relax(packing);
    count(state.work, report);
    require_converged(packing, report, fmt::format("the packing at strain {:.4f}", strain));
    remember(packing, report, good.look());
    const PackingReport<2> row = report_packing(packing);
    observables.append("packing", {{packing, row, state.work}, strain}, recorder);
    if (frames.due(state.step)) {
      Frame<2> frame = packing_frame(packing, row);
      frame.numbers["uniaxial_strain"] = strain;
      recorder.frame(frame);
    }
    recorder.progress(fmt::format("compress: strain {:.3f}", strain), state.step, steps);
  }
}

std::vector<Derived> derive_uniaxial_compression(const Case& c, const InitialState* initial) {
  std::vector<Derived> all = derived_equilibria(boxed_packing(c, initial, set_apart));
  all.push_back({{"minimisations", "", "steps of the wall, each with a minimisation"},
                 static_cast<double>(wall_steps(c))});
  return all;
}

void run_uniaxial_compression(const Case& c, const InitialState* initial, Recorder& recorder) {
  Packing<2> packing = boxed_packing(c, initial, at_random(recorder));
  begin_packing(packing, derive_uniaxial_compression(c, initial), recorder);
  const Observables<WallInstant> observables = wall_observables(packing);
  observables.declare("packing", recorder);
  Compressed state;
  LastGood<2> good(packing);
  const Keep keep = [&](Keeper& k) {
    k("packing", packing);
    k("good", good);
    k("compressed", state);
  };
  restore(recorder, keep);
  try {
    if (!state.is_squeezed) {
      if (!initial && c.uniaxial.pressure > 0) squeeze(c, packing, state, keep, recorder);
      state.is_squeezed = true;
      state.squeeze = {};
      state.height = packing.system.box.length[gradient];
      good.trust();
    }
    compress(c, packing, state, good, keep, recorder);
  } catch (const Error&) {
    hand_over_packing(packing, recorder);
    throw;
  }
  const JamProgress<2>& work = state.work;
  const PackingReport<2> report = report_packing(packing);
  observables.record({{packing, report, work}, c.uniaxial.strain}, recorder,
                     one_of({"wall_force", "contact_length", "mean_overlap", "overlap_area"}));
  record_packing(packing, work, recorder);
}

}  // namespace

Experiment uniaxial_compression() {
  return {.name = "uniaxial_compression",
          .meaning = "deformable particles squeezed in a box of walls (9.4)",
          .matter = &body_matter(),
          .keys = with(minimised_keys(), {"contact.k_p", "uniaxial.*", "output.frames"}),
          .derive = derive_uniaxial_compression,
          .run = run_uniaxial_compression,
          .figure = always<Figure::wall>,
          .first_keys = {"experiment", "seed", "bodies.family", "bodies.N", "uniaxial.strain",
                         "uniaxial.packing_fraction"}};
}

}  // namespace supple
