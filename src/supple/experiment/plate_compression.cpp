#include <fmt/format.h>

#include <algorithm>

#include "supple/core/error.hpp"
#include "supple/experiment/between_plates.hpp"
#include "supple/experiment/bodies_of_case.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/experiment/frame_schedule.hpp"
#include "supple/experiment/key_sets.hpp"
#include "supple/experiment/packing_record.hpp"
#include "supple/experiment/plate_exponents.hpp"
#include "supple/observe/shape_measures.hpp"

namespace supple {

namespace {

/// An equilibrium between the plates.
template <int Dim>
struct PlateInstant {
  const Packing<Dim>& packing;
  const PlateState<Dim>& state;
  const Evaluation<Dim>& evaluation;
  PlateForces plates;
  double compression;
  bool is_down;
  double unit;  ///< of dimensionless forces

  double width() const {
    double sum = 0;
    for (int d = 0; d < Dim - 1; ++d) sum += reach_along(packing.system, 0, d).length();
    return sum / (Dim - 1) / state.width;
  }
  double volume() const { return measure_shapes(packing.system).volume[0] / state.volume; }
};

template <int Dim>
Observables<PlateInstant<Dim>> plate_observables(const std::string& unit) {
  using P = PlateInstant<Dim>;
  return {
      {{"compression", "",
        "delta/D: how much nearer the plates have come, over their distance at first touch"},
       [](const P& p) { return p.compression; }},
      {{"gap", "", "distance of the plates"},
       [](const P& p) { return p.packing.system.box.length[Dim - 1]; }},
      {{"force", unit, "of the upper plate on the particle"},
       [](const P& p) { return p.plates.upper / p.unit; }},
      {{"upper_force", "", "of the upper plate on the particle"}, [](const P& p) { return p.plates.upper; }},
      {{"lower_force", "", "of the lower plate on the particle"}, [](const P& p) { return p.plates.lower; }},
      {{"upper_nodes", "", "vertices that touch the upper plate"},
       [](const P& p) { return static_cast<double>(p.plates.upper_sites); }},
      {{"lower_nodes", "", "vertices that touch the lower plate"},
       [](const P& p) { return static_cast<double>(p.plates.lower_sites); }},
      {{"energy", "", "potential energy, the springs of the plates included"},
       [](const P& p) { return p.evaluation.energy.stored(); }},
      {{"width", "width at first touch", "mean extent of the particle along the plates"},
       [](const P& p) { return p.width(); }},
      {{"volume_change", "",
        Dim == 2 ? "of the enclosed area, relative" : "of the enclosed volume, relative"},
       [](const P& p) { return p.volume() - 1; }},
      {{"rotation", "radian", "how far the particle has turned as a whole since first touch"},
       [](const P& p) { return turned_by<Dim>(p.state.shape, p.packing.system.state.position); }},
      {{"residual", "", "largest net force on a vertex, or on a rigid particle"},
       [](const P& p) { return p.state.last.residual; }},
      {{"tolerance", "", "residual at which its minimisation was done"},
       [](const P& p) { return p.state.last.tolerance; }},
      {{"evaluations", "", "force evaluations so far"},
       [](const P& p) { return static_cast<double>(p.state.evaluations); }},
      {{"branch", "", "1: the plate comes down, -1: it goes up again"},
       [](const P& p) { return p.is_down ? 1.0 : -1.0; }}};
}

template <int Dim>
void record_results(const Case& c, Packing<Dim>& packing, const PlateState<Dim>& state, double largest_force,
                    double largest_rotation, Recorder& recorder) {
  record_exponents(c.plates, recorder);
  const auto record = [&](const char* name, const std::string& unit, const char* meaning, double value) {
    recorder.value("results", {name, unit, meaning}, value);
  };
  const ForceUnit unit = plate_force_unit(packing, state.diameter);
  record("diameter", "", "distance of the plates at first touch", state.diameter);
  record("force_unit", "", "unit of the column force", unit.value);
  record("largest_force", unit.symbol, "of the upper plate, at the largest compression", largest_force);
  record("touching_nodes", "", "vertices that touch the plate that fewer touch, at the largest compression",
         touching_nodes(recorder));
  record("largest_rotation", "radian", "how far the particle has turned as a whole at most",
         largest_rotation);
  record("work", "", "of the upper plate on its way down", state.work_down);
  if (c.plates.decompress)
    record("hysteresis", "", "share of that work that the particle does not give back on the way up",
           state.work_down > 0 ? 1 - state.work_up / state.work_down : 0);
  JamProgress<Dim> progress;
  progress.last = state.last;
  progress.minimisations = state.minimisations;
  progress.evaluations = state.evaluations;
  record_packing(packing, progress, recorder, Surroundings::open);
}

template <int Dim>
std::vector<Derived> derive_plate_compression(const Case& c, const InitialState* initial) {
  const Packing<Dim> packing = packing_between_plates<Dim>(c, initial, set_apart);
  std::vector<Derived> all = derived_packing(packing);
  all.push_back({{"force_tolerance", "mean force of a vertex at a plate", "largest net force in equilibrium"},
                 packing.tolerance.relative});
  all.push_back({{"minimisations", "", "steps of the plate, each with a minimisation"},
                 static_cast<double>(plate_course(c.plates).compression.size())});
  return all;
}

/// Of the way so far.
struct Largest {
  double force = 0, rotation = 0;

  void keep(Keeper& k) {
    k("force", force);
    k("rotation", rotation);
  }
};

template <int Dim>
void run_plate_compression(const Case& c, const InitialState* initial, Recorder& recorder) {
  Packing<Dim> packing = packing_between_plates<Dim>(c, initial, at_random(recorder));
  begin_packing(packing, derive_plate_compression<Dim>(c, initial), recorder);
  const PlateCourse course = plate_course(c.plates);
  const auto steps = static_cast<std::int64_t>(course.compression.size()) - 1;
  PlateState<Dim> state;
  Largest largest;
  LastGood<Dim> good(packing);
  const Keep keep = [&](Keeper& k) {
    k("packing", packing);
    k("good", good);
    k("plates", state);
    k("largest", largest);
  };
  restore(recorder, keep);
  try {
    if (state.step < 0) {
      recorder.hold(keep, "before step of the plate", 0);
      touch_plates(c, initial, packing, state);
      good.look();
    }
    const ForceUnit unit = plate_force_unit(packing, state.diameter);
    const Observables<PlateInstant<Dim>> observables = plate_observables<Dim>(unit.symbol);
    observables.declare(plate_table, recorder);
    FrameSchedule frames(steps, c.output.frames);
    frames.skip_to(state.step);
    for (; state.step <= steps; ++state.step) {
      recorder.hold(keep, "before step of the plate", state.step);
      const auto k = static_cast<std::size_t>(state.step);
      const double gap_before = packing.system.box.length[Dim - 1];
      const double gap = state.diameter * (1 - course.compression[k]);
      if (k > 0) move_plate(c, packing, state, gap);
      remember(packing, state.last, good.look());
      Evaluation<Dim> evaluation;
      packing.field->evaluate(packing.system, Detail::energies, evaluation);
      const PlateInstant<Dim> now{packing,
                                  state,
                                  evaluation,
                                  sum_plate_forces<Dim>(evaluation.wall),
                                  course.compression[k],
                                  course.is_down(k),
                                  unit.value};
      const double work = 0.5 * (state.force_before + now.plates.upper) * (gap_before - gap);
      if (course.is_down(k)) state.work_down += work;
      else state.work_up -= work;
      state.force_before = now.plates.upper;
      if (k == course.turn) largest.force = now.plates.upper / unit.value;
      largest.rotation =
          std::max(largest.rotation, turned_by<Dim>(state.shape, packing.system.state.position));
      observables.append(plate_table, now, recorder);
      if (frames.due(state.step)) {
        Frame<Dim> frame = packing_frame(packing, report_packing(packing), Surroundings::open);
        frame.numbers["uniaxial_strain"] = now.compression;
        recorder.frame(frame);
      }
      recorder.progress(fmt::format("plates: delta/D = {:.2e}", now.compression), state.step, steps);
    }
  } catch (const Error&) {
    hand_over(packing, recorder);
    throw;
  }
  record_results(c, packing, state, largest.force, largest.rotation, recorder);
}

void check_plates(const Case& c, Problems& problems) {
  const PlateCompression& p = c.plates;
  const auto refuse = [&](const std::string& what, const char* why, const char* to_do) {
    add_problem(problems, c, what, why, to_do);
  };
  if (c.bodies.count != 1)
    refuse(fmt::format("bodies.N = {}", c.bodies.count), "between the plates there is one particle",
           "leave it away, or set it to 1");
  if (p.spacing == "logarithmic" && p.first >= p.strain)
    refuse(fmt::format("plates.first = {} is not below plates.strain = {}", p.first, p.strain),
           "compressions go from the one to the other", "lower the first or raise the second");
  if (p.fit_from > 0 && p.fit_from >= (p.fit_to > 0 ? p.fit_to : p.strain))
    refuse(fmt::format("plates.fit_from = {} is not below {} = {}", p.fit_from,
                       p.fit_to > 0 ? "plates.fit_to" : "plates.strain", p.fit_to > 0 ? p.fit_to : p.strain),
           "exponents are fitted between them", "lower the first or raise the second");
}

/// One particle; and second order from the start where its factorisation is cheap, because each step begins
/// near its minimum. That of a large solid in 3D fills up: forces alone are faster.
void complete_plates(Case& c) {
  if (!c.is_given("bodies.N")) c.bodies.count = 1;
  c.bodies.large_fraction = 0;
  if (c.is_given("minimise.method")) return;
  const bool flat = c.bodies.dimensions == 2;
  const std::int64_t sites = sample_size(c).sites, cheap = flat ? 5000 : 500, fills = 2000;
  if (sites <= cheap) c.minimise.method = "newton";
  else if (!flat && sites > fills && is_solid(c.bodies)) c.minimise.method = "fire";
}

}  // namespace

Experiment plate_compression() {
  return {.name = "plate_compression",
          .meaning = "one particle between two rigid plates: force against compression (9.3.4)",
          .matter = &body_matter(),
          .keys = with(minimised_keys(), {"-species.*", "-bodies.size_ratio", "-bodies.large_fraction",
                                          "-bodies.A0_ratio_large", "-bodies.vertex_rule", "-bodies.discs",
                                          "-contact.law", "-contact.attraction_range", "-contact.A.B.*",
                                          "contact.k_p", "plates.*", "output.frames"}),
          .needs = {{"plates.first", Need::Of::value,
                     [](const Case& c) { return c.plates.spacing == "logarithmic"; },
                     "plates.spacing = \"logarithmic\""},
                    {"plates.orientation", Need::Of::value,
                     [](const Case& c) { return !starts_from_file(c) && has_polygons(c); },
                     "a particle with edges that the case makes: one of a file stays as it is"}},
          .derive = {derive_plate_compression<2>, derive_plate_compression<3>},
          .run = {run_plate_compression<2>, run_plate_compression<3>},
          .figure = always<Figure::plates>,
          .first_keys = {"experiment", "seed", "bodies.family", "bodies.vertices", "plates.strain",
                         "plates.steps"},
          .complete = complete_plates,
          .check = check_plates};
}

}  // namespace supple
