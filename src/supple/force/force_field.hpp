/// All forces on a system: in which order they are evaluated, and when contacts remember.
#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "supple/contact/body_contacts.hpp"
#include "supple/contact/disc_contacts.hpp"
#include "supple/contact/interaction.hpp"
#include "supple/contact/neighbor_list.hpp"
#include "supple/contact/plates.hpp"
#include "supple/contact/walls.hpp"
#include "supple/core/owned.hpp"
#include "supple/force/external.hpp"
#include "supple/force/terms.hpp"
#include "supple/model/rigid.hpp"

namespace supple {

/// evaluate() brings the neighbour list up to date and then adds, in this order, terms, contacts,
/// interactions, plates, walls and external forces. It changes nothing but the rows of System::pairs; only
/// commit() lets contacts remember. Microgel discs, of 2D alone, have DiscContacts, bodies of many sites
/// BodyContacts. A
/// value: a copy has its own contacts and interactions, and may act on another system in another thread.
template <int Dim>
class ForceField {
 public:
  explicit ForceField(DiscContacts contacts, double relative_skin = default_skin) requires(Dim == 2)
      : contacts_(std::move(contacts)),
        neighbors_(relative_skin, Meeting::sites, range_of(contacts_.repulsion())) {}
  explicit ForceField(const BodyContacts<Dim>& contacts, double relative_skin = default_skin)
      : bodies_(contacts.clone()), neighbors_(relative_skin, bodies_->meeting(), bodies_->range()) {}

  void evaluate(System<Dim>& system, Detail detail, Evaluation<Dim>& out) {
    neighbors_.update(system);
    const auto n = static_cast<std::size_t>(system.state.size());
    out.force.assign(n, Vec<Dim>{});
    if (!bodies_ || !interactions_.empty() || out.torque.size() != n)
      out.torque.assign(n, Angular<Dim>{});  // conservative contacts of bodies make no torques
    out.wall.clear();
    out.energy = {};
    out.virial = {};
    terms_.evaluate(system, detail, out);
    if (bodies_) bodies_->evaluate(system, detail, out);
    if constexpr (Dim == 2)
      if (!bodies_) contacts_.evaluate(system, system.lag, detail, out);
    for (const auto& interaction : interactions_)
      interaction->evaluate(system, *bodies_, system.lag, detail, out);
    if constexpr (Dim == 2)
      if (repulsive_plates_)
        evaluate_plates(system, contacts_.repulsion(), contacts_.law().contact.k, detail, out);
    if (walls_) evaluate_walls(system, *walls_, detail, out);
    if (!external_.empty()) external_.evaluate(system, detail, out);
    if (detail == Detail::energies) out.virial += rigid_virial(system, out.force);
  }

  /// Adds the second derivatives of the energy. Not for contacts with memory: their forces have no energy.
  void add_hessian(System<Dim>& system, HessianBlocks<Dim>& blocks, HessianKind kind = HessianKind::exact);

  /// The same in portions: what may join bodies, contacts among it, and what acts outside bodies,
  void add_joining_hessian(System<Dim>& system, HessianBlocks<Dim>& blocks);
  /// and what acts in body b alone, where parts that couple all of its sites are outer products: the Hessian
  /// is the sum of `blocks` and `products`.
  void add_body_hessian(const System<Dim>& system, int b, HessianBlocks<Dim>& blocks,
                        OuterProducts<Dim>& products) const {
    terms_.add_body_hessian(system, b, blocks, products);
  }

  /// Of the forces that the last evaluation, with energies, found, at the velocities and the shear rate of
  /// now.
  LossPower loss_power(const System<Dim>& system, const Evaluation<Dim>& evaluation) const {
    LossPower sum;
    if constexpr (Dim == 2)
      if (!bodies_) sum += contacts_.loss_power(system, evaluation);
    for (const auto& interaction : interactions_) sum += interaction->loss_power(system);
    return sum;
  }

  /// Whether forces depend on velocities.
  bool has_dashpots() const { return !bodies_ || !interactions_.empty(); }

  /// Accepts the step: contacts remember what `evaluation`, made at this state, found.
  void commit(System<Dim>& system, Evaluation<Dim>& evaluation) {
    system.floor_contact.swap(evaluation.trial_floor_contact);
    if (!bodies_) {
      system.pairs.state.swap(evaluation.trial_state);
      system.pairs.history.swap(evaluation.trial_history);
    }
    for (const auto& interaction : interactions_) interaction->commit(system, evaluation);
    system.lag = 0;
  }

  /// Adds forces that are evaluated after the contacts, in the order of these calls. Input error for microgel
  /// discs.
  void add(const Interaction<Dim>& interaction);
  const std::vector<Owned<Interaction<Dim>>>& interactions() const { return interactions_; }

  void invalidate() { neighbors_.invalidate(); }
  void set_repulsive_plates(bool repulsive) { repulsive_plates_ = repulsive; }
  void set_walls(const WallLaw<Dim>& walls) { walls_ = walls; }
  const std::optional<WallLaw<Dim>>& walls() const { return walls_; }
  TermSet<Dim>& terms() { return terms_; }
  ExternalForces<Dim>& external() { return external_; }
  DiscContacts& contacts() { return contacts_; }
  const DiscContacts& contacts() const { return contacts_; }
  /// The contacts of bodies of many sites; null for microgel discs.
  BodyContacts<Dim>* bodies() const { return bodies_.get(); }
  const NeighborList<Dim>& neighbors() const { return neighbors_; }

 private:
  void begin_hessian(System<Dim>& system);
  void finish_hessian(System<Dim>& system, HessianBlocks<Dim>& blocks);  ///< adds those of all but the terms

  TermSet<Dim> terms_;
  ExternalForces<Dim> external_;
  DiscContacts contacts_;
  Owned<BodyContacts<Dim>> bodies_;
  std::vector<Owned<Interaction<Dim>>> interactions_;
  NeighborList<Dim> neighbors_;
  std::optional<WallLaw<Dim>> walls_;
  bool repulsive_plates_ = false;
};

}  // namespace supple
