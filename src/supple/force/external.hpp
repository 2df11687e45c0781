/// Forces from outside: gravity and tethers.
#pragma once
#include <vector>

#include "supple/model/evaluation.hpp"
#include "supple/model/hessian.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// A spring from a site to a point that does not move: U = (k/2) |x - anchor|^2 [MacKeith 2025,
/// section 9.3.3].
template <int Dim>
struct Tether {
  std::int32_t site;
  Vec<Dim> anchor;
  double stiffness;  ///< [energy/length^2]
};

/// Gravity, U = -sum m g.x over all sites, and tethers. Positions are not wrapped: gravity makes sense along
/// directions that are not periodic.
template <int Dim>
struct ExternalForces {
  Vec<Dim> gravity{};  ///< [length/time^2]
  std::vector<Tether<Dim>> tethers;

  bool empty() const { return gravity == Vec<Dim>{} && tethers.empty(); }

  /// Adds forces and, with Detail::energies, energy.external. The forces are external to the sample, so they
  /// add nothing to the virial.
  void evaluate(const System<Dim>& system, Detail detail, Evaluation<Dim>& out) const {
    double energy = 0;
    if (!(gravity == Vec<Dim>{}))
      for (int i = 0; i < system.state.size(); ++i) {
        const Vec<Dim> weight = system.state.mass[i] * gravity;
        out.force[i] += weight;
        energy -= dot(weight, system.state.position[i]);
      }
    for (const Tether<Dim>& t : tethers) {
      const Vec<Dim> r = system.state.position[t.site] - t.anchor;
      out.force[t.site] -= t.stiffness * r;
      energy += 0.5 * t.stiffness * dot(r, r);
    }
    if (detail == Detail::energies) out.energy.external += energy;
  }

  void add_hessian(HessianBlocks<Dim>& blocks) const {
    for (const Tether<Dim>& t : tethers) {
      HessianBlock<Dim> block{t.site, t.site, {}};
      for (int d = 0; d < Dim; ++d) block.h[d][d] = t.stiffness;
      blocks.push_back(block);
    }
  }
};

}  // namespace supple
