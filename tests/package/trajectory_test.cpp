/// Trajectories of the published package, every column.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "supple/compat/particleshear/step.hpp"
#include "supple/model/units.hpp"
#include "supple/observe/stress.hpp"
#include "tests/package/reference.hpp"

namespace supple::testing {
namespace {

using Row = std::vector<double>;

void append(Row& row, const Mat2& m) {
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b) row.push_back(m[a][b]);
}

/// The numbers of the reference's columns, in its order.
Row columns(const System<2>& system, const Evaluation<2>& e) {
  const State<2>& s = system.state;
  Row row{static_cast<double>(system.step), system.time, system.box.strain, system.box.strain_rate};
  for (int i = 0; i < s.size(); ++i)
    row.insert(row.end(),
               {s.position[i][0], s.position[i][1], s.velocity[i][0], s.velocity[i][1], s.angle[i], s.spin[i],
                e.force[i][0], e.force[i][1], e.torque[i], s.mobility[i] == Mobility::free ? 1.0 : 0.0});
  const StressTensors t = stress_tensors(system, e, particleshear_units().stress());
  for (const Mat2& m : {t.love_weber, t.external, t.linear_acceleration, t.otsuki, t.tangential_torque,
                        t.internal_torque, t.centrifugal, t.overall})
    append(row, m);
  row.insert(row.end(), {t.shear_internal(), t.shear_external(), static_cast<double>(t.pair_register),
                         static_cast<double>(t.external_register)});
  return row;
}

/// State and elongation of every ordered pair in contact.
using Neighbors = std::map<std::pair<int, int>, std::pair<ContactState, double>>;

Neighbors neighbors(const System<2>& system, const Evaluation<2>& e) {
  Neighbors all;
  for (int row = 0; row < system.pairs.size(); ++row) {
    if (e.trial_state[row] == ContactState::open) continue;
    const int i = system.pairs.first[row], j = system.pairs.second[row];
    all[{i, j}] = {e.trial_state[row], e.trial_history[2 * row]};
    all[{j, i}] = {e.trial_state[row], e.trial_history[2 * row + 1]};
  }
  return all;
}

Neighbors parse_neighbors(const std::string& text) {
  Neighbors all;
  for (const std::string& entry : split(text, ';')) {
    const auto parts = split(entry, ':');
    const auto pair = split(parts[0], '>');
    all[{std::stoi(pair[0]), std::stoi(pair[1])}] = {reference_contact_state(parts[1]), std::stod(parts[2])};
  }
  return all;
}

void expect_close(const std::string& column, const std::vector<double>& mine,
                  const std::vector<double>& reference) {
  double largest = 0, difference = 0;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    largest = std::max(largest, std::abs(reference[i]));
    difference = std::max(difference, std::abs(mine[i] - reference[i]));
  }
  EXPECT_LE(difference, 1e-11 * largest) << column << ", column maximum " << largest;
}

class Trajectory : public ::testing::TestWithParam<const char*> {};

TEST_P(Trajectory, IsReproduced) {
  const std::string name = GetParam();
  const auto run = read_reference_json(name + ".json");
  const ReferenceTable table = read_reference_table(name + ".csv.gz");
  System<2> system = reference_system(run["params"], run["initial"]);
  ParticleShearStepper stepper(reference_constants(run["params"]),
                               run["reset_force_each_step"] ? PlateForce::reset : PlateForce::accumulate);
  stepper.set_plates(run["params"]["applyingShear"] ? Plates::capture : Plates::none);

  const std::size_t count = table.header.size() - 1;
  std::vector<std::vector<double>> mine(count + 1), reference(count + 1);  // the last: elongations
  std::size_t at = 0;
  for (int step = 0; step < run["steps"]; ++step) {
    const double rate = reference_rate(run["rate"], system.time);
    const Evaluation<2>& e = stepper.evaluate(system, {rate, rate});
    if (std::stoi(table.rows[at][0]) == step) {
      const Row row = columns(system, e);
      ASSERT_EQ(row.size(), count);
      for (std::size_t c = 0; c < count; ++c) {
        mine[c].push_back(row[c]);
        reference[c].push_back(std::stod(table.rows[at][c]));
      }
      const Neighbors here = neighbors(system, e), there = parse_neighbors(table.rows[at][count]);
      ASSERT_EQ(here.size(), there.size()) << "contacts at step " << step;
      for (const auto& [pair, contact] : there) {
        ASSERT_TRUE(here.count(pair)) << pair.first << '>' << pair.second << " at step " << step;
        ASSERT_EQ(here.at(pair).first, contact.first)
            << pair.first << '>' << pair.second << " at step " << step;
        mine[count].push_back(here.at(pair).second);
        reference[count].push_back(contact.second);
      }
      ++at;
    }
    stepper.advance(system, {rate, rate}, run["dt"], run["cool_factor"]);
  }
  EXPECT_EQ(at, table.rows.size());
  for (std::size_t c = 0; c <= count; ++c) expect_close(table.header[c], mine[c], reference[c]);

  const System<2> final = reference_system(run["params"], run["final"]);
  for (int i = 0; i < final.state.size(); ++i) {
    EXPECT_LE(norm(system.state.position[i] - final.state.position[i]), 1e-11 * system.box.length[0]);
    EXPECT_LE(std::abs(system.state.angle[i] - final.state.angle[i]), 1e-11 * std::abs(final.state.angle[i]));
  }
}

INSTANTIATE_TEST_SUITE_P(ParticleShear, Trajectory,
                         ::testing::Values("boundary_free_plus_wall", "ensemble12_free_mu0.01",
                                           "ensemble12_linked", "pair_LE_x", "pair_LE_y_shear",
                                           "pair_free_slip_mu0.01", "pair_free_stick_mu0.5",
                                           "pair_free_stickslip_k20_mu0.3_crc1", "pair_linked",
                                           "pair_linked_adjustable_keepF", "pair_linked_stretch_crc1"),
                         [](const auto& param) {
                           std::string name = param.param;
                           std::replace(name.begin(), name.end(), '.', '_');
                           return name;
                         });

}  // namespace
}  // namespace supple::testing
