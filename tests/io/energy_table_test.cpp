/// The table "energy" of a run: it closes, adds up, goes on across a restart, and is exported with units.
#include "supple/experiment/energy_table.hpp"

#include <algorithm>
#include <cmath>

#include "supple/io/export/csv.hpp"
#include "supple/io/run/run_file.hpp"
#include "tests/io/continued_run.hpp"

namespace supple {
namespace {

using namespace supple::testing;
using ::testing::HasSubstr;

/// Discs with friction; links and plates as asked. One cycle of 20 % strain.
Case sheared(const std::string& plates, bool links) {
  return case_of("[particles]\nN = 45\npermanent_links = " + std::string(links ? "true" : "false") +
                 "\n[box]\nplates = \"" + plates +
                 "\"\n[material]\nfriction = 0.3\n[shear]\npre_periods = 0\n" +
                 "periods = 1\npost_periods = 0\n[output]\nenergies = true\n");
}

/// Sheared at a rate that changes, between plates.
Case dynamics(int steps, bool goes_on = true) {
  return case_of(
      "experiment = \"dynamics\"\n[particles]\nN = 24\ncut_lines = 0\n[material]\nfriction = 0.3\n"
      "[shear]\nrate = \"20000*cos(30000*t)\"\n[time]\nsteps = " +
      std::to_string(steps) + (goes_on ? "\n[initial]\nkeep_time = true" : "") +
      "\n[output]\nenergies = true\nframes = 3\n");
}
/// The same from a file, which says how the discs were made.
Case more_dynamics(int steps, bool keeps_time) {
  return case_of("experiment = \"dynamics\"\n[shear]\nrate = \"20000*cos(30000*t)\"\n[time]\nsteps = " +
                 std::to_string(steps) + "\n[initial]\nkeep_time = " + (keeps_time ? "true" : "false") +
                 "\n[output]\nenergies = true\nframes = 3\n");
}

MemoryRecorder recorded(const Case& c) {
  MemoryRecorder r;
  run(c, nullptr, r);
  return r;
}

const std::vector<std::string> terms{"kinetic", "spin", "elastic", "tangential", "wall"};
const std::vector<std::string> works{"work_plates", "work_images", "work_shear_rate"};
const std::vector<std::string> losses{"lost_viscous", "lost_tangential", "lost_sliding", "lost_background"};

double sum(const MemoryRecorder::Table& table, const std::vector<std::string>& names, std::size_t row) {
  double all = 0;
  for (const std::string& name : names) all += table.column(name)[row];
  return all;
}

class EnergyOfARun : public ContinuedRun {
 protected:
  std::vector<double> column(const std::string& run_name, const std::string& name) const {
    return RunFile(in_folder(run_name)).column("energy", name);
  }
  std::vector<std::string> names(const std::string& run_name) const {
    std::vector<std::string> all;
    for (const Column& c : RunFile(in_folder(run_name)).columns("energy")) all.push_back(c.name);
    return all;
  }
  /// The second half of a run that was split at this step has the rows of the whole, bit for bit.
  void expect_same_rows(const std::string& whole, const std::string& second, std::ptrdiff_t step) const {
    for (const std::string& name : names(whole)) {
      const std::vector<double> all = column(whole, name);
      EXPECT_EQ(std::vector<double>(all.begin() + step, all.end()), column(second, name)) << name;
    }
  }
};

/// As tests/physics/energy_balance_test.cpp: 1e-3 of the work.
TEST_F(EnergyOfARun, ClosesOverACycleWithEveryKindOfPlates) {
  for (const auto& [plates, links] : {std::pair{"capture", true}, {"none", true}, {"repulsive", false}}) {
    const MemoryRecorder r = recorded(sheared(plates, links));
    const MemoryRecorder::Table& t = r.tables.at("energy");
    const std::size_t last = t.rows.size() - 1;
    const double work = sum(t, works, last);
    EXPECT_GT(work, 0) << plates;
    EXPECT_NEAR(work, sum(t, terms, last) - sum(t, terms, 0) + sum(t, losses, last), 1e-3 * work) << plates;
    EXPECT_EQ(sum(t, works, 0), 0);
    EXPECT_EQ(sum(t, losses, 0), 0);
    if (plates == std::string("repulsive")) {
      const std::vector<double> wall = t.column("wall");
      EXPECT_GT(*std::max_element(wall.begin(), wall.end()), 0);
    }
  }
}

TEST_F(EnergyOfARun, TotalIsTheSumOfTermsAndOfChannelsAndResidual) {
  const MemoryRecorder r = recorded(sheared("capture", false));
  const MemoryRecorder::Table& t = r.tables.at("energy");
  const std::vector<double> total = t.column("total"), residual = t.column("residual");
  double largest = 0;
  for (const double x : total) largest = std::max(largest, std::abs(x));
  for (std::size_t k = 0; k < t.rows.size(); ++k) {
    const double scale = largest + std::abs(sum(t, works, k)) + std::abs(sum(t, losses, k));
    EXPECT_NEAR(total[k], sum(t, terms, k), 1e-13 * scale) << k;
    EXPECT_NEAR(total[k] - total[0], sum(t, works, k) - sum(t, losses, k) + residual[k], 1e-13 * scale) << k;
  }
  for (const std::string name :
       {"kinetic", "spin", "elastic", "tangential", "work_plates", "work_images", "work_shear_rate",
        "lost_viscous", "lost_tangential", "lost_sliding", "lost_background"})
    EXPECT_NE(t.column(name).back(), 0) << name;
}

/// In J/m: of the velocities and energies that the last frame holds.
TEST_F(EnergyOfARun, AgreesWithTheEnergiesOfFramesInJoulePerMetre) {
  Case c = dynamics(40, false);
  c.shear.rate =
      "20000";  // frames take up a change of the rate at their instant, the account in the step after it
  const MemoryRecorder r = recorded(c);
  const MemoryRecorder::Table& t = r.tables.at("energy");
  const double unit = r.info.units.torque();
  const auto& numbers = r.frames.back().numbers;
  EXPECT_EQ(t.columns[1].unit, "J/m");
  EXPECT_DOUBLE_EQ(t.column("elastic").back(), unit * numbers.at("contact_energy"));
  EXPECT_DOUBLE_EQ(t.column("tangential").back(), unit * numbers.at("tangential_energy"));
  EXPECT_NEAR(t.column("kinetic").back() + t.column("spin").back(), unit * numbers.at("kinetic_energy"),
              1e-12 * unit * numbers.at("kinetic_energy"));
}

TEST_F(EnergyOfARun, HasTheRowsOfTheTableOfStress) {
  for (const Case& c : {sheared("capture", true), dynamics(40, false)}) {
    const MemoryRecorder r = recorded(c);
    EXPECT_EQ(r.tables.at("energy").column("t"), r.tables.at("stress").column("t"));
  }
}

TEST_F(EnergyOfARun, AContinuationHasTheSameRows) {
  record("start.h5", dynamics(7, false));
  record("whole.h5", more_dynamics(60, true), "start.h5");
  record("first.h5", more_dynamics(25, true), "start.h5");
  record("second.h5", more_dynamics(35, true), "first.h5");
  ASSERT_EQ(column("whole.h5", "t").size(), 61u);
  EXPECT_NE(column("first.h5", "lost_viscous").back(), 0);
  expect_same_rows("whole.h5", "second.h5", 25);
  record("from_json.h5", more_dynamics(35, true), exported("first.h5"));
  EXPECT_NEAR(column("from_json.h5", "lost_viscous").front(), column("second.h5", "lost_viscous").front(),
              1e-12 * column("second.h5", "lost_viscous").front());
}

TEST_F(EnergyOfARun, ANewClockOpensANewAccount) {
  record("first.h5", dynamics(25, false));
  record("second.h5", more_dynamics(5, false), "first.h5");
  for (const std::string& name : works) EXPECT_EQ(column("second.h5", name).front(), 0) << name;
  for (const std::string& name : losses) EXPECT_EQ(column("second.h5", name).front(), 0) << name;
}

TEST_F(EnergyOfARun, DoesNotChangeTheRun) {
  record("with.h5", dynamics(40, false));
  Case c = dynamics(40, false);
  c.output.energies = false;
  record("without.h5", c);
  EXPECT_FALSE(RunFile(in_folder("without.h5")).has_table("energy"));
  EXPECT_EQ(system_of<2>(load("with.h5")).state.position, system_of<2>(load("without.h5")).state.position);
  EXPECT_EQ(system_of<2>(load("with.h5")).state.velocity, system_of<2>(load("without.h5")).state.velocity);
}

TEST_F(EnergyOfARun, IsExportedWithUnits) {
  record("run.h5", dynamics(3, false));
  export_energy(RunFile(in_folder("run.h5")), in_folder("run.csv"));
  const std::string text = content_of(in_folder("run.csv"));
  EXPECT_EQ(
      text.substr(0, text.find('\n')),
      "t [s],kinetic [J/m],spin [J/m],elastic [J/m],tangential [J/m],wall [J/m],total [J/m],work_plates "
      "[J/m],"
      "work_images [J/m],work_shear_rate [J/m],lost_viscous [J/m],lost_tangential [J/m],lost_sliding [J/m],"
      "lost_background [J/m],residual [J/m]");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 5);
  Case c = dynamics(3, false);
  c.output.energies = false;
  record("without.h5", c);
  try {
    export_energy(RunFile(in_folder("without.h5")), in_folder("none.csv"));
    FAIL() << "there is no such table";
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), HasSubstr("output.energies = true"));
  }
}

TEST_F(EnergyOfARun, IsRefusedByThePackage) {
  Case c = case_of("physics = \"particleshear-1.0.2\"\n[output]\nenergies = true\n");
  try {
    check(c);
    FAIL() << "contacts of the package have no energy";
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), HasSubstr("output.energies has no effect"));
    EXPECT_THAT(e.what(), HasSubstr("physics = \"documented\""));
  }
}

}  // namespace
}  // namespace supple
