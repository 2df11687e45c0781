/// Conservative contacts between bodies of many sites: what every kind of boundary offers.
#pragma once
#include <vector>

#include "supple/contact/laws/body.hpp"
#include "supple/contact/neighbor_list.hpp"
#include "supple/contact/record.hpp"
#include "supple/model/evaluation.hpp"
#include "supple/model/hessian.hpp"
#include "supple/model/ring.hpp"

namespace supple {

/// What one site feels from one body: a contact, whatever it is made of.
struct BodyTouch {
  std::int32_t site;  ///< the one of positive weight
  std::int32_t body;  ///< the other one
  Vec2 force{};       ///< on the site [force]
  double energy = 0;
  Vec2 outward{};  ///< sum of the normals, each as often as it counts: away from the body
  std::int32_t first_record = 0, records = 0;  ///< those that were summed

  /// Positive: repulsion.
  double normal_force() const { return dot(force, outward) < 0 ? -norm(force) : norm(force); }
};

/// A fast loop, and the general records that it must agree with. The pair table must be up to date
/// (NeighborList::update with meeting()).
class BodyContacts {
 public:
  explicit BodyContacts(const BodyLaw& law) : law_(law) {}
  virtual ~BodyContacts() = default;

  const BodyLaw& law() const { return law_; }
  /// Of the same range, which the neighbour list knows.
  void set_law(const BodyLaw& law) { law_ = law; }
  /// What the neighbour list must find for these contacts.
  virtual Meeting meeting() const = 0;
  /// Factor on the law's energy and force for contacts of a site of such a body.
  virtual double scale(const Ring&) const { return 1; }
  /// Adds forces and, with Detail::energies, energy.elastic and the virial.
  virtual void evaluate(const System<2>& system, Detail detail, Evaluation<2>& out) = 0;
  /// Every contact as a record, in the order in which they act.
  virtual std::vector<ContactRecord<2>> records(const System<2>& system) = 0;
  /// Adds second derivatives.
  virtual void add_hessian(const System<2>& system, HessianBlocks<2>& blocks);
  /// Vertices that the last evaluation found near a part of a body that is no simple arc; rough contacts have
  /// none.
  virtual int feature_violations() const { return 0; }

 private:
  BodyLaw law_;
};

/// Sums the records of each contact. Rough contacts of vertices and smooth ones of a vertex with a boundary
/// are one touch each.
std::vector<BodyTouch> sum_touches(const System<2>& system, const std::vector<ContactRecord<2>>& records,
                                   const BodyLaw& law);

/// Adds forces, energy.elastic and the virial of records under a law without memory: the reference path.
void evaluate_conservative(const std::vector<ContactRecord<2>>& records, const BodyLaw& law,
                           Evaluation<2>& out);

}  // namespace supple
