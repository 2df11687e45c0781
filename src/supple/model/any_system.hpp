/// Systems whose dimension a file decides.
#pragma once
#include <variant>

#include "supple/model/evaluation.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// A system in two dimensions or in three, and the forces of one.
using AnySystem = std::variant<System<2>, System<3>>;
using AnyEvaluation = std::variant<Evaluation<2>, Evaluation<3>>;

/// 2 or 3.
inline int dimensions_of(const AnySystem& any) { return any.index() == 0 ? 2 : 3; }

/// Discs, spheres and vertices of a system.
inline int site_count(const AnySystem& any) {
  return std::visit([](const auto& system) { return system.state.size(); }, any);
}

/// Whether sites are grouped into bodies; they are discs of microgels otherwise.
inline bool has_bodies(const AnySystem& any) {
  return std::visit([](const auto& system) { return !system.topology.begin.empty(); }, any);
}

/// Bodies of a system; each site of a suspension of discs is one.
inline int body_count(const AnySystem& any) {
  return std::visit([](const auto& system) { return system.topology.body_count(system.state.size()); }, any);
}

}  // namespace supple
