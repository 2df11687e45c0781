#include <fmt/format.h>
#include <gmock/gmock.h>

#include "supple/core/error.hpp"
#include "supple/experiment/case.hpp"
#include "tests/experiment/error_of.hpp"

namespace supple {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Check, TheDefaultsAreSoundAndRaiseNoDoubt) {
  EXPECT_EQ(error_of(Case{}), "no error");
  EXPECT_THAT(find_doubts(Case{}), IsEmpty());
}

TEST(Check, DiscsLargerThanHalfOfTheCell) {
  Case c;
  c.origin = "c.toml";
  c.particles.discs = 4;
  EXPECT_EQ(error_of(c),
            "c.toml: particles.packing_fraction = 1.5 cannot be reached with N = 4 (the largest disc would "
            "be 0.000398 m "
            "across, more than half of the cell's 0.0005 m, and meet itself or a neighbour twice across the "
            "boundary); "
            "raise particles.N or lower particles.packing_fraction");
  c.initial.state = "given.json";
  EXPECT_EQ(error_of(c), "no error");
}

/// Stiffness, gravity, ...: a run of them would say that the energy is not finite, and to take smaller steps.
TEST(Check, NumbersThatCannotBeComputedWithAreRefusedByTheirKey) {
  int keys = 0;
  Case c;
  for_each_key(c, [&]<class P>(const std::string& key, const Field<P>& field, P& values) {
    const auto* member = std::get_if<double P::*>(&field.member);
    if (!member) return;
    ++keys;
    double& value = values.**member;
    const double usual = value;
    for (const double size : {1e308, -1e61, 1e-61}) {
      value = size;
      EXPECT_THAT(error_of(c), HasSubstr(fmt::format("{} = {:.6g} cannot be computed with (numbers are from "
                                                     "1e-60 to 1e+60 here)",
                                                     key, size)));
    }
    value = 1e60;
    EXPECT_THAT(error_of(c), testing::Not(HasSubstr("cannot be computed with")));
    value = usual;
  });
  EXPECT_GT(keys, 50);
}

TEST(Check, LawsThatLackTheirKeys) {
  Case c;
  c.material.elastic_law = "expression";
  EXPECT_THAT(error_of(c), HasSubstr("without material.elastic_expression"));
  c.material.elastic_law = "plateau";
  c.material.plateau_begin = 0.9;
  EXPECT_THAT(error_of(c), HasSubstr("plateau_begin = 0.9 is not below plateau_end = 0.8"));
}

TEST(Check, OnlyLeesEdwardsCellsCanBeSheared) {
  Case c;
  c.box.boundary = "fixed";
  EXPECT_THAT(error_of(c), HasSubstr("box.boundary = \"fixed\" cannot be sheared"));
  c.general.experiment = "dynamics";
  c.time.steps = 1;
  EXPECT_EQ(error_of(c), "no error");
  c.shear.rate = "10*cos(t)";
  EXPECT_THAT(error_of(c), HasSubstr("shear.rate = \"10*cos(t)\" in a cell with boundary = \"fixed\""));
}

TEST(Check, DynamicsNeedsItsSteps) {
  Case c;
  c.general.experiment = "dynamics";
  EXPECT_THAT(error_of(c), HasSubstr("time.steps is missing"));
}

TEST(Check, DynamicsHasNoPublishedText) {
  Case c;
  c.general.experiment = "dynamics";
  c.time.steps = 10;
  EXPECT_EQ(error_of(c), "no error");
  c.output.text = true;
  c.given = {"output.text"};
  EXPECT_THAT(error_of(c), HasSubstr("output.text has no effect"));
}

TEST(Check, EveryProblemIsNamed) {
  Case c;
  c.box.boundary = "fixed";
  c.material.elastic_law = "expression";
  EXPECT_THAT(error_of(c), HasSubstr("elastic_expression"));
  EXPECT_THAT(error_of(c), HasSubstr("\nbox.boundary"));
}

TEST(Check, KeysWithoutEffectRaiseDoubts) {
  Case c;
  c.given = {"material.plateau_slope", "particles.cut_lines"};
  c.particles.permanent_links = false;
  EXPECT_THAT(find_doubts(c),
              Contains("material.plateau_slope has no effect without material.elastic_law = \"plateau\""));
  EXPECT_THAT(find_doubts(c),
              Contains("particles.cut_lines has no effect without particles.permanent_links = true"));
}

TEST(Check, ProtocolsThatCannotBeEvaluatedRaiseDoubts) {
  Case c;
  c.shear.periods = 1;
  c.shear.pre_periods = 0;
  c.particles.packing_fraction = 0.5;
  EXPECT_THAT(find_doubts(c), Contains(HasSubstr("shear.periods = 1")));
  EXPECT_THAT(find_doubts(c), Contains(HasSubstr("below jamming")));
  c.general.physics = "particleshear-1.0.2";  // which takes drift and offset from the rests
  EXPECT_THAT(find_doubts(c), Contains(HasSubstr("shear.pre_periods = 0")));
}

TEST(Check, VerticesThatGatherOrLetOthersThrough) {
  Case c;
  c.general.experiment = "jamming";
  c.bodies.family = "droplet";
  resolve_family(c);
  EXPECT_THAT(find_doubts(c), IsEmpty());
  c.bodies.k_l = 0;
  EXPECT_THAT(find_doubts(c), Contains(HasSubstr("does not keep vertices apart")));
  c.bodies.k_l = 0.1;
  c.bodies.diameter_ratio = 0.8;
  EXPECT_THAT(find_doubts(c),
              Contains(HasSubstr("edges are 1.25 times as long as vertices are wide; from 2 on")));
  c.bodies.diameter_ratio = 0.5;
  EXPECT_THAT(find_doubts(c), Contains(HasSubstr("so that vertices of other particles pass")));
  c.contact.kind = "smooth";
  EXPECT_THAT(find_doubts(c), IsEmpty());
}

TEST(Check, ShapeParametersOverThoseOfRegularPolygons) {
  Case c;
  c.general.experiment = "jamming";
  c.bodies.shape_ratio = 0.9;
  EXPECT_THAT(error_of(c), HasSubstr("no polygon is rounder"));
  c.bodies.shape_ratio = 1.1;
  EXPECT_EQ(error_of(c), "no error");
  c.given.insert("bodies.A0");
  EXPECT_THAT(error_of(c), HasSubstr("leave one away"));
}

}  // namespace
}  // namespace supple
