#include "supple/solve/time_step.hpp"

#include <algorithm>
#include <cmath>

#include "supple/core/error.hpp"
#include "supple/model/outer_product.hpp"
#include "supple/solve/degrees.hpp"
#include "supple/solve/eigenvalue_bound.hpp"

namespace supple {

namespace {

/// The part of an outer product that free sites have, of masses 1.
OuterPart part_of(const OuterProduct<2>& product, const std::vector<std::int32_t>& number_of_site,
                  const std::vector<double>& mass) {
  OuterPart part{product.factor, {}, {}};
  for (std::size_t k = 0; k < product.slope.size(); ++k) {
    const std::int32_t number = number_of_site[product.first + static_cast<std::int32_t>(k)];
    for (int d = 0; d < 2 && number >= 0; ++d) {
      part.index.push_back(number + d);
      part.slope.push_back(product.slope[k][d] / std::sqrt(mass[number + d]));
    }
  }
  return part;
}

/// Squared frequency of a site that six further neighbours and a wall press on.
double further_contacts(const System<2>& system, const ForceField& forces) {
  const auto spring_of = [&](double sigma) {
    const auto stiffness = [&](const BodyLaw& law) { return law.stiffness(0.5 * sigma, sigma); };
    double spring = forces.bodies() ? 6 * forces.bodies()->laws().most(stiffness) : 0;
    if (const auto& walls = forces.walls())
      spring += walls->repulsion.spring(sigma) *
                std::max(1.0, walls->floor_friction > 0 ? walls->floor_stiffness : 0);
    return spring;
  };
  const std::vector<double>& radius = system.state.radius;
  double largest = 0, spring = 0;
  for (std::size_t i = 0; i < radius.size(); ++i) {
    if (i == 0 || radius[i] != radius[i - 1]) spring = spring_of(2 * radius[i]);
    largest = std::max(largest, spring / system.state.mass[i]);
  }
  return largest;
}

/// Divides each entry by the root of the masses of its row and column.
void weigh(std::vector<MatrixEntry>& entries, const std::vector<double>& mass) {
  double product = 1, root = 1;  // masses are mostly those of the entry before
  for (MatrixEntry& e : entries) {
    if (const double p = mass[e.row()] * mass[e.col()]; p != product) product = p, root = std::sqrt(p);
    e = {e.row(), e.col(), e.value() / root};
  }
}

}  // namespace

double frequency_bound(System<2>& system, ForceField& forces) {
  const BodyDegrees degrees(system);
  Evaluation<2> evaluation;
  forces.evaluate(system, Detail::forces, evaluation);
  HessianBlocks<2> blocks;
  blocks.reserve(3 * static_cast<std::size_t>(system.state.size()));
  OuterProducts<2> products;
  forces.add_split_hessian(system, blocks, products);
  std::vector<MatrixEntry> entries = degrees.hessian(system, blocks, evaluation.force);
  const std::vector<double> mass = degrees.masses(system);
  weigh(entries, mass);
  std::vector<std::int32_t> number_of_site(static_cast<std::size_t>(system.state.size()), -1);
  for (int k = 0; k < degrees.site_count(); ++k) number_of_site[degrees.sites()[k]] = 2 * k;
  std::vector<OuterPart> parts;
  for (const OuterProduct<2>& product : products) parts.push_back(part_of(product, number_of_site, mass));
  return std::sqrt(eigenvalue_bound(entries, parts, degrees.size()) + further_contacts(system, forces));
}

double default_step(System<2>& system, ForceField& forces, double fraction) {
  const double omega = frequency_bound(system, forces);
  if (!(omega > 0)) throw input_error("no time step follows from the forces", "nothing acts", "give a step");
  return fraction * 2 / omega;
}

}  // namespace supple
