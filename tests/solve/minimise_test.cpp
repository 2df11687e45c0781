#include "supple/solve/minimise.hpp"

#include <gtest/gtest.h>

#include <string>

#include "supple/contact/rough_contacts.hpp"
#include "supple/core/error.hpp"
#include "supple/model/polygons.hpp"
#include "supple/solve/body_objective.hpp"
#include "tests/support/dense.hpp"
#include "tests/support/objectives.hpp"

namespace supple {
namespace {

using testing::Diagonal;
using testing::Rosenbrock;
using testing::SoftDiscs;
using testing::Springs;
using testing::StiffChain;

constexpr const char* names[] = {"fire", "newton", "auto"};

MinimiseSpec by_name(const std::string& name) {
  MinimiseSpec spec;
  spec.method = minimiser_named(name);
  return spec;
}

void record(const std::string& name, const MinimiseReport& report) {
  ::testing::Test::RecordProperty(name + "_evaluations", std::to_string(report.evaluations));
  ::testing::Test::RecordProperty(name + "_factorisations", std::to_string(report.factorisations));
}

/// The objective's second derivatives against central differences of its gradient.
void expect_hessian(Objective& objective, std::vector<double> x, double step, double tolerance) {
  SparseMatrix lower;
  objective.hessian(x, lower);
  const Eigen::MatrixXd full = testing::dense(lower);
  std::vector<double> up(x.size()), down(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double at = x[i];
    x[i] = at + step;
    objective.evaluate(x, up);
    x[i] = at - step;
    objective.evaluate(x, down);
    x[i] = at;
    for (std::size_t j = 0; j < x.size(); ++j)
      ASSERT_NEAR(full(j, i), (up[j] - down[j]) / (2 * step), tolerance) << i << " " << j;
  }
}

TEST(Objectives, HessiansAreThoseOfTheirGradients) {
  Springs springs(12, 0.6, 0.2, 3);
  expect_hessian(springs, springs.start(0.05), 1e-6, 1e-7);
  Rosenbrock valley(5);
  expect_hessian(valley, {0.3, -0.7, 1.1, 0.2, 0.9}, 1e-5, 1e-5);
  SoftDiscs discs(8, 0.9);
  expect_hessian(discs, discs.start(2), 1e-6, 1e-7);
}

TEST(Minimise, StiffChainReachesItsClosedFormMinimum) {
  for (const std::string name : names) {
    StiffChain chain(200, 1e5, 0.01);
    std::vector<double> x(200, 3.0);
    const MinimiseReport report = minimise(chain, x, by_name(name));
    EXPECT_TRUE(report.converged) << name << ": " << report.reason;
    EXPECT_LE(report.residual, 1e-12);
    for (int i = 0; i < 200; ++i) ASSERT_NEAR(x[i], i, 1e-7) << name;  // residual / smallest stiffness
    record(name, report);
  }
}

TEST(Minimise, QuadraticTakesNewtonAFewFactorisations) {
  StiffChain chain(200, 1e8, 0.0);
  std::vector<double> x(200, 3.0);
  const MinimiseReport report = minimise(chain, x, by_name("newton"));
  EXPECT_TRUE(report.converged);
  EXPECT_LE(report.factorisations, 10);
}

TEST(Minimise, RosenbrockValley) {
  for (const std::string name : names) {
    Rosenbrock valley(100);
    std::vector<double> x(100, 0.2);
    const MinimiseReport report = minimise(valley, x, by_name(name));
    EXPECT_TRUE(report.converged) << name << ": " << report.reason;
    for (double c : x) ASSERT_NEAR(c, 1, 1e-8) << name;
    record(name, report);
  }
}

TEST(Minimise, SpringsFindTheHiddenPoints) {
  for (const std::string name : names) {
    Springs springs(100, 0.25, 0, 5);
    std::vector<double> x = springs.start(0.02);
    const MinimiseReport report = minimise(springs, x, by_name(name));
    EXPECT_TRUE(report.converged) << name << ": " << report.reason;
    EXPECT_LT(report.energy, 1e-22) << name;
    record(name, report);
  }
}

TEST(Minimise, FrustratedSpringsReachOneMinimum) {
  double energy[3], *e = energy;
  for (const std::string name : names) {
    Springs springs(100, 0.25, 0.05, 5);
    std::vector<double> x = springs.start(0);
    const MinimiseReport report = minimise(springs, x, by_name(name));
    EXPECT_TRUE(report.converged) << name << ": " << report.reason;
    *e++ = report.energy;
    record(name, report);
  }
  EXPECT_GT(energy[0], 1e-4);
  EXPECT_NEAR(energy[1] / energy[0], 1, 1e-12);
  EXPECT_NEAR(energy[2] / energy[0], 1, 1e-12);
}

// Contacts open and close on the way; the packing has rattlers and may translate.
TEST(Minimise, SoftDiscsToRounding) {
  for (const std::string name : names)
    for (const double phi : {0.86, 0.9}) {
      SoftDiscs discs(100, phi);
      discs.absolute = 1e-13;
      std::vector<double> x = discs.start(1);
      const MinimiseReport report = minimise(discs, x, by_name(name));
      EXPECT_TRUE(report.converged) << name << ": " << report.reason;
      EXPECT_GT(discs.contacts, 180);
      EXPECT_GT(report.energy, 1e-3);
      record(name + (phi > 0.88 ? "_90" : "_86"), report);
    }
}

// Without a jam the energy falls to zero, and so do the forces.
TEST(Minimise, LooseDiscsComeToRestApart) {
  for (const std::string name : names) {
    SoftDiscs discs(60, 0.6);
    std::vector<double> x = discs.start(4);
    const MinimiseReport report = minimise(discs, x, by_name(name));
    EXPECT_TRUE(report.converged) << name << ": " << report.reason;
    EXPECT_LT(report.energy, 1e-24) << name;
  }
}

TEST(Minimise, QuarticAndFlatDirectionsDoNoHarm) {
  std::vector<double> k(40), q(40), x(40, 0.7);
  for (int i = 0; i < 40; ++i) {
    k[i] = i % 4 == 0 ? std::pow(10, -i / 8.0) : 0;
    q[i] = i % 4 <= 1 ? 1 : 0;  // i % 4: both, quartic alone, neither, neither
  }
  for (const std::string name : names) {
    Diagonal objective(k, q);
    objective.goal = 1e-9;
    std::vector<double> y = x;
    const MinimiseReport report = minimise(objective, y, by_name(name));
    EXPECT_TRUE(report.converged) << name << ": " << report.reason;
    for (int i = 0; i < 40; ++i) {
      if (i % 4 == 1) {
        EXPECT_LT(std::abs(y[i]), 1.01e-3) << name;
      }  // y^3 <= 1e-9
      if (i % 4 >= 2) {
        EXPECT_EQ(y[i], 0.7) << name;
      }
    }
    record(name, report);
  }
}

// x^4 - x^2 from the top but for a little: curvature is negative there.
TEST(Minimise, LeavesAMaximum) {
  for (const std::string name : names) {
    Diagonal objective({-2, 1, -2}, {4, 0, 4});
    std::vector<double> x = {1e-9, 1, -1e-9};
    const MinimiseReport report = minimise(objective, x, by_name(name));
    EXPECT_TRUE(report.converged) << name << ": " << report.reason;
    EXPECT_NEAR(x[0], std::sqrt(0.5), 1e-9) << name;
    EXPECT_NEAR(x[2], -std::sqrt(0.5), 1e-9) << name;
  }
}

TEST(Minimise, RepeatsBitForBit) {
  for (const std::string name : names) {
    SoftDiscs discs(64, 0.88);
    std::vector<double> first = discs.start(1), again = first;
    std::vector<double> padded(first.size() + 1);  // another alignment
    std::copy(first.begin(), first.end(), padded.begin() + 1);
    const MinimiseReport report = minimise(discs, first, by_name(name));
    minimise(discs, again, by_name(name));
    EXPECT_TRUE(report.converged);
    EXPECT_EQ(first, again) << name;
    minimise(discs, std::span(padded).subspan(1), by_name(name));
    EXPECT_TRUE(std::equal(first.begin(), first.end(), padded.begin() + 1)) << name;
  }
}

TEST(Minimise, UnreachableToleranceIsReported) {
  for (const std::string name : names) {
    SoftDiscs discs(60, 0.9);
    discs.absolute = 0;
    std::vector<double> x = discs.start(1);
    const MinimiseReport report = minimise(discs, x, by_name(name));
    EXPECT_FALSE(report.converged) << name;
    EXPECT_EQ(report.reason, "the residual falls no further") << name;
    EXPECT_LT(report.residual, 1e-13) << name;
  }
}

TEST(Minimise, BudgetAndCallbackStopIt) {
  for (const std::string name : names) {
    SoftDiscs discs(60, 0.9);
    std::vector<double> x = discs.start(1);
    MinimiseSpec spec = by_name(name);
    spec.max_evaluations = 20;
    MinimiseReport report = minimise(discs, x, spec);
    EXPECT_FALSE(report.converged);
    EXPECT_EQ(report.reason, "20 evaluations were not enough");
    EXPECT_LE(report.evaluations, 50);
    spec = by_name(name);
    spec.callback_interval = 3;
    long seen = 0;
    report = minimise(discs, x, spec, [&](const MinimiseReport& now) { return ++seen, now.iterations < 6; });
    EXPECT_EQ(report.reason, "stopped by the caller");
    EXPECT_EQ(seen, 2);
    EXPECT_EQ(report.iterations, 6);
  }
}

TEST(Minimise, EndsEvaluatedAtThePointReturned) {
  for (const std::string name : names)
    for (const long budget : {20L, 300L, 1000000L}) {
      SoftDiscs discs(60, 0.9);
      std::vector<double> x = discs.start(1), gradient(x.size());
      MinimiseSpec spec = by_name(name);
      spec.max_evaluations = budget;
      const MinimiseReport report = minimise(discs, x, spec);
      const double force = discs.mean_force;
      EXPECT_EQ(report.energy, discs.evaluate(x, gradient));
      EXPECT_EQ(force, discs.mean_force);
      EXPECT_EQ(report.residual, discs.residual(x, gradient));
    }
}

/// Finite only near its minimum.
class Pit : public Diagonal {
 public:
  using Diagonal::Diagonal;
  double evaluate(std::span<const double> x, std::span<double> g) override {
    const double energy = Diagonal::evaluate(x, g);
    return largest(x) < 1.05 ? energy : std::numeric_limits<double>::quiet_NaN();
  }
};

TEST(Minimise, StepsThatAreNotFiniteAreTakenBack) {
  for (const std::string name : names) {
    Pit pit({1, 1e-3, 2}, {0, 0, 1});
    std::vector<double> x = {1, 1, -1};
    EXPECT_TRUE(minimise(pit, x, by_name(name)).converged) << name;
    x = {2, 2, 2};
    const MinimiseReport report = minimise(pit, x, by_name(name));
    EXPECT_FALSE(report.converged);
    EXPECT_EQ(report.reason, "energy or gradient is not finite at the start");
  }
}

TEST(Minimise, RefusesOtherNamesAndSizes) {
  EXPECT_THROW(minimiser_named("fier"), Error);
  Rosenbrock valley(10);
  std::vector<double> x(9);
  EXPECT_THROW(minimise(valley, x), Error);
}

TEST(Minimise, NothingToMinimise) {
  Diagonal nothing({}, {});
  EXPECT_TRUE(minimise(nothing, {}).converged);
}

// As its residual never gets there, each would go on for 10^6 evaluations.
TEST(Minimise, StopsWithinAFewEvaluationsWhenAsked) {
  for (const std::string name : names) {
    SoftDiscs discs(60, 0.9);
    discs.absolute = 0;
    std::vector<double> x = discs.start(1);
    MinimiseSpec spec = by_name(name);
    spec.callback_interval = 1'000'000;
    long asked = 0;
    spec.stop_requested = [&] { return ++asked > 100; };
    const MinimiseReport report = minimise(discs, x, spec);
    EXPECT_EQ(report.ending, Ending::interrupted) << name;
    EXPECT_LT(report.evaluations, 140) << name;  // a line search of 25 at most, then the last point again
  }
}

TEST(Minimise, FactorisationsCountAsEvaluations) {
  Rosenbrock valley(100);
  std::vector<double> x(100, 0.2);
  MinimiseSpec spec = by_name("newton");
  spec.newton.memory = 0;
  spec.max_evaluations = 20;
  const MinimiseReport report = minimise(valley, x, spec);
  EXPECT_EQ(report.ending, Ending::exhausted);
  EXPECT_GT(report.factorisations, 5);
  EXPECT_LE(report.evaluations + report.factorisations, 20 + 26);
}

// The direction between them, and so the second derivatives, are not defined.
TEST(Minimise, CoincidentDiscsPart) {
  for (const std::string name : names) {
    System<2> system;
    system.box.length = {8, 8};
    for (int k = 0; k < 2; ++k) add_disc_body(system, {4, 4}, 0.5);
    ForceField<2> field(RoughContacts<2>(Harmonic{1, true}));
    BodyObjective<2> objective(system, field, {1e-9, 1e-12});
    std::vector<double> x = objective.coordinates();
    MinimiseSpec spec = by_name(name);
    int asked = 0;
    spec.stop_requested = [&] { return ++asked > 5000; };
    const MinimiseReport report = minimise(objective, x, spec);
    EXPECT_TRUE(report.converged) << name << ": " << report.reason;
    EXPECT_GT(norm(system.state.position[1] - system.state.position[0]), 1 - 1e-6) << name;
  }
}

}  // namespace
}  // namespace supple
