/// Small displacements of a solid at rest, and the elastic constants that they show.
#pragma once
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <functional>
#include <vector>

#include "supple/build/solids.hpp"
#include "supple/energy/bond_stretch.hpp"
#include "supple/energy/element_strain.hpp"
#include "supple/energy/term.hpp"

namespace supple::testing {

/// The solid of a mesh to first order in the displacements u of its nodes: energy (1/2) u.K.u, with the
/// second derivatives K of the terms where nothing is strained.
template <int Dim>
class SolidResponse {
 public:
  explicit SolidResponse(SolidMesh<Dim> mesh) : mesh_(std::move(mesh)) {}

  /// Springs of these stiffnesses along all bonds.
  void add_springs(const std::function<double(const std::array<std::int32_t, 2>&)>& stiffness) {
    for (const auto& bond : mesh_.bond) {
      const Vec<Dim> x[2] = {at(bond[0]), at(bond[1])};
      add<BondStretch<Dim>>(bond, x, {stiffness(bond), norm(x[1] - x[0])});
    }
  }
  void add_elements(const LameConstants& material) {
    for (const auto& element : mesh_.element) {
      Vec<Dim> x[Dim + 1];
      for (int k = 0; k <= Dim; ++k) x[k] = at(element[k]);
      add<ElementStrain<Dim>>(element, x, ElementStrain<Dim>::at_rest(x, material));
    }
  }

  /// The displacements of nodes in balance, those of `held` ones given as a function of (node, direction),
  /// all others under these forces, flat lists of coordinates.
  Eigen::VectorXd solve(const std::function<bool(int, int)>& held, const Eigen::VectorXd& given,
                        const Eigen::VectorXd& force) const {
    const Eigen::SparseMatrix<double> K = matrix();
    Eigen::VectorXd u = Eigen::VectorXd::Zero(size());
    std::vector<int> place(static_cast<std::size_t>(size()), -1);
    int free = 0;
    for (int i = 0; i < size(); ++i) {
      if (held(i / Dim, i % Dim)) u[i] = given[i];
      else place[static_cast<std::size_t>(i)] = free++;
    }
    const Eigen::VectorXd lack = force - K * u;
    Eigen::VectorXd rhs(free);
    std::vector<Eigen::Triplet<double>> entries;
    for (int j = 0; j < size(); ++j) {
      if (place[j] < 0) continue;
      rhs[place[j]] = lack[j];
      for (Eigen::SparseMatrix<double>::InnerIterator it(K, j); it; ++it)
        if (place[it.row()] >= 0) entries.emplace_back(place[it.row()], place[j], it.value());
    }
    Eigen::SparseMatrix<double> part(free, free);
    part.setFromTriplets(entries.begin(), entries.end());
    // Rigid motions cost no energy: the method needs no more than forces without a net one and a torque.
    Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper> solver(part);
    solver.setTolerance(1e-12);
    solver.setMaxIterations(50 * free);
    const Eigen::VectorXd moved = solver.solve(rhs);
    for (int i = 0; i < size(); ++i)
      if (place[i] >= 0) u[i] = moved[place[i]];
    return u;
  }

  double energy(const Eigen::VectorXd& u) const { return 0.5 * u.dot(matrix() * u); }
  Eigen::VectorXd forces_of(const Eigen::VectorXd& u) const { return matrix() * u; }

  /// Constants where all nodes of the boundary follow a uniform strain, and those within are in balance.
  ElasticConstants constants_by_displacement() const {
    const double V = boundary_volume(mesh_);
    Mat<Dim> swell, stretch, shear;
    for (int d = 0; d < Dim; ++d) swell[d][d] = 1;
    stretch[0][0] = shear[0][1] = shear[1][0] = 1;
    stretch[1][1] = -1;
    const double bulk = 2 * energy_under(swell) / (V * Dim * Dim);
    const double mu = (energy_under(stretch) + energy_under(shear)) / (4 * V);
    return elastic_constants<Dim>({bulk - 2 * mu / Dim, mu});
  }

  /// Constants by the mean strain under a uniform tension 1 of the boundary along the first axis.
  ElasticConstants constants_by_tension() const {
    Mat<Dim> tension;
    tension[0][0] = 1;
    const Mat<Dim> strain = strain_under(tension);
    double across = 0;
    for (int d = 1; d < Dim; ++d) across += strain[d][d] / (Dim - 1);
    return {1 / strain[0][0], -across / strain[0][0]};
  }
  /// Bulk modulus, pressure by relative loss of area (volume), under a uniform pressure on the boundary.
  double bulk_by_pressure() const {
    Mat<Dim> pressure;
    for (int d = 0; d < Dim; ++d) pressure[d][d] = -1;
    const Mat<Dim> strain = strain_under(pressure);
    double change = 0;
    for (int d = 0; d < Dim; ++d) change += strain[d][d];
    return -1 / change;
  }

 private:
  int size() const { return Dim * static_cast<int>(mesh_.node.size()); }
  const Vec<Dim>& at(std::int32_t i) const { return mesh_.node[static_cast<std::size_t>(i)]; }

  template <class Term>
  void add(const std::array<std::int32_t, Term::arity>& sites, const Vec<Dim> (&x)[Term::arity],
           const typename Term::Param& p) {
    const auto h = term_hessian<Term, Dim>(x, p);
    for (int a = 0; a < Term::arity; ++a)
      for (int b = 0; b < Term::arity; ++b)
        for (int c = 0; c < Dim; ++c)
          for (int d = 0; d < Dim; ++d)
            entries_.emplace_back(sites[a] * Dim + c, sites[b] * Dim + d, h[a * Dim + c][b * Dim + d]);
  }

  Eigen::SparseMatrix<double> matrix() const {
    Eigen::SparseMatrix<double> K(size(), size());
    K.setFromTriplets(entries_.begin(), entries_.end());
    return K;
  }

  double energy_under(const Mat<Dim>& strain) const {
    Eigen::VectorXd given(size());
    for (int i = 0; i < size(); ++i) given[i] = (strain * at(i / Dim))[i % Dim];
    return energy(
        solve([&](int node, int) { return node < mesh_.boundary; }, given, Eigen::VectorXd::Zero(size())));
  }

  /// The outward normal of a facet of the boundary, as long as its length (area).
  Vec<Dim> normal(const std::array<std::int32_t, Dim>& facet) const {
    const Vec<Dim> along = at(facet[1]) - at(facet[0]);
    if constexpr (Dim == 2) return -turned_left(along);
    else return 0.5 * cross(along, at(facet[2]) - at(facet[0]));
  }

  /// Mean strain where this stress pulls at every facet, shared by its corners.
  Mat<Dim> strain_under(const Mat<Dim>& stress) const {
    Eigen::VectorXd force = Eigen::VectorXd::Zero(size());
    for (const auto& facet : mesh_.facet) {
      const Vec<Dim> share = (1.0 / Dim) * (stress * normal(facet));
      for (const std::int32_t i : facet)
        for (int d = 0; d < Dim; ++d) force[i * Dim + d] += share[d];
    }
    const Eigen::VectorXd u = solve([](int, int) { return false; }, force, force);
    Mat<Dim> strain;
    for (const auto& facet : mesh_.facet) {
      Vec<Dim> mean;
      for (const std::int32_t i : facet)
        for (int d = 0; d < Dim; ++d) mean[d] += u[i * Dim + d] / Dim;
      const Vec<Dim> n = (1 / boundary_volume(mesh_)) * normal(facet);
      strain.add_outer(0.5, mean, n);
      strain.add_outer(0.5, n, mean);
    }
    return strain;
  }

  SolidMesh<Dim> mesh_;
  std::vector<Eigen::Triplet<double>> entries_;
};

}  // namespace supple::testing
