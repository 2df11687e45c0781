/// Several kinds of particles in a run file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "supple/experiment/bodies_of_case.hpp"
#include "supple/io/run/file_recorder.hpp"
#include "supple/io/run/run_file.hpp"
#include "tests/io/body_run.hpp"
#include "tests/io/temporary_folder.hpp"

namespace supple {
namespace {

class SpeciesRun : public testing::TemporaryFolder {};

TEST_F(SpeciesRun, KnowsItsKindsOfParticles) {
  Case c = testing::body_case("jamming");
  c.species.resize(2);
  c.species[0].count = 7;
  c.species[1].family = "droplet";
  c.species[1].diameter = 1 / 3.;
  c.species[1].k_perimeter = 0.25;
  FileRecorder recorder(in_folder("run.h5"), c, "");
  testing::record_bodies(recorder, 1);
  recorder.finish("complete");
  const Case again = RunFile(in_folder("run.h5")).resolved_case();
  ASSERT_EQ(again.species.size(), 2u);
  EXPECT_EQ(again.species[0].count, 7);
  EXPECT_EQ(again.species[1].diameter, 1 / 3.);
  EXPECT_EQ(again.species[1].k_perimeter, 0.25);
  EXPECT_EQ(families_of(again), "7 shell, 64 droplet");
}

}  // namespace
}  // namespace supple
