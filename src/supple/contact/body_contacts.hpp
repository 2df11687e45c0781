/// Conservative contacts between bodies of many sites: the interface of every kind of boundary.
#pragma once
#include <memory>
#include <vector>

#include "supple/contact/laws/table.hpp"
#include "supple/contact/neighbor_list.hpp"
#include "supple/contact/record.hpp"
#include "supple/model/evaluation.hpp"
#include "supple/model/hessian.hpp"
#include "supple/model/ring.hpp"

namespace supple {

/// One contact of a site with another body (rough: with one site of that body), the sum of its records.
template <int Dim>
struct BodyTouch {
  std::int32_t site;  ///< that of positive weight in the records
  std::int32_t body;  ///< the other body
  Vec<Dim> force{};   ///< on the site [force]
  double energy = 0;
  Vec<Dim> outward{};  ///< sum of multiplicity times normal over the records: away from the body
  std::int32_t first_record = 0, records = 0;  ///< its records, one after the other

  /// Size of the force, positive for repulsion and negative for attraction [force].
  double normal_force() const { return dot(force, outward) < 0 ? -norm(force) : norm(force); }
};

/// Contacts of one kind, twice: evaluate() is a fast loop, records() the general form, and both give the same
/// forces. The pair table must be up to date (NeighborList::update with meeting()).
template <int Dim>
class BodyContacts {
 public:
  explicit BodyContacts(const ContactLaws& laws) : laws_(laws), range_(widest_range(laws)) {}
  virtual ~BodyContacts() = default;
  virtual std::unique_ptr<BodyContacts> clone() const = 0;

  const ContactLaws& laws() const { return laws_; }
  /// Replaces the laws by others of the same ranges, which the neighbour list relies on.
  void set_laws(const ContactLaws& laws) { laws_ = laws; }
  /// How far contacts reach (widest_range).
  double range() const { return range_; }
  /// What the neighbour list must look for: sites, or sites and facets.
  virtual Meeting meeting() const = 0;
  /// Factor on the law's energy and force for contacts of a site on this ring.
  virtual double scale(const Ring&) const { return 1; }
  /// Adds forces and, with Detail::energies, energy.elastic and the virial.
  virtual void evaluate(const System<Dim>& system, Detail detail, Evaluation<Dim>& out) = 0;
  /// Every contact as a record, in the order in which they act.
  virtual std::vector<ContactRecord<Dim>> records(const System<Dim>& system) = 0;
  /// Adds the second derivatives of the energy.
  virtual void add_hessian(const System<Dim>& system, HessianBlocks<Dim>& blocks);
  /// Number of vertices that the last evaluation found near a part of a boundary that is no single arc
  /// (SmoothContacts); 0 for rough contacts.
  virtual int feature_violations() const { return 0; }

 protected:
  /// Makes the species of the sites known to what follows.
  void update_species(const System<Dim>& system);
  /// Of the bodies of two sites.
  std::array<std::int32_t, 2> species_of(std::int32_t i, std::int32_t j) const {
    return species_.empty() ? std::array<std::int32_t, 2>{} : std::array{species_[i], species_[j]};
  }
  const BodyLaw& law_of(std::int32_t i, std::int32_t j) const { return laws_.of(species_of(i, j)); }
  /// The law of each pair of sites, looked up.
  struct EachPair {
    const BodyContacts& contacts;
    const BodyLaw& of(std::int32_t i, std::int32_t j) const { return contacts.law_of(i, j); }
  };
  /// Calls visitor(laws): laws.of(i, j) is the law of the contacts of two sites. Where one law holds for all
  /// it has its own type there.
  template <class Visit>
  void visit_laws(const Visit& visitor) const {
    if (!laws_.is_uniform()) return visitor(EachPair{*this});
    laws_.common().visit([&](const auto& law) { visitor(OneForAll<std::decay_t<decltype(law)>>{law}); });
  }

 private:
  template <class Law>
  struct OneForAll {
    Law law;
    const Law& of(std::int32_t, std::int32_t) const { return law; }
  };

  ContactLaws laws_;
  double range_;
  std::vector<std::int32_t> species_;  ///< of each site; empty: all are of the first
};

/// Sums the records of each contact. A rough contact of two vertices is one touch, and so is a smooth one of
/// a vertex with a boundary.
template <int Dim>
std::vector<BodyTouch<Dim>> sum_touches(const System<Dim>& system,
                                        const std::vector<ContactRecord<Dim>>& records,
                                        const ContactLaws& laws);

/// Adds forces, energy.elastic and the virial of the records: the reference for every evaluate().
template <int Dim>
void evaluate_conservative(const std::vector<ContactRecord<Dim>>& records, const ContactLaws& laws,
                           Evaluation<Dim>& out);

}  // namespace supple
