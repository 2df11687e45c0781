/// show: the summary of a run.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "beside.hpp"
#include "commands.hpp"
#include "supple/core/text_columns.hpp"
#include "supple/draw/chart/uncertainty.hpp"
#include "supple/experiment/bodies_of_case.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/io/run/run_file.hpp"

namespace supple::command {

namespace {

using Json = nlohmann::ordered_json;

std::string with_error(const RunValue& v) {
  const std::string unit = v.name.unit.empty() ? "" : " " + v.name.unit;
  return value_with_error(v.value, v.error) + unit;
}

int particle_count(const RunInfo<2>& info) {
  const auto& p = info.particle;
  return p.empty() ? 0 : 1 + *std::max_element(p.begin(), p.end());
}

/// Bodies of a run of deformable particles; shapes: polygons or surfaces, and the vertices of all of them.
struct BodyCounts {
  int bodies = 0, shapes = 0, vertices = 0;
};

template <int Dim>
BodyCounts count_bodies(const RunInfo<Dim>& info) {
  BodyCounts count;
  for (std::size_t b = 0; b + 1 < info.body_begin.size(); ++b) {
    const int sites =
        info.boundary_sites.empty() ? info.body_begin[b + 1] - info.body_begin[b] : info.boundary_sites[b];
    ++count.bodies;
    if (sites > 1) ++count.shapes, count.vertices += sites;
  }
  return count;
}

Json values_json(const std::vector<RunValue>& values) {
  Json j = Json::object();
  for (const RunValue& v : values) {
    Json& entry = j[v.name.name] = {{"value", v.value}, {"unit", v.name.unit}, {"meaning", v.name.meaning}};
    if (v.error >= 0) entry["error"] = v.error;
  }
  return j;
}

/// The family of the particles; empty where they come from a file, which knows only stiffnesses.
std::string family_of(const RunFile& run) {
  const Case c = run.resolved_case();
  return c.initial.state.empty() && c.initial.packing.empty() ? families_of(c) : "";
}

/// What the run holds, in numbers for programs and in words.
struct Contents {
  Json sizes;
  std::string text;
};

Contents discs_of(const RunInfo<2>& info) {
  const Vec2 cell = info.units.length * 1e6 * info.box.length;
  return {{{"discs", info.radius.size()}, {"particles", particle_count(info)}},
          fmt::format("{} discs in {} particles, cell {:.4g} um x {:.4g} um", info.radius.size(),
                      particle_count(info), cell[0], cell[1])};
}

/// The cell at the last frame, as packings change theirs.
template <int Dim>
Contents bodies_of(const RunFile& run, const RunInfo<Dim>& info) {
  const BodyCounts count = count_bodies(info);
  const std::string family = family_of(run), shapes = Dim == 2 ? "polygons" : "surfaces";
  Contents contents;
  if (!family.empty()) contents.sizes["family"] = family;
  contents.sizes["particles"] = count.bodies;
  contents.sizes[shapes] = count.shapes;
  contents.sizes["vertices"] = count.vertices;
  contents.text = fmt::format("{} particles", count.bodies);
  if (!family.empty()) contents.text += " (" + family + ")";
  if (count.shapes > 0)
    contents.text += fmt::format(", {} of them {}, with {} vertices", count.shapes, shapes, count.vertices);
  const Vec<Dim> cell = run.frames() > 0 ? run.frame<Dim>(run.frames() - 1).length : info.box.length;
  contents.text += ", cell";
  for (int d = 0; d < Dim; ++d) contents.text += fmt::format("{} {:.4g}", d > 0 ? " x" : "", cell[d]);
  return contents;
}

Contents contents_of(const RunFile& run) {
  if (run.dimensions() == 3) return bodies_of(run, run.info<3>());
  const RunInfo<2> info = run.info();
  return info.body_begin.empty() ? discs_of(info) : bodies_of(run, info);
}

std::string json_summary(const RunFile& run) {
  Json j{{"run", run.path()},        {"status", run.status()}, {"experiment", run.experiment()},
         {"physics", run.physics()}, {"seed", run.seed()},     {"version", run.version()}};
  j.update(contents_of(run).sizes);
  j["frames"] = run.frames();
  for (const std::string group : {"results", "constants"}) j[group] = values_json(run.values(group));
  j["warnings"] = run.warnings();
  return j.dump(2) + "\n";
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
void add_moduli(std::string& text, const std::vector<RunValue>& results) {
  const auto of = [&](const std::string& name) {
    const auto at =
        std::find_if(results.begin(), results.end(), [&](const RunValue& v) { return v.name.name == name; });
    return at == results.end() ? std::string("-") : with_error(*at);
  };
  const std::vector<std::string> names = estimators(results);
  if (names.empty()) return;
  std::vector<std::vector<std::string>> rows{{"stress", "G'", "G''", "third harmonic"}};
  for (const std::string& name : names)
    rows.push_back(
        {name, of(std::string(storage) + name), of("loss_modulus_" + name), of("third_harmonic_" + name)});
  text += "\n";
  for (const auto& row : rows) text += table_row(row, widths_of(rows), "");
}

/// Numbers that do not belong to one estimator.
void add_values(std::string& text, const std::vector<RunValue>& values) {
  const std::vector<std::string> names = estimators(values);
  const auto belongs = [&](const std::string& value) {
    return std::any_of(names.begin(), names.end(),
                       [&](const auto& name) { return value.ends_with("_" + name); });
  };
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> meanings;
  for (const RunValue& v : values) {
    if (belongs(v.name.name)) continue;
    rows.push_back({v.name.name, with_error(v)});
    meanings.push_back(v.name.meaning);
  }
  text += "\n";
  for (std::size_t i = 0; i < rows.size(); ++i) text += table_row(rows[i], widths_of(rows), meanings[i]);
}

}  // namespace

std::string summarize(const RunFile& run, Format format, Warnings warnings) {
  if (format == Format::json) return json_summary(run);
  // of suspensions there are several models
  const bool tells_model = experiment_of(run.resolved_case()).matter->suspension != nullptr;
  std::string text = fmt::format("{}: {}{}, {}\n", run.path(), run.experiment(),
                                 tells_model ? fmt::format(" ({} model)", run.physics()) : "", run.status());
  text += hang_words(
      "", fmt::format("{}, seed {}, supple {}", contents_of(run).text, run.seed(), run.version()), 0);
  const std::vector<RunValue> results = run.values("results");
  add_moduli(text, results);
  add_values(text, results.empty() ? run.values("constants") : results);
  if (warnings == Warnings::shown)
    for (const std::string& warning : run.warnings()) text += "\n" + hang_words("", "warning: " + warning, 0);
  return text;
}

void show(const std::string& run_path, Format format, const std::string& path, Existing existing) {
  check_output_of(run_path, path, existing);
  const std::string text = summarize(RunFile(run_path), format, Warnings::shown);
  NewFile file(path, existing);
  file.write(text);
  file.commit();
}

}  // namespace supple::command
