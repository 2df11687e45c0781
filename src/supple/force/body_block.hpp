/// A term of whole bodies: a sum over the facets of each, its energy, and the forces on the facets' sites.
#pragma once
#include <fmt/core.h>

#include "supple/force/term_block.hpp"
#include "supple/geometry/facet.hpp"

namespace supple {

/// Term::energy(sum of Term::measure(facet), param[b]) for each body b of the topology; bodies without facets
/// or stiffness take no part.
template <class Term, int Dim>
class BodyBlock final : public TermBlock<Dim> {
 public:
  using Param = typename Term::Param;
  explicit BodyBlock(std::vector<Param> params) : params_(std::move(params)) {}

  std::string_view name() const override { return Term::name; }

  double energy(const System<Dim>& system) const override {
    double sum = 0;
    for_bodies(system, [&](int b) { sum += Term::energy(measure(system, b), params_[b]); });
    return sum;
  }

  void evaluate(const System<Dim>& system, Detail detail, Evaluation<Dim>& out) const override {
    for_bodies(system, [&](int b) {
      Jet<double, 1> v(measure(system, b));
      v.slope[0] = 1;
      const Jet<double, 1> energy = Term::energy(v, params_[b]);
      const Vec<Dim> origin = system.state.position[system.topology.begin[b]];
      for_slopes(system, b, [&](std::int32_t site, const Vec<Dim>& slope) {
        out.force[site] -= energy.slope[0] * slope;
        if (detail == Detail::energies)
          out.virial.add_outer(-energy.slope[0], slope, system.state.position[site] - origin);
      });
      if (detail == Detail::energies) out.energy.terms += energy.value;
    });
  }

  void add_hessian(const System<Dim>& system, HessianBlocks<Dim>& blocks) const override {
    for_bodies(system, [&](int b) {
      Jet<Jet<double, 1>, 1> v(0.0);
      v.value.value = measure(system, b);
      v.value.slope[0] = 1;
      v.slope[0] = 1.0;
      const auto energy = Term::energy(v, params_[b]);
      add_outer_product(system, b, energy.slope[0].slope[0], blocks);
      add_curvature(system, b, energy.slope[0].value, blocks);
    });
  }

 private:
  using Facet = std::array<std::int32_t, Dim>;

  template <class Body>
  void for_bodies(const System<Dim>& system, const Body& body) const {
    const Topology<Dim>& t = system.topology;
    if (t.facet_begin.size() != params_.size() + 1)
      throw input_error(fmt::format("{}: {} bodies with {} parameter sets", Term::name,
                                    t.facet_begin.empty() ? 0 : t.facet_begin.size() - 1, params_.size()),
                        "they do not match", "give one parameter set for each body");
    for (std::size_t b = 0; b < params_.size(); ++b)
      if (t.facet_begin[b] < t.facet_begin[b + 1] && params_[b].stiffness != 0) body(static_cast<int>(b));
  }

  /// Points of facet f relative to the first site of body b, so that a body far from the origin loses no
  /// digits.
  template <class S = double>
  static void gather(const System<Dim>& system, int b, std::int32_t f, VecOf<S, Dim> (&x)[Dim]) {
    const Vec<Dim> origin = system.state.position[system.topology.begin[b]];
    for (int a = 0; a < Dim; ++a) {
      const Vec<Dim> r = system.state.position[system.topology.facet[f][a]] - origin;
      for (int d = 0; d < Dim; ++d) x[a][d] = r[d];
    }
  }

  static double measure(const System<Dim>& system, int b) {
    double sum = 0;
    for (std::int32_t f = system.topology.facet_begin[b]; f < system.topology.facet_begin[b + 1]; ++f) {
      Vec<Dim> x[Dim];
      gather(system, b, f, x);
      sum += Term::measure(x);
    }
    return sum;
  }

  /// visit(site, dv_f/dx_site) for every site of every facet of the body.
  template <class Visit>
  static void for_slopes(const System<Dim>& system, int b, const Visit& visit) {
    using J = Jet<double, Dim * Dim>;
    for (std::int32_t f = system.topology.facet_begin[b]; f < system.topology.facet_begin[b + 1]; ++f) {
      VecOf<J, Dim> x[Dim];
      gather(system, b, f, x);
      for (int k = 0; k < Dim * Dim; ++k) x[k / Dim][k % Dim].slope[k] = 1;
      const J v = Term::measure(x);
      for (int a = 0; a < Dim; ++a) {
        Vec<Dim> slope;
        for (int d = 0; d < Dim; ++d) slope[d] = v.slope[a * Dim + d];
        visit(system.topology.facet[f][a], slope);
      }
    }
  }

  /// Adds E'' (dv/dx) (dv/dx)^T for all pairs of sites of the body; `stiffness` is E'' = d2E/dv2.
  static void add_outer_product(const System<Dim>& system, int b, double stiffness,
                                HessianBlocks<Dim>& blocks) {
    const std::int32_t first = system.topology.begin[b], end = system.topology.begin[b + 1];
    std::vector<Vec<Dim>> slope(static_cast<std::size_t>(end - first));
    for_slopes(system, b, [&](std::int32_t site, const Vec<Dim>& s) { slope[site - first] += s; });
    for (std::int32_t i = first; i < end; ++i)
      for (std::int32_t j = first; j <= i; ++j) {
        HessianBlock<Dim> block{i, j, {}};
        block.h.add_outer(stiffness, slope[i - first], slope[j - first]);
        blocks.push_back(block);
      }
  }

  /// Adds E' d2v/dx2, facet by facet; `slope` is E' = dE/dv.
  static void add_curvature(const System<Dim>& system, int b, double slope, HessianBlocks<Dim>& blocks) {
    constexpr int n = Dim * Dim;
    using First = Jet<double, n>;
    for (std::int32_t f = system.topology.facet_begin[b]; f < system.topology.facet_begin[b + 1]; ++f) {
      VecOf<Jet<First, n>, Dim> x[Dim];
      gather(system, b, f, x);
      for (int k = 0; k < n; ++k) {
        x[k / Dim][k % Dim].value.slope[k] = 1;
        x[k / Dim][k % Dim].slope[k] = 1.0;
      }
      const auto v = Term::measure(x);
      for (int a = 0; a < Dim; ++a)
        for (int c = 0; c <= a; ++c) {
          HessianBlock<Dim> block{system.topology.facet[f][a], system.topology.facet[f][c], {}};
          for (int d = 0; d < Dim; ++d)
            for (int e = 0; e < Dim; ++e) block.h[d][e] = slope * v.slope[a * Dim + d].slope[c * Dim + e];
          blocks.push_back(block);
        }
    }
  }

  std::vector<Param> params_;
};

}  // namespace supple
