/// show, export, snapshot, plot: what is made of a run file.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "beside.hpp"
#include "commands.hpp"
#include "supple/core/error.hpp"
#include "supple/io/csv.hpp"
#include "supple/io/published_text.hpp"
#include "supple/io/run_file.hpp"
#include "supple/io/run_pictures.hpp"
#include "supple/io/state_file.hpp"

namespace supple::command {

namespace {

using Json = nlohmann::ordered_json;

std::string with_error(const RunValue& v) {
  const std::string unit = v.name.unit.empty() ? "" : " " + v.name.unit;
  if (v.error < 0) return fmt::format("{:.5g}{}", v.value, unit);
  return fmt::format("{:.5g} ± {:.2g}{}", v.value, v.error, unit);
}

int particle_count(const RunInfo& info) {
  const auto& p = info.particle;
  return p.empty() ? 0 : 1 + *std::max_element(p.begin(), p.end());
}

Json values_json(const std::vector<RunValue>& values) {
  Json j = Json::object();
  for (const RunValue& v : values) {
    Json& entry = j[v.name.name] = {{"value", v.value}, {"unit", v.name.unit}, {"meaning", v.name.meaning}};
    if (v.error >= 0) entry["error"] = v.error;
  }
  return j;
}

void show_json(const RunFile& run) {
  const RunInfo info = run.info();
  Json j{{"run", run.path()},
         {"status", run.status()},
         {"experiment", run.experiment()},
         {"physics", run.physics()},
         {"seed", run.seed()},
         {"version", run.version()},
         {"discs", info.radius.size()},
         {"particles", particle_count(info)},
         {"frames", run.frames()}};
  for (const std::string group : {"results", "constants"}) j[group] = values_json(run.values(group));
  j["warnings"] = run.warnings();
  fmt::print("{}\n", j.dump(2));
}

constexpr std::string_view storage = "storage_modulus_";

/// What the stress was taken from: "internal", "external", ...
std::vector<std::string> estimators(const std::vector<RunValue>& results) {
  std::vector<std::string> names;
  for (const RunValue& v : results)
    if (v.name.name.starts_with(storage)) names.push_back(v.name.name.substr(storage.size()));
  return names;
}

/// G' and G'' side by side, a line for each estimator.
void show_moduli(const std::vector<RunValue>& results) {
  const auto text = [&](const std::string& name) {
    const auto at =
        std::find_if(results.begin(), results.end(), [&](const RunValue& v) { return v.name.name == name; });
    return at == results.end() ? std::string("-") : with_error(*at);
  };
  const std::vector<std::string> names = estimators(results);
  if (names.empty()) return;
  fmt::print("\n  {:<20} {:<20} {:<20} {}\n", "stress", "G'", "G''", "third harmonic");
  for (const std::string& name : names)
    fmt::print("  {:<20} {:<20} {:<20} {}\n", name, text(std::string(storage) + name),
               text("loss_modulus_" + name), text("third_harmonic_" + name));
}

/// Numbers that do not belong to one estimator.
void show_values(const std::vector<RunValue>& values) {
  const std::vector<std::string> names = estimators(values);
  const auto belongs = [&](const std::string& value) {
    return std::any_of(names.begin(), names.end(),
                       [&](const auto& name) { return value.ends_with("_" + name); });
  };
  fmt::print("\n");
  for (const RunValue& v : values)
    if (!belongs(v.name.name)) fmt::print("  {:<31} {:<20} {}\n", v.name.name, with_error(v), v.name.meaning);
}

/// The frame of the largest strain, the first of several.
std::int64_t most_sheared_frame(const RunFile& run) {
  std::int64_t best = 0;
  double largest = 0;
  for (std::int64_t k = 0; k < run.frames(); ++k)
    if (const double strain = std::abs(run.frame(k).strain); strain > largest * (1 + 1e-9)) {
      largest = strain;
      best = k;
    }
  return best;
}

}  // namespace

std::string beside(const std::string& run, const std::string& ending) {
  return std::filesystem::path(run).replace_extension().string() + ending;
}
std::string plot_path(const std::string& run) { return beside(run, "_stress.png"); }
std::string snapshot_path(const std::string& run) { return beside(run, "_cell.png"); }
std::string export_path(const std::string& run, const std::string& to) {
  return beside(run, to == "csv" ? ".csv" : to == "text" ? ".txt" : "_state.json");
}

void show(const std::string& run_path, Format format) {
  const RunFile run(run_path);
  if (format == Format::json) return show_json(run);
  const RunInfo info = run.info();
  const Vec2 cell = info.units.length * 1e6 * info.box.length;
  fmt::print("{}: {} ({} model), {}\n", run_path, run.experiment(), run.physics(), run.status());
  fmt::print("{} discs in {} particles, cell {:.4g} um x {:.4g} um, seed {}, supple {}\n", info.radius.size(),
             particle_count(info), cell[0], cell[1], run.seed(), run.version());
  const std::vector<RunValue> results = run.values("results");
  show_moduli(results);
  show_values(results.empty() ? run.values("constants") : results);
  for (const std::string& warning : run.warnings()) fmt::print("\nwarning: {}\n", warning);
}

void export_run(const std::string& run_path, const std::string& to, const std::string& path,
                Existing existing) {
  const std::string file = path.empty() ? export_path(run_path, to) : path;
  check_can_create(file, existing);
  if (to == "csv") export_csv(RunFile(run_path), file, existing);
  else if (to == "text") export_published_text(RunFile(run_path), file, existing);
  else write_state_json(read_state(run_path), file, existing);
}

void snapshot(const std::string& run_path, std::optional<int> frame, const std::string& path,
              Existing existing) {
  const std::string file = path.empty() ? snapshot_path(run_path) : path;
  check_can_create(file, existing);
  const RunFile run(run_path);
  const std::int64_t count = run.frames();
  if (count == 0) throw input_error(run_path + " holds no frames", "it stopped before its first step");
  const std::int64_t k = !frame ? most_sheared_frame(run) : *frame < 0 ? count + *frame : *frame;
  if (k < 0 || k >= count)
    throw input_error(fmt::format("{} has no frame {}", run_path, *frame), "",
                      fmt::format("give 0 to {}, or -1 for the last", count - 1));
  draw_run_snapshot(file, run, k);
}

void plot(const std::string& run_path, const std::string& path, Existing existing) {
  const std::string file = path.empty() ? plot_path(run_path) : path;
  check_can_create(file, existing);
  draw_run_plot(file, RunFile(run_path));
}

}  // namespace supple::command
