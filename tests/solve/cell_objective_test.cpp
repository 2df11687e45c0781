#include "supple/solve/cell_objective.hpp"

#include <gtest/gtest.h>

#include "supple/contact/rough_contacts.hpp"
#include "supple/model/rigid.hpp"
#include "tests/support/dense.hpp"
#include "tests/support/polygons.hpp"

namespace supple {
namespace {

struct Sample {
  System<2> system = testing::random_polygons();
  ForceField<2> field = testing::polygon_field(RoughContacts<2>(Harmonic{1}));
};

TEST(CellObjective, SlopeIsThatOfTheEnthalpy) {
  Sample s;
  make_rigid(s.system, 3);
  CellObjective<2> cell(s.system, s.field, {}, {true, true}, 0.03, 0.01);
  std::vector<double> x = cell.coordinates(), slope(x.size()), unused(x.size());
  x[x.size() - 2] = 0.03;  // a cell that has already moved
  x[x.size() - 1] = -0.02;
  cell.evaluate(x, slope);
  const double h = 1e-6;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double x0 = x[k];
    x[k] = x0 + h;
    const double above = cell.evaluate(x, unused);
    x[k] = x0 - h;
    const double below = cell.evaluate(x, unused);
    x[k] = x0;
    EXPECT_NEAR(slope[k], (above - below) / (2 * h), 1e-7 * (1 + std::abs(slope[k]))) << k;
  }
}

/// Or the energy, 1e8 times smaller near jamming, would be lost in P A.
TEST(CellObjective, EnthalpyIsTheEnergyInTheCellAtConstruction) {
  Sample s;
  CellObjective<2> cell(s.system, s.field, {}, {true, true}, 0.03, 0.01);
  const std::vector<double> x = cell.coordinates();
  std::vector<double> slope(x.size());
  const double enthalpy = cell.evaluate(x, slope);
  Evaluation<2> out;
  s.field.evaluate(s.system, Detail::energies, out);
  EXPECT_GT(enthalpy, 0);
  EXPECT_NEAR(enthalpy, out.energy.stored(), 1e-14 * enthalpy);
}

/// In the cell at construction; the sparse matrix has the same rows of the cell.
TEST(CellObjective, HessianIsThatOfTheEnthalpy) {
  Sample s;
  make_rigid(s.system, 3);
  CellObjective<2> cell(s.system, s.field, {}, {true, true}, 0.03, 0.01);
  std::vector<double> x = cell.coordinates(), above(x.size()), below(x.size());
  SparseMatrix lower, sparse;
  cell.hessian(x, lower);
  cell.preconditioner(x, sparse);
  const Eigen::MatrixXd full = testing::dense(lower), sparse_full = testing::dense(sparse);
  const int n = cell.size();
  const double h = 1e-6;
  for (int column = 0; column < n; ++column) {
    const double x0 = x[column];
    x[column] = x0 + h;
    cell.evaluate(x, above);
    x[column] = x0 - h;
    cell.evaluate(x, below);
    x[column] = x0;
    for (int row = column; row < n; ++row) {
      const double expected = (above[row] - below[row]) / (2 * h);
      EXPECT_NEAR(full(row, column), expected, 1e-5 * (1 + std::abs(expected))) << row << ' ' << column;
      if (row >= n - 2) {
        EXPECT_EQ(sparse_full(row, column), full(row, column)) << row << ' ' << column;
      }
    }
  }
}

/// The same minimiser, with the cell among its numbers: it ends where the stress is the one asked for.
TEST(CellObjective, MinimiserFindsTheCellOfAPressureAndAShearStress) {
  for (const Minimiser method : {Minimiser::fire, Minimiser::automatic}) {
    Sample s;
    const double pressure = 0.02, shear = 1e-3;
    CellObjective<2> cell(s.system, s.field, {1e-8, 1e-10}, {true, true}, pressure, shear);
    std::vector<double> x = cell.coordinates();
    MinimiseSpec spec;
    spec.method = method;
    const MinimiseReport report = minimise(cell, x, spec);
    EXPECT_TRUE(report.converged) << report.reason;
    Evaluation<2> out;
    s.field.evaluate(s.system, Detail::energies, out);
    const double area = s.system.box.volume(), start = testing::random_polygons().box.volume();
    EXPECT_NEAR(0.5 * (out.virial[0][0] + out.virial[1][1]) / area, pressure, 1e-6 * pressure);
    EXPECT_NEAR(-out.virial[0][1] / start, shear, 1e-5 * shear);
  }
}

}  // namespace
}  // namespace supple
