#include "supple/io/export/csv.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "supple/core/error.hpp"
#include "supple/io/hdf5/elements.hpp"
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

/// Factors from the units of a run to others.
struct Factors {
  Units from, to;
  double operator()(const Unit& unit) const { return from.of(unit) / to.of(unit); }
};

void append_discs(CsvFile& csv, const Frame<2>& frame, const Factors& factor) {
  const double length = factor(unit::length), speed = factor(unit::speed), force = factor(unit::force);
  for (std::size_t i = 0; i < frame.position.size(); ++i) {
    csv.cell(frame.position[i][0] * length);
    csv.cell(frame.position[i][1] * length);
    csv.cell(frame.velocity[i][0] * speed);
    csv.cell(frame.velocity[i][1] * speed);
    csv.cell(frame.angle[i]);
    csv.cell(frame.spin[i] * factor(unit::spin));
    csv.cell(frame.force[i][0] * force);
    csv.cell(frame.force[i][1] * force);
    csv.cell(frame.torque[i] * factor(unit::torque));
    csv.cell(std::int64_t{frame.mobility[i] == Mobility::free});
  }
}

const char* state_name(ContactState state) {
  static constexpr const char* names[] = {"open", "stick", "slip", "permanent"};
  return names[static_cast<int>(state)];
}

/// "i>j:state:elongation" of every contact from both sides, by i, then j.
std::string neighbors_text(const Frame<2>& frame, double to_length) {
  struct Side {
    std::int32_t other;
    ContactState state;
    double elongation;
  };
  std::vector<std::vector<Side>> sides(frame.position.size());
  for (const ContactRow<2>& c : frame.contacts) {
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
  const RunInfo<2> info = run.info();
  const Factors to{info.units, particleshear_units()};
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
    const Frame<2> frame = run.frame(k);
    while (row < time.size() && time[row] != frame.time * info.units.time) ++row;
    if (row == time.size())
      throw file_error(run.path() + " has no row of stress for frame " + std::to_string(k),
                       "the file is damaged");
    csv.cell(frame.step);
    csv.cell(frame.time * to(unit::time));
    csv.cell(frame.strain);
    csv.cell(frame.strain_rate * to(unit::rate));
    append_discs(csv, frame, to);
    stresses.append_row(csv, row);
    csv.cell(neighbors_text(frame, to(unit::length)));
    csv.end_row();
  }
}

/// visit(quantity, value) for all of a contact but the second elongation of the published package.
template <int Dim, class Visit>
void for_each_in_csv(const ContactRow<Dim>& c, Visit&& visit) {
  for_each_quantity(c, [&](const auto& q, const auto& value) {
    if (&value != static_cast<const void*>(&c.elongation_back)) visit(q, value);
  });
}

template <int Dim>
void write_contacts(const RunFile& run, CsvFile& csv) {
  const Units units = run.info<Dim>().units, si = unit_text(units, unit::time).empty() ? units : si_units();
  const Factors to_si{units, si};
  const auto head = [&](std::string name, const Unit& unit) {
    csv.cell(with_unit(name, unit_text(si, unit)));
  };
  const auto in_csv = [](const std::string& name) { return name.substr(std::string("contact_").size()); };
  head("frame", unit::none);
  head("t", unit::time);
  for_each_in_csv(ContactRow<Dim>{}, [&]<class T>(const auto& q, const T&) {
    if (std::is_same_v<T, Vec<Dim>>) {
      for (int d = 0; d < Dim; ++d) head(std::string("force_on_first_") + "xyz"[d], q.unit);
    } else head(in_csv(q.name), q.unit);
  });
  csv.end_row();
  for (std::int64_t k = 0; k < run.frames(); ++k) {
    const Frame<Dim> frame = run.frame<Dim>(k);
    for (const ContactRow<Dim>& c : frame.contacts) {
      csv.cell(k);
      csv.cell(frame.time * to_si(unit::time));
      for_each_in_csv(c, [&]<class T>(const auto& q, const T& value) {
        if constexpr (std::is_same_v<T, ContactState>) csv.cell(std::string(state_name(value)));
        else if constexpr (std::is_same_v<T, std::int32_t>) csv.cell(std::int64_t{value});
        else if constexpr (std::is_same_v<T, double>) csv.cell(value * to_si(q.unit));
        else
          for (int d = 0; d < Dim; ++d) csv.cell(value[d] * to_si(q.unit));
      });
      csv.end_row();
    }
  }
}

}  // namespace

void export_csv(const RunFile& run, const std::string& path, Existing existing) {
  CsvFile csv(path, existing);
  for (const char* table : {"packing", "motion", "friction", "stress"})
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
  if (run.dimensions() == 2) write_contacts<2>(run, csv);
  else write_contacts<3>(run, csv);
  csv.commit();
}

}  // namespace supple
