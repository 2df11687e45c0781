#include "supple/experiment/plate_exponents.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "supple/observe/power_law.hpp"

namespace supple {

namespace {

/// The rows of one branch, in the order of the run; the largest compression belongs to both.
struct BranchRows {
  std::vector<double> compression, force, nodes;  ///< nodes: of the plate that fewer touch
};
BranchRows rows_of_branch(Recorder& recorder, bool down) {
  const auto column = [&](const char* name) { return recorder.column(plate_table, name); };
  const std::vector<double> x = column("compression"), f = column("force"), upper = column("upper_nodes"),
                            lower = column("lower_nodes"), branch = column("branch");
  BranchRows rows;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const bool is_turn = branch[k] > 0 && (k + 1 == x.size() || branch[k + 1] < 0);
    if (branch[k] > 0 ? !down && !is_turn : down) continue;
    rows.compression.push_back(x[k]);
    rows.force.push_back(f[k]);
    rows.nodes.push_back(std::min(upper[k], lower[k]));
  }
  return rows;
}

/// From where five nodes touch each plate for good; the largest compression where they never do.
double five_nodes_from(const BranchRows& down) {
  double from = down.compression.back();
  for (std::size_t k = down.nodes.size(); k-- > 0 && down.nodes[k] >= 5;) from = down.compression[k];
  return from;
}

/// Range of compressions over which exponents are fitted.
struct Window {
  double from, to;
};
Window fit_window(const PlateCompression& plates, const BranchRows& down) {
  const double to = plates.fit_to > 0 ? plates.fit_to : plates.strain;
  return {plates.fit_from > 0 ? plates.fit_from : std::min(five_nodes_from(down), 0.1 * to), to};
}

/// Vertices at the plate that fewer touch, at the compression nearest above the beginning of the window.
double nodes_at(const BranchRows& down, double compression) {
  for (std::size_t k = 0; k < down.nodes.size(); ++k)
    if (down.compression[k] >= compression * (1 - 1e-9)) return down.nodes[k];
  return 0;
}

}  // namespace

void record_exponents(const PlateCompression& plates, Recorder& recorder) {
  const std::string local = "local_exponents";
  recorder.declare(local, {{"compression", "", "delta/D"},
                           {"exponent", "", "d ln F/d ln delta there, over plates.window decades"},
                           {"error", "", "its standard error"},
                           {"branch", "", "1: the plate comes down, -1: it goes up again"}});
  const BranchRows down = rows_of_branch(recorder, true);
  const Window window = fit_window(plates, down);
  const auto record = [&](const char* name, const char* meaning, double value, double error = -1) {
    recorder.value("results", {name, "", meaning}, value, error);
  };
  bool has_window = false;
  for (const bool is_down : {true, false}) {
    if (!is_down && !plates.decompress) continue;
    const BranchRows rows = is_down ? down : rows_of_branch(recorder, false);
    const auto laws = local_power_laws(rows.compression, rows.force, plates.window);
    for (std::size_t k = 0; k < laws.size(); ++k)
      if (laws[k])
        recorder.append(
            local, std::array{rows.compression[k], laws[k]->exponent, laws[k]->error, is_down ? 1.0 : -1.0});
    const auto law = fit_power_law(rows.compression, rows.force, window.from, window.to);
    if (!law) continue;
    record(is_down ? "exponent" : "exponent_up",
           is_down ? "of the force against the compression, over the fitted window, as the plate comes down"
                   : "the same as it goes up",
           law->exponent, law->error);
    if (!is_down) continue;
    has_window = true;
    record("factor", "force at compression 1 by that power law, in the unit of the column force",
           law->factor);
    record("fit_from", "least compression of the fit", law->from);
    record("fit_to", "largest compression of the fit", law->to);
    record("fit_points", "rows of the fit", law->points);
    record("fit_nodes", "vertices that touch the plate that fewer touch, where the fit begins",
           nodes_at(down, law->from));
  }
  if (!has_window)
    recorder.warning(
        fmt::format("no exponent: less than three compressions from {:.3g} to {:.3g} press on the particle",
                    window.from, window.to));
}

double touching_nodes(Recorder& recorder) { return rows_of_branch(recorder, true).nodes.back(); }

}  // namespace supple
