/// Conservative contacts between bodies of many sites: what every kind of boundary offers.
#pragma once
#include <vector>

#include "supple/contact/laws/harmonic.hpp"
#include "supple/contact/neighbor_list.hpp"
#include "supple/contact/record.hpp"
#include "supple/model/evaluation.hpp"
#include "supple/model/hessian.hpp"

namespace supple {

/// A fast loop, and the general records that it must agree with. The pair table must be up to date (NeighborList::update with
/// meeting()).
class BodyContacts {
 public:
  explicit BodyContacts(const Harmonic& law) : law_(law) {}
  virtual ~BodyContacts() = default;

  const Harmonic& law() const { return law_; }
  /// What the neighbour list must find for these contacts.
  virtual Meeting meeting() const = 0;
  /// Adds forces and, with Detail::energies, energy.elastic and the virial.
  virtual void evaluate(const System<2>& system, Detail detail, Evaluation<2>& out) = 0;
  /// Every contact as a record, in the order in which they act.
  virtual std::vector<ContactRecord<2>> records(const System<2>& system) = 0;
  /// Adds second derivatives.
  virtual void add_hessian(const System<2>& system, HessianBlocks<2>& blocks);
  /// Sites that the last evaluation found inside another body.
  virtual const std::vector<std::int32_t>& sites_inside() const;

 private:
  Harmonic law_;
};

/// Adds forces, energy.elastic and the virial of records under a law without memory: the reference path.
void evaluate_conservative(const std::vector<ContactRecord<2>>& records, const Harmonic& law, Evaluation<2>& out);

}  // namespace supple
