#include "supple/solve/time_step.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include "supple/core/disjoint_sets.hpp"
#include "supple/core/error.hpp"
#include "supple/solve/degrees.hpp"
#include "supple/solve/eigenvalue_bound.hpp"
#include "supple/solve/kicks.hpp"

namespace supple {

namespace {

/// Squared frequency of a site that six (3D: twelve) further neighbours and a wall press on.
template <int Dim>
double further_contacts(const System<Dim>& system, const ForceField<Dim>& forces) {
  constexpr double neighbours = Dim == 2 ? 6 : 8;  // 2 k/m sum n n^T
  const auto spring_of = [&](double sigma) {
    const auto stiffness = [&](const BodyLaw& law) { return law.stiffness(0.5 * sigma, sigma); };
    double spring = forces.bodies() ? neighbours * forces.bodies()->laws().most(stiffness) : 0;
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

/// Bodies in batches that no block joins, each of about `batch_sites` sites or more: what one needs fits into
/// a fast memory.
template <int Dim>
class Batches {
 public:
  static constexpr int batch_sites = 2048;

  Batches(const System<Dim>& system, HessianBlocks<Dim> joining) : blocks_(std::move(joining)) {
    const int sites = system.state.size(), bodies = system.topology.body_count(sites);
    const std::vector<std::int32_t> body_of_site = bodies_of_sites(system.topology, sites);
    DisjointSets groups(bodies);
    for (const HessianBlock<Dim>& block : blocks_) groups.merge(body_of_site[block.a], body_of_site[block.b]);
    std::vector<std::int32_t> size(static_cast<std::size_t>(bodies)), of_body(size.size());
    for (int b = 0; b < bodies; ++b) size[groups.root(b)] += system.topology.body_size(b);
    int room = 0;
    for (int b = 0; b < bodies; ++b) {
      const std::int32_t root = groups.root(b);
      if (root != b) {
        of_body[b] = of_body[root];
        continue;
      }
      if (room <= 0) ++count_, room = batch_sites;
      of_body[b] = count_ - 1;
      room -= size[b];
    }
    bodies_.resize(of_body.size());
    std::iota(bodies_.begin(), bodies_.end(), 0);
    sort_by_batch(bodies_, first_body_, [&](std::int32_t b) { return of_body[b]; });
    sort_by_batch(blocks_, first_block_,
                  [&](const HessianBlock<Dim>& block) { return of_body[body_of_site[block.a]]; });
  }

  int count() const { return count_; }
  /// Ascending.
  std::span<const std::int32_t> bodies(int batch) const { return part_of(bodies_, first_body_, batch); }
  /// Those that join bodies of the batch, in their order.
  std::span<const HessianBlock<Dim>> blocks(int batch) const { return part_of(blocks_, first_block_, batch); }

 private:
  /// Things of one batch stay in their order.
  template <class Thing, class BatchOf>
  void sort_by_batch(std::vector<Thing>& things, std::vector<std::size_t>& first, const BatchOf& batch_of) {
    first.assign(static_cast<std::size_t>(count_) + 1, 0);
    for (const Thing& thing : things) ++first[batch_of(thing) + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<std::size_t> next(first.begin(), first.end() - 1);
    std::vector<Thing> sorted(things.size());
    for (const Thing& thing : things) sorted[next[batch_of(thing)]++] = thing;
    things.swap(sorted);
  }
  template <class Thing>
  static std::span<const Thing> part_of(const std::vector<Thing>& things,
                                        const std::vector<std::size_t>& first, int batch) {
    return std::span(things).subspan(first[batch], first[batch + 1] - first[batch]);
  }

  int count_ = 0;
  HessianBlocks<Dim> blocks_;
  std::vector<std::int32_t> bodies_;
  std::vector<std::size_t> first_body_, first_block_;
};

/// The mass-weighted Hessian of one batch after the other, in memory that is used again.
template <int Dim>
class WeightedHessian {
 public:
  /// `force` holds the forces on the sites if there are rigid bodies.
  WeightedHessian(const System<Dim>& system, const ForceField<Dim>& forces,
                  const std::vector<Vec<Dim>>& force)
      : system_(system),
        forces_(forces),
        force_(force),
        degrees_(system),
        mass_(degrees_.masses(system)),
        local_(mass_.size(), -1) {}

  /// The bound of the eigenvalues of a batch, or `least`.
  double bound(std::span<const std::int32_t> bodies, std::span<const HessianBlock<Dim>> joining,
               double least) {
    blocks_.clear(), products_.clear(), entries_.clear(), parts_.clear();
    for (const std::int32_t b : bodies) forces_.add_body_hessian(system_, b, blocks_, products_);
    blocks_.insert(blocks_.end(), joining.begin(), joining.end());
    degrees_.add_blocks(system_, blocks_, entries_);
    for (const std::int32_t b : bodies) degrees_.add_turning(system_, b, force_, entries_);
    const int size = number(bodies);
    weigh();
    for (const OuterProduct<Dim>& product : products_) parts_.push_back(part_of(product));
    return bound_.of(entries_, parts_, size, least);
  }

 private:
  /// Numbers what moves in the batch from 0 on, in the order of all numbers. Returns how many these are.
  int number(std::span<const std::int32_t> bodies) {
    int size = 0;
    const auto add = [&](std::int32_t site, int count) {
      const std::int32_t first = degrees_.first_number(site);
      for (int k = 0; k < count && first >= 0; ++k) local_[first + k] = size++;
    };
    for (const std::int32_t b : bodies)
      if (!degrees_.is_rigid(first_site(b)))
        for (std::int32_t i = first_site(b); i < system_.topology.body_end(b); ++i) add(i, Dim);
    for (const std::int32_t b : bodies)
      if (degrees_.is_rigid(first_site(b))) add(first_site(b), 3);
    return size;
  }
  std::int32_t first_site(std::int32_t b) const { return system_.topology.body_begin(b); }

  /// Divides each entry by the root of the masses of its row and column.
  void weigh() {
    double product = 1, root = 1;  // masses are mostly those of the entry before
    for (MatrixEntry& e : entries_) {
      if (const double p = mass_[e.row()] * mass_[e.col()]; p != product) product = p, root = std::sqrt(p);
      e = {local_[e.row()], local_[e.col()], e.value() / root};
    }
  }

  /// The part of an outer product that free sites have, of masses 1.
  OuterPart part_of(const OuterProduct<Dim>& product) const {
    OuterPart part{product.factor, {}, {}};
    part.index.reserve(Dim * product.slope.size());
    part.slope.reserve(Dim * product.slope.size());
    for (std::size_t k = 0; k < product.slope.size(); ++k) {
      const std::int32_t site = product.first + static_cast<std::int32_t>(k);
      const std::int32_t number = degrees_.first_number(site);
      for (int d = 0; d < Dim && number >= 0 && !degrees_.is_rigid(site); ++d) {
        part.index.push_back(local_[number + d]);
        part.slope.push_back(product.slope[k][d] / std::sqrt(mass_[number + d]));
      }
    }
    return part;
  }

  const System<Dim>& system_;
  const ForceField<Dim>& forces_;
  const std::vector<Vec<Dim>>& force_;
  BodyDegrees<Dim> degrees_;
  std::vector<double> mass_;
  std::vector<std::int32_t> local_;  ///< number in the batch of each number
  HessianBlocks<Dim> blocks_;
  OuterProducts<Dim> products_;
  std::vector<MatrixEntry> entries_;
  std::vector<OuterPart> parts_;
  EigenvalueBound bound_;
};

}  // namespace

template <int Dim>
double frequency_bound(System<Dim>& system, ForceField<Dim>& forces) {
  refuse_rigid(system);
  Evaluation<Dim> evaluation;
  if (!system.rigid.body.empty()) forces.evaluate(system, Detail::forces, evaluation);  // they turn bodies
  HessianBlocks<Dim> joining;
  forces.add_joining_hessian(system, joining);
  const Batches<Dim> batches(system, std::move(joining));
  WeightedHessian<Dim> hessian(system, forces, evaluation.force);
  double square = 0;
  for (int k = 0; k < batches.count(); ++k)
    square = hessian.bound(batches.bodies(k), batches.blocks(k), square);
  return std::sqrt(square + further_contacts(system, forces));
}

double leapfrog_limit(double omega, double z) { return 2 / omega * (std::sqrt(1 + 4 * z * z) - 2 * z); }

template <int Dim>
double default_step(System<Dim>& system, ForceField<Dim>& forces, double fraction) {
  const double omega = frequency_bound(system, forces);
  if (!(omega > 0)) throw input_error("no time step follows from the forces", "nothing acts", "give a step");
  return fraction * 2 / omega;
}

template double frequency_bound(System<2>&, ForceField<2>&);
template double frequency_bound(System<3>&, ForceField<3>&);
template double default_step(System<2>&, ForceField<2>&, double);
template double default_step(System<3>&, ForceField<3>&, double);

}  // namespace supple
