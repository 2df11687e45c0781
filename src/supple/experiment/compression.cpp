#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "supple/core/error.hpp"
#include "supple/core/whole_number.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/experiment/key_sets.hpp"
#include "supple/experiment/packing_record.hpp"
#include "supple/experiment/sound_states.hpp"
#include "supple/observe/onset.hpp"

namespace supple {

namespace {

/// From the jamming pressure to the highest, equally spaced in the logarithm.
std::vector<double> pressure_list(const Case& c) {
  const double low = c.jamming.pressure, high = c.compression.highest_pressure;
  if (!(high > low))
    throw input_error(
        fmt::format("compression.highest_pressure = {} is not above jamming.pressure = {}", high, low), "",
        "compression goes from the one to the other");
  const int steps =
      std::max(1, whole_number<int>(c.compression.per_decade * std::log10(high / low),
                                    "pressures of the list", "lower compression.per_decade", 1e5));
  std::vector<double> list;
  for (int k = 0; k <= steps; ++k) list.push_back(low * std::pow(high / low, static_cast<double>(k) / steps));
  return list;
}

/// What is kept of the packing at the pressure before.
template <int Dim>
struct Snapshot {
  std::vector<ContactNetwork::Pair> pairs;  ///< between particles that are no rattlers
  std::vector<std::uint8_t> rattlers;
  std::vector<Vec<Dim>> centre;
  Box<Dim> box;

  void keep(Keeper& k) {
    std::vector<std::int32_t> sites;
    for (const auto& p : pairs) sites.insert(sites.end(), {p.first, p.second});
    k("pairs", sites);
    pairs.assign(sites.size() / 2, {});
    for (std::size_t n = 0; n < pairs.size(); ++n) {
      pairs[n].first = sites[2 * n];
      pairs[n].second = sites[2 * n + 1];
    }
    k("rattlers", rattlers);
    k("centre", centre);
    k("box", box);
  }
};

struct NetworkChange {
  double lost = 0, made = 0, displacement = 0;
  double rearranged() const { return displacement > 0.1 && lost + made > 0; }
};

template <int Dim>
Snapshot<Dim> take_snapshot(const Packing<Dim>& packing, const PackingReport<Dim>& report) {
  Snapshot<Dim> s{{}, report.rattlers, report.shapes.centre, packing.system.box};
  for (const ContactNetwork::Pair& p : report.network.pairs)
    if (!report.rattlers[p.first] && !report.rattlers[p.second]) s.pairs.push_back(p);
  return s;
}

/// Contacts lost and made, and the largest motion of a centre, rattlers left out, relative to the affine
/// strain, in diameters of a disc of area 1 (3D: a sphere of volume 1).
template <int Dim>
NetworkChange compare(const Snapshot<Dim>& before, const Snapshot<Dim>& now) {
  NetworkChange change;
  if (before.centre.empty()) return change;
  const auto has = [](const Snapshot<Dim>& s, const ContactNetwork::Pair& p) {  // pairs are ascending
    const auto less = [](const auto& a, const auto& b) {
      return std::pair(a.first, a.second) < std::pair(b.first, b.second);
    };
    return std::binary_search(s.pairs.begin(), s.pairs.end(), p, less);
  };
  const auto counts = [&](std::size_t b) { return !before.rattlers[b] && !now.rattlers[b]; };
  for (const auto& p : before.pairs) change.lost += !has(now, p);
  for (const auto& p : now.pairs) change.made += !has(before, p);
  const double factor = now.box.length[0] / before.box.length[0];
  Vec<Dim> drift{};  // the packing as a whole may slide
  double bodies = 0;
  for (std::size_t b = 0; b < now.centre.size(); ++b) bodies += counts(b);
  for (std::size_t b = 0; b < now.centre.size(); ++b)
    if (counts(b)) drift += (1 / bodies) * (now.centre[b] - factor * before.centre[b]);
  const double diameter = Dim == 2 ? 2 / std::sqrt(std::numbers::pi) : std::cbrt(6 / std::numbers::pi);
  for (std::size_t b = 0; b < now.centre.size(); ++b)
    if (counts(b))
      change.displacement =
          std::max(change.displacement, norm(now.centre[b] - factor * before.centre[b] - drift) / diameter);
  return change;
}

/// Which way the list is walked; a column of the table.
enum class Branch { compression = 1, decompression = -1 };

/// A pressure of the list, reached.
template <int Dim>
struct Place : PackingInstant<Dim> {
  Branch branch;
  NetworkChange change;
};

template <int Dim>
Observables<Place<Dim>> place_observables(const Packing<Dim>& packing) {
  using P = Place<Dim>;
  Observables<P> all = packing_observables<Dim>(packing.pressure_symbol);
  all.add({{{"branch", "", "1: compression, -1: decompression"},
            [](const P& p) { return static_cast<double>(p.branch); }},
           {{"lost_contacts", "", "pairs of particles that touched at the pressure before and no longer do"},
            [](const P& p) { return p.change.lost; }},
           {{"new_contacts", "", "pairs of particles that touch and did not at the pressure before"},
            [](const P& p) { return p.change.made; }},
           {{"displacement", "small diameter",
             "largest motion of a particle relative to the strain since the pressure before"},
            [](const P& p) { return p.change.displacement; }},
           {{"rearranged", "", "1: a particle moved by more than 0.1 and a contact was lost or made"},
            [](const P& p) { return p.change.rearranged(); }}});
  return all;
}

/// Packing fractions and pressures of a branch, and whether the packing rearranged on the way to each.
struct Course {
  std::vector<double> packing_fraction, pressure;
  std::vector<std::uint8_t> rearranged;

  void keep(Keeper& k) {
    k("packing_fraction", packing_fraction);
    k("pressure", pressure);
    k("rearranged", rearranged);
  }
};

/// How far the walk along the list has got.
template <int Dim>
struct Walk {
  std::vector<double> ascent;  ///< pressures of the way up
  bool has_list = false;
  std::int64_t done = 0;  ///< pressures reached
  JamState<Dim> jam;      ///< of the search for the next
  JamProgress<Dim> last;
  Snapshot<Dim> before;
  Course up, down;

  void keep(Keeper& k) {
    k("ascent", ascent);
    k("has_list", has_list);
    k("done", done);
    k("jam", jam);
    k("last", last);
    k("before", before);
    k("up", up);
    k("down", down);
  }
};

/// P = slope (phi - onset) over the lower decades: shells stiffen above [MacKeith 2025, figure 9.13]. Of the
/// part of the branch at the lowest pressures that holds no rearrangement: before and after one it is another
/// packing.
template <int Dim>
void record_onset(const Course& course, const std::string& branch, const Packing<Dim>& packing,
                  double highest, Recorder& recorder) {
  const auto fit = fit_onset(course.packing_fraction, course.pressure, course.rearranged, highest);
  if (!fit) return;
  recorder.value("results",
                 {"onset_" + branch, "",
                  "packing fraction where the pressure vanishes, by the line through the lower decades "
                  "without rearrangement"},
                 fit->packing_fraction, fit->packing_fraction_error);
  recorder.value("results",
                 {"slope_" + branch, packing.pressure_symbol,
                  "slope of the pressure against the packing fraction there"},
                 fit->slope, fit->slope_error);
}

template <int Dim>
std::vector<Derived> derive_compression(const Case& c, const InitialState* initial) {
  std::vector<Derived> all = derived_equilibria(make_periodic_packing<Dim>(c, initial, set_apart));
  all.push_back({{"pressures", "", "pressures of the list"}, static_cast<double>(pressure_list(c).size())});
  return all;
}

/// The pressures of the way up. A packing that is compressed already goes on from its pressure, because
/// decompressing it first would change it. On the way back it goes through all pressures of the list.
template <int Dim>
std::vector<double> pressures_above(const Case& c, std::vector<double> list, const InitialState* initial,
                                    Packing<Dim>& packing) {
  if (!initial) return list;
  const MinimiseReport report = relax(packing);
  require_converged(packing, report, "the packing to start from");
  remember(packing, report, look_at(packing));
  const double present = observe(packing).pressure;
  std::erase_if(list, [&](double pressure) { return pressure * (1 + c.jamming.window) <= present; });
  if (list.empty() && !c.compression.decompress)
    throw input_error(
        fmt::format("the state to start from has the pressure {:.4g}", present),
        fmt::format("compression.highest_pressure = {} is below", c.compression.highest_pressure),
        "raise it, or set compression.decompress = true");
  return list;
}

template <int Dim>
void run_compression(const Case& c, const InitialState* initial, Recorder& recorder) {
  const std::vector<double> list = pressure_list(c);
  Packing<Dim> packing = make_periodic_packing<Dim>(c, initial, at_random(recorder));
  begin_packing(packing, derive_compression<Dim>(c, initial), recorder);
  const Observables<Place<Dim>> observables = place_observables(packing);
  observables.declare("packing", recorder);
  Walk<Dim> walk;
  const Keep keep = [&](Keeper& k) {
    k("packing", packing);
    k("walk", walk);
  };
  restore(recorder, keep);
  JamSpec spec = jam_spec(c);
  std::int64_t total = 0;
  const auto watch = [&](const JamProgress<Dim>& p) {
    recorder.progress(
        fmt::format("compress: P = {:.1e}, phi = {:.4f}", spec.pressure, reached_fraction(packing, p)),
        walk.done, total);
    return true;
  };
  const auto go_to = [&](double pressure, Branch branch) {
    spec.pressure = pressure;
    // Contacts that were soft for a while would rearrange a packing that has jammed.
    if (spec.search == JamSearch::pressure && (initial || walk.done > 0)) spec.search = JamSearch::root;
    JamProgress<Dim> reached = jam(
        packing, spec, walk.jam, [&] { recorder.hold(keep, "on the way to pressure", walk.done + 1); },
        watch);
    reached.evaluations += walk.last.evaluations;
    reached.minimisations += walk.last.minimisations;
    reached.unconverged += walk.last.unconverged;
    walk.last = reached;
    const PackingReport<Dim> report = report_packing(packing);
    Snapshot<Dim> now = take_snapshot(packing, report);
    const Place<Dim> place{{packing, report, walk.last}, branch, compare(walk.before, now)};
    observables.append("packing", place, recorder);
    Course& course = branch == Branch::compression ? walk.up : walk.down;
    course.packing_fraction.push_back(report.fraction.total);
    course.pressure.push_back(supple::pressure(place.stress()));
    course.rearranged.push_back(place.change.rearranged());
    recorder.frame(packing_frame(packing, report));
    walk.before = std::move(now);
    walk.jam = {};
    ++walk.done;
  };
  try {
    if (!walk.has_list) {
      recorder.hold(keep, "on the way to pressure", 1);
      walk.ascent = pressures_above(c, list, initial, packing);
      walk.has_list = true;
    }
    const auto up = static_cast<std::int64_t>(walk.ascent.size());
    const std::int64_t down =
        !c.compression.decompress ? 0 : static_cast<std::int64_t>(list.size()) - !walk.ascent.empty();
    total = up + down;
    while (walk.done < total) {
      if (walk.done < up) go_to(walk.ascent[static_cast<std::size_t>(walk.done)], Branch::compression);
      else go_to(list[static_cast<std::size_t>(total - 1 - walk.done)], Branch::decompression);
    }
    recorder.progress("compress", total, total);
  } catch (const Error&) {
    hand_over_packing(packing, recorder);
    throw;
  }
  const double linear = 0.1 * c.compression.highest_pressure * (1 + c.jamming.window);
  record_onset(walk.up, "compression", packing, linear, recorder);
  record_onset(walk.down, "decompression", packing, linear, recorder);
  record_packing(packing, walk.last, recorder);
}

void check_pressures(const Case& c, Problems& problems) {
  if (c.compression.highest_pressure <= c.jamming.pressure)
    add_problem(problems, c,
                fmt::format("compression.highest_pressure = {} is not above jamming.pressure = {}",
                            c.compression.highest_pressure, c.jamming.pressure),
                "compression goes from the one to the other", "raise the first or lower the second");
}

}  // namespace

Experiment compression() {
  return {.name = "compression",
          .meaning = "a jammed packing to a list of pressures, and back: P against phi (9.13)",
          .matter = &body_matter(),
          .keys = with(minimised_keys(), {"jamming.*", "compression.*"}),
          .derive = {derive_compression<2>, derive_compression<3>},
          .run = {run_compression<2>, run_compression<3>},
          .figure = always<Figure::branches>,
          .first_keys = {"experiment", "seed", "bodies.family", "bodies.N", "compression.highest_pressure"},
          .check = check_pressures};
}

}  // namespace supple
