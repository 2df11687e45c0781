/// A run split in two through its saved state has the same bits as the whole.
#include <gtest/gtest.h>

#include <cstring>

#include "supple/experiment/adopt_state.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/io/run/file_recorder.hpp"
#include "supple/io/state/state_file.hpp"
#include "tests/io/temporary_folder.hpp"
#include "tests/package/reference.hpp"

namespace supple {
namespace {

using namespace supple::testing;

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

class Continuation : public TemporaryFolder,
                     public ::testing::WithParamInterface<std::tuple<const char*, const char*>> {
 protected:
  /// Takes `steps` steps from the state in a file, and returns what the run's file then holds as final state.
  InitialState advanced(const std::string& state, const std::string& run, std::int64_t steps) const {
    Case c;
    c.general.experiment = "dynamics";
    c.general.physics = std::get<0>(GetParam());
    c.time.steps = steps;
    c.shear.rate = "10000*cos(50000*t)";
    c.initial.keep_time = true;
    const InitialState initial = read_state(state);
    FileRecorder recorder(in_folder(run), adopt_state(c, &initial), "");
    supple::run(c, &initial, recorder);
    recorder.finish("complete");
    return read_state(in_folder(run));
  }
};

TEST_P(Continuation, HasTheBitsOfTheWholeRun) {
  const std::string start = reference_path(std::get<1>(GetParam()));
  const InitialState whole = advanced(start, "whole.h5", 30);
  advanced(start, "first.h5", 13);
  const InitialState split = advanced(in_folder("first.h5"), "second.h5", 17);

  const System<2>&a = system_of<2>(whole), &b = system_of<2>(split);
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.step, b.step);
  EXPECT_EQ(a.box.strain, b.box.strain);
  EXPECT_EQ(a.box.strain_rate, b.box.strain_rate);
  EXPECT_TRUE(same_bits(a.state.position, b.state.position));
  EXPECT_TRUE(same_bits(a.state.velocity, b.state.velocity));
  EXPECT_TRUE(same_bits(a.state.angle, b.state.angle));
  EXPECT_TRUE(same_bits(a.state.spin, b.state.spin));
  EXPECT_EQ(a.state.mobility, b.state.mobility);
  ASSERT_TRUE(whole.evaluation && split.evaluation);
  EXPECT_TRUE(same_bits(evaluation_of<2>(whole)->force, evaluation_of<2>(split)->force));
  EXPECT_TRUE(same_bits(evaluation_of<2>(whole)->torque, evaluation_of<2>(split)->torque));
  for (int row = 0; row < a.pairs.size(); ++row) {
    if (a.pairs.state[row] == ContactState::open) continue;
    const int other = b.pairs.find(a.pairs.first[row], a.pairs.second[row]);
    ASSERT_GE(other, 0);
    EXPECT_EQ(a.pairs.state[row], b.pairs.state[other]);
    for (int k = 0; k < a.pairs.width; ++k)
      EXPECT_EQ(a.pairs.history[row * a.pairs.width + k], b.pairs.history[other * b.pairs.width + k]);
  }
  EXPECT_NE(system_of<2>(whole).state.position, system_of<2>(read_state(start)).state.position)
      << "something moves";
}

INSTANTIATE_TEST_SUITE_P(All, Continuation,
                         ::testing::Combine(::testing::Values("documented", "particleshear-1.0.2"),
                                            ::testing::Values("ensemble12_linked.json",
                                                              "pair_free_stick_mu0.5.json")));

}  // namespace
}  // namespace supple
