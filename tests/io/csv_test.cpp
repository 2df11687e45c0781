#include <gmock/gmock.h>

#include <algorithm>
#include <map>

#include "supple/io/export/csv.hpp"
#include "supple/io/run/file_recorder.hpp"
#include "tests/io/sample_run.hpp"
#include "tests/io/temporary_folder.hpp"
#include "tests/package/reference.hpp"

namespace supple {
namespace {

using namespace supple::testing;
using ::testing::HasSubstr;

ReferenceTable parsed_csv(const std::string& path) {
  std::stringstream text(content_of(path));
  ReferenceTable table;
  std::string line;
  std::getline(text, line);
  table.header = split(line, ',');
  while (std::getline(text, line)) table.rows.push_back(split(line, ','));
  return table;
}

/// The names that the table "stress" gives to the columns of the package's trajectories.
std::string table_name(std::string name) {
  static const std::map<std::string, std::string> names{
      {"stress_tensor_LW", "love_weber"},
      {"stress_tensor_with_external_forces", "external"},
      {"stress_tensor_unbalanced_forces", "linear_acceleration"},
      {"stress_tensor_linear_acceleration_otsuki", "otsuki"},
      {"stress_tensor_unbalanced_torque", "tangential_torque"},
      {"stress_tensor_internal_torque", "internal_torque"},
      {"stress_tensor_spin_kinetic_energy", "centrifugal"},
      {"overall_stress_tensor", "overall"},
      {"quasistatic_shear_stress", "shear_stress_internal"},
      {"external_shear_stress", "shear_stress_external"},
      {"n_pair_register", "pair_register"},
      {"n_external_register", "external_register"},
      {"t", "t"}};
  const bool component = name.size() > 3 && name[name.size() - 3] == '_';
  const std::string end = component ? name.substr(name.size() - 3) : "";
  const auto at = names.find(name.substr(0, name.size() - end.size()));
  return at == names.end() ? "" : at->second + end;
}

/// A row of the package's trajectory as the frame of a run in the package's units.
Frame<2> frame_of(const std::map<std::string, std::string>& row, int discs) {
  const auto number = [&](const std::string& name) { return std::stod(row.at(name)); };
  Frame<2> f;
  f.step = std::stol(row.at("step"));
  f.time = number("t");
  f.strain = number("shear");
  f.strain_rate = number("shear_rate");
  for (int i = 0; i < discs; ++i) {
    const std::string n = std::to_string(i);
    f.position.push_back({number("x" + n), number("y" + n)});
    f.velocity.push_back({number("vx" + n), number("vy" + n)});
    f.force.push_back({number("fx" + n), number("fy" + n)});
    f.angle.push_back(number("phi" + n));
    f.spin.push_back(number("omega" + n));
    f.torque.push_back(number("torque" + n));
    f.mobility.push_back(row.at("movable" + n) == "1" ? Mobility::free : Mobility::lower_plate);
  }
  std::map<std::pair<int, int>, std::pair<std::string, double>> sides;
  for (const std::string& side : split(row.at("neighbors"), ';')) {
    const auto parts = split(side, ':');
    const auto ij = split(parts[0], '>');
    sides[{std::stoi(ij[0]), std::stoi(ij[1])}] = {parts[1], std::stod(parts[2])};
  }
  for (const auto& [ij, own] : sides)
    if (ij.first < ij.second)
      f.contacts.push_back({ij.first, ij.second, reference_contact_state(own.first), own.second,
                            sides.at({ij.second, ij.first}).second, 0, 0});
  std::reverse(f.contacts.begin(), f.contacts.end());  // their order is the file's, not the frame's
  return f;
}

/// The neighbours with elongations as numbers, in ascending order.
std::vector<std::tuple<int, int, std::string, double>> neighbors_of(const std::string& cell) {
  std::vector<std::tuple<int, int, std::string, double>> out;
  for (const std::string& side : split(cell, ';')) {
    const auto parts = split(side, ':');
    const auto ij = split(parts.at(0), '>');
    out.emplace_back(std::stoi(ij.at(0)), std::stoi(ij.at(1)), parts.at(1), std::stod(parts.at(2)));
  }
  return out;
}

class CsvTest : public TemporaryFolder {};

TEST_F(CsvTest, ATrajectoryOfThePackageComesBackAsItWas) {
  constexpr int discs = 12, rows = 25;
  const ReferenceTable reference = read_reference_table("ensemble12_linked.csv.gz");
  Case c;
  c.general.experiment = "dynamics";
  FileRecorder to(in_folder("run.h5"), c, "");
  RunInfo<2> info = sample_info(discs);
  info.body_begin.clear();
  info.units = particleshear_units();
  to.begin(info);
  std::vector<Column> columns;
  for (const std::string& name : reference.header)
    if (const std::string as = table_name(name); !as.empty()) columns.push_back({as, "", ""});
  to.declare("stress", columns);
  for (int r = 0; r < rows; ++r) {
    std::map<std::string, std::string> row;
    std::vector<double> values;
    for (std::size_t k = 0; k < reference.header.size(); ++k) {
      row[reference.header[k]] = reference.rows[r][k];
      if (!table_name(reference.header[k]).empty()) values.push_back(std::stod(reference.rows[r][k]));
    }
    to.append("stress", values);
    if (r % 3 == 0) to.frame(frame_of(row, discs));
  }
  to.finish("complete");
  export_trajectory(RunFile(in_folder("run.h5")), in_folder("run.csv"));

  const ReferenceTable written = parsed_csv(in_folder("run.csv"));
  EXPECT_EQ(written.header, reference.header);
  ASSERT_EQ(written.rows.size(), (rows + 2) / 3u);
  for (std::size_t r = 0; r < written.rows.size(); ++r) {
    ASSERT_EQ(written.rows[r].size(), reference.header.size());
    for (std::size_t k = 0; k + 1 < reference.header.size(); ++k)
      EXPECT_EQ(std::stod(written.rows[r][k]), std::stod(reference.rows[3 * r][k]))
          << r << " " << reference.header[k];
    auto expected = neighbors_of(reference.rows[3 * r].back());
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(neighbors_of(written.rows[r].back()), expected);
  }
}

TEST_F(CsvTest, ATrajectoryOfARunInSIIsInMicrometres) {
  Case c;
  c.general.experiment = "dynamics";
  FileRecorder to(in_folder("run.h5"), c, "");
  RunInfo<2> info = sample_info(1);
  info.body_begin.clear();
  info.units = si_units();
  to.begin(info);
  to.declare("stress", {{"t", "s", ""},
                        {"shear_stress_internal", "Pa", ""},
                        {"shear_stress_external", "Pa", ""},
                        {"pair_register", "", ""},
                        {"external_register", "", ""}});
  to.append("stress", std::vector<double>{0.5, 3, 4, 8, 4});
  Frame<2> f = sample_frame(1, 0);
  f.time = 0.5;
  f.position = {{2e-6, 3e-6}};
  f.velocity = {{4e-6, 5e-6}};
  f.force = {{1e-12, 2e-12}};
  f.torque = {1e-18};
  f.body.clear();
  to.frame(f);
  to.finish("complete");
  export_trajectory(RunFile(in_folder("run.h5")), in_folder("run.csv"));
  const ReferenceTable written = parsed_csv(in_folder("run.csv"));
  EXPECT_EQ(written.header.size(), 4u + 10 + 4 + 1) << "tensors that the run did not keep are left out";
  std::map<std::string, std::string> row;
  for (std::size_t k = 0; k < written.header.size(); ++k) row[written.header[k]] = written.rows.at(0)[k];
  EXPECT_NEAR(std::stod(row["x0"]), 2, 1e-14);
  EXPECT_NEAR(std::stod(row["vy0"]), 5, 1e-14);
  EXPECT_NEAR(std::stod(row["fx0"]), 1, 1e-14);
  EXPECT_NEAR(std::stod(row["torque0"]), 1, 1e-14);
  EXPECT_EQ(row["quasistatic_shear_stress"], "3");
  EXPECT_EQ(row["n_external_register"], "4");
  EXPECT_EQ(row["t"], "0.5");
}

TEST_F(CsvTest, EveryExperimentGivesItsTableWithUnits) {
  Case c;
  for (const char* experiment : {"oscillatory_shear", "dynamics"}) {
    c.general.experiment = experiment;
    FileRecorder to(in_folder("run.h5"), c, "", Existing::replace);
    record_sample(to, 3, 2);
    to.finish("complete");
    export_csv(RunFile(in_folder("run.h5")), in_folder("run.csv"), Existing::replace);
    EXPECT_EQ(content_of(in_folder("run.csv")),
              "t [s],zeta [Pa],alpha [Pa]\n0,0,0\n0.1,0.3333333333333333,0.14285714285714285\n");
  }
  EXPECT_THAT(file_error_of([&] { export_csv(RunFile(in_folder("run.h5")), in_folder("run.csv")); }),
              HasSubstr("exists"));
}

TEST_F(CsvTest, ContactsAreInSIWithTheirParts) {
  FileRecorder to(in_folder("run.h5"), Case{}, "");
  to.begin(sample_info(3));
  to.declare("stress", {{"t", "s", ""}});
  Frame<2> f = sample_frame(3, 0);
  f.time = 0.5;
  f.contacts = {{0, 2, ContactState::slip, 2, 0, 5, 0.25, 4, 1, {3, -2}}};
  to.frame(f);
  to.finish("complete");
  export_contacts(RunFile(in_folder("run.h5")), in_folder("run.csv"));
  const ReferenceTable written = parsed_csv(in_folder("run.csv"));
  EXPECT_THAT(
      written.header,
      ::testing::ElementsAre("frame", "t [s]", "first", "second", "state", "elongation [m]",
                             "normal_force [N/m]", "elastic_force [N/m]", "viscous_force [N/m]",
                             "tangential_force [N/m]", "force_on_first_x [N/m]", "force_on_first_y [N/m]"));
  const std::vector<double> expected{0, 0.5, 0, 2, 0, 2e-6, 5e-12, 4e-12, 1e-12, 0.25e-12, 3e-12, -2e-12};
  ASSERT_EQ(written.rows.size(), 1u);
  for (std::size_t k = 0; k < expected.size(); ++k)
    if (k != 4) {
      EXPECT_NEAR(std::stod(written.rows[0][k]), expected[k], 1e-12 * std::abs(expected[k])) << k;
    }
  EXPECT_EQ(written.rows[0][4], "slip");
}

}  // namespace
}  // namespace supple
