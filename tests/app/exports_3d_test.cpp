/// Exports of runs in three dimensions by the command.
#include <gmock/gmock.h>

#include "tests/app/command.hpp"
#include "tests/io/surfaces_run.hpp"

namespace supple {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class Exports3d : public CommandTest {
 protected:
  void SetUp() override {
    CommandTest::SetUp();
    testing::record_surfaces(path("run.h5").string());
  }
};

TEST_F(Exports3d, AreMadeOfEveryFrame) {
  for (const std::string to : {"xyz", "vtp", "contacts"}) {
    const Outcome done = supple("export run.h5 --to " + to);
    EXPECT_EQ(done.code, 0) << to << ": " << done.err;
  }
  EXPECT_THAT(read_text(path("run.xyz")), ::testing::StartsWith("55\nLattice=\"4.2 0 0 -1.41"));
  EXPECT_TRUE(exists("run_frames/frame0000001.vtp"));
  EXPECT_THAT(read_text(path("run_contacts.csv")), HasSubstr("force_on_first_z"));
}

TEST_F(Exports3d, WhatIsOfDiscsOrThePlaneIsRefused) {
  for (const std::string to : {"text", "state", "trajectory"}) {
    const Outcome refused = supple("export run.h5 --to " + to);
    EXPECT_EQ(refused.code, 2) << to;
    EXPECT_THAT(refused.err,
                AllOf(HasSubstr("holds deformable particles"), HasSubstr("export --to packing")));
  }
  const Outcome refused = supple("export run.h5 --to vtp --cells outlines");
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, AllOf(HasSubstr("no outlines"), HasSubstr("--cells triangles")));
  EXPECT_EQ(entries(), 1);
}

}  // namespace
}  // namespace supple
