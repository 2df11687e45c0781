#include "supple/io/export/csv.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "supple/core/error.hpp"
#include "supple/io/text/number_text.hpp"

namespace supple {
namespace {

/// The package's names of the tensors, in the order of its trajectories.
constexpr std::pair<const char*, const char*> trajectory_tensors[] = {
    {"stress_tensor_LW", "love_weber"},
    {"stress_tensor_with_external_forces", "external"},
    {"stress_tensor_unbalanced_forces", "linear_acceleration"},
    {"stress_tensor_linear_acceleration_otsuki", "otsuki"},
    {"stress_tensor_unbalanced_torque", "tangential_torque"},
    {"stress_tensor_internal_torque", "internal_torque"},
    {"stress_tensor_spin_kinetic_energy", "centrifugal"},
    {"overall_stress_tensor", "overall"},
};
constexpr const char* disc_columns[] = {"x",     "y",  "vx", "vy",     "phi",
                                        "omega", "fx", "fy", "torque", "movable"};

/// Text that goes to the file in large pieces.
class CsvFile {
 public:
  CsvFile(const std::string& path, Existing existing) : file_(path, existing) {}

  void cell(double x) {
    separate();
    append_shortest(text_, x);
  }
  void cell(std::int64_t x) {
    separate();
    append_integer(text_, x);
  }
  void cell(const std::string& text) {
    separate();
    text_ += text;
  }
  void end_row() {
    text_ += '\n';
    row_started_ = false;
    if (text_.size() < std::size_t{1} << 20) return;
    file_.write(text_);
    text_.clear();
  }
  void commit() {
    file_.write(text_);
    file_.commit();
  }

 private:
  void separate() {
    if (row_started_) text_ += ',';
    row_started_ = true;
  }
  NewFile file_;
  std::string text_;
  bool row_started_ = false;
};

/// Columns of a table in memory, read once.
struct Columns {
  std::vector<std::string> names;
  std::vector<std::vector<double>> values;

  void add(const RunFile& run, const std::string& name, const std::string& as,
           const std::string& table = "stress") {
    names.push_back(as);
    values.push_back(run.column(table, name));
  }
  void append_row(CsvFile& csv, std::size_t row) const {
    for (const auto& column : values) csv.cell(column[row]);
  }
};

std::string with_unit(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : name + " [" + unit + "]";
}

void export_table(const RunFile& run, const std::string& table, CsvFile& csv) {
  Columns columns;
  for (const Column& column : run.columns(table))
    columns.add(run, column.name, with_unit(column.name, column.unit), table);
  for (const std::string& name : columns.names) csv.cell(name);
  csv.end_row();
  for (std::size_t row = 0; !columns.values.empty() && row < columns.values[0].size(); ++row) {
    columns.append_row(csv, row);
    csv.end_row();
  }
}

/// What stands behind the discs in a row of a trajectory.
Columns trajectory_stresses(const RunFile& run) {
  Columns out;
  std::vector<std::string> present;
  for (const Column& column : run.columns("stress")) present.push_back(column.name);
  const bool tensors = std::find(present.begin(), present.end(), "overall_00") != present.end();
  if (tensors)
    for (const auto& [as, name] : trajectory_tensors)
      for (const char* component : {"_00", "_01", "_10", "_11"})
        out.add(run, std::string(name) + component, std::string(as) + component);
  out.add(run, "shear_stress_internal", "quasistatic_shear_stress");
  out.add(run, "shear_stress_external", "external_shear_stress");
  out.add(run, "pair_register", "n_pair_register");
  out.add(run, "external_register", "n_external_register");
  return out;
}

/// Factors from the run's units to those of the trajectories.
struct Factors {
  explicit Factors(const Units& from, const Units& to = particleshear_units())
      : time(from.time / to.time),
        length(from.length / to.length),
        speed(from.speed() / to.speed()),
        force(from.force() / to.force()),
        torque(from.torque() / to.torque()) {}
  double time, length, speed, force, torque;
};

void append_discs(CsvFile& csv, const Frame& frame, const Factors& to) {
  for (std::size_t i = 0; i < frame.position.size(); ++i) {
    csv.cell(frame.position[i][0] * to.length);
    csv.cell(frame.position[i][1] * to.length);
    csv.cell(frame.velocity[i][0] * to.speed);
    csv.cell(frame.velocity[i][1] * to.speed);
    csv.cell(frame.angle[i]);
    csv.cell(frame.spin[i] / to.time);
    csv.cell(frame.force[i][0] * to.force);
    csv.cell(frame.force[i][1] * to.force);
    csv.cell(frame.torque[i] * to.torque);
    csv.cell(std::int64_t{frame.mobility[i] == Mobility::free});
  }
}

const char* state_name(ContactState state) {
  static constexpr const char* names[] = {"open", "stick", "slip", "permanent"};
  return names[static_cast<int>(state)];
}

/// "i>j:state:elongation" of every contact from both sides, by i, then j.
std::string neighbors_text(const Frame& frame, double to_length) {
  struct Side {
    std::int32_t other;
    ContactState state;
    double elongation;
  };
  std::vector<std::vector<Side>> sides(frame.position.size());
  for (const ContactRow& c : frame.contacts) {
    sides[static_cast<std::size_t>(c.first)].push_back({c.second, c.state, c.elongation});
    sides[static_cast<std::size_t>(c.second)].push_back({c.first, c.state, c.elongation_back});
  }
  std::string text;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    std::sort(sides[i].begin(), sides[i].end(),
              [](const Side& a, const Side& b) { return a.other < b.other; });
    for (const Side& side : sides[i]) {
      if (!text.empty()) text += ';';
      append_integer(text, static_cast<std::int64_t>(i));
      text += '>';
      append_integer(text, side.other);
      text += ':';
      text += state_name(side.state);
      text += ':';
      append_shortest(text, side.elongation * to_length);
    }
  }
  return text;
}

void write_trajectory(const RunFile& run, CsvFile& csv) {
  const RunInfo info = run.info();
  const Factors to(info.units);
  const Columns stresses = trajectory_stresses(run);
  const std::vector<double> time = run.column("stress", "t");

  for (const char* name : {"step", "t", "shear", "shear_rate"}) csv.cell(std::string(name));
  for (std::size_t i = 0; i < info.radius.size(); ++i)
    for (const char* name : disc_columns) csv.cell(name + std::to_string(i));
  for (const std::string& name : stresses.names) csv.cell(name);
  csv.cell(std::string("neighbors"));
  csv.end_row();

  std::size_t row = 0;  // of the table, which has one for every step
  for (std::int64_t k = 0; k < run.frames(); ++k) {
    const Frame frame = run.frame(k);
    while (row < time.size() && time[row] != frame.time * info.units.time) ++row;
    if (row == time.size())
      throw file_error(run.path() + " has no row of stress for frame " + std::to_string(k),
                       "the file is damaged");
    csv.cell(frame.step);
    csv.cell(frame.time * to.time);
    csv.cell(frame.strain);
    csv.cell(frame.strain_rate / to.time);
    append_discs(csv, frame, to);
    stresses.append_row(csv, row);
    csv.cell(neighbors_text(frame, to.length));
    csv.end_row();
  }
}

/// Factors from the units of a run to SI; 1 where it has none.
struct Si {
  explicit Si(const Units& units)
      : has_units(units.name != reduced_units().name), to(units, has_units ? si_units() : units) {}
  std::string name(const char* name, const char* unit) const {
    return with_unit(name, has_units ? unit : "");
  }
  bool has_units;
  Factors to;
};

void write_contacts(const RunFile& run, CsvFile& csv) {
  const Si si(run.info().units);
  for (const std::string& name :
       {std::string("frame"), si.name("t", "s"), std::string("first"), std::string("second"),
        std::string("state"), si.name("elongation", "m"), si.name("normal_force", "N/m"),
        si.name("elastic_force", "N/m"), si.name("viscous_force", "N/m"), si.name("tangential_force", "N/m"),
        si.name("force_on_first_x", "N/m"), si.name("force_on_first_y", "N/m")})
    csv.cell(name);
  csv.end_row();
  for (std::int64_t k = 0; k < run.frames(); ++k) {
    const Frame frame = run.frame(k);
    for (const ContactRow& c : frame.contacts) {
      csv.cell(k);
      csv.cell(frame.time * si.to.time);
      csv.cell(std::int64_t{c.first});
      csv.cell(std::int64_t{c.second});
      csv.cell(std::string(state_name(c.state)));
      csv.cell(c.elongation * si.to.length);
      for (const double force :
           {c.normal_force, c.elastic, c.viscous, c.tangential_force, c.force[0], c.force[1]})
        csv.cell(force * si.to.force);
      csv.end_row();
    }
  }
}

}  // namespace

void export_csv(const RunFile& run, const std::string& path, Existing existing) {
  CsvFile csv(path, existing);
  for (const char* table : {"packing", "motion", "stress"})
    if (run.has_table(table) || table == std::string("stress")) {
      export_table(run, table, csv);
      break;
    }
  csv.commit();
}

void export_energy(const RunFile& run, const std::string& path, Existing existing) {
  if (!run.has_table("energy"))
    throw input_error(run.path() + " has no table of energy",
                      "runs of discs keep it, in the documented physics, where they are asked to",
                      "run it again with output.energies = true");
  CsvFile csv(path, existing);
  export_table(run, "energy", csv);
  csv.commit();
}

void export_trajectory(const RunFile& run, const std::string& path, Existing existing) {
  CsvFile csv(path, existing);
  write_trajectory(run, csv);
  csv.commit();
}

void export_contacts(const RunFile& run, const std::string& path, Existing existing) {
  CsvFile csv(path, existing);
  write_contacts(run, csv);
  csv.commit();
}

}  // namespace supple
