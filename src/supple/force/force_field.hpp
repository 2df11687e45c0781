/// All forces on a system: what is evaluated, in which order, and when the memory of contacts moves on.
#pragma once
#include <optional>

#include "supple/contact/disc_contacts.hpp"
#include "supple/contact/neighbor_list.hpp"
#include "supple/contact/plates.hpp"
#include "supple/force/terms.hpp"

namespace supple {

/// System -> neighbour list (rebuilt when stale) -> terms -> contacts -> plates -> Evaluation. Evaluating changes nothing but
/// the rows of System::pairs; only commit() lets contacts remember.
class ForceField {
 public:
  explicit ForceField(DiscContacts contacts, double relative_skin = default_skin)
      : contacts_(std::move(contacts)), neighbors_(relative_skin) {}

  void evaluate(System<2>& system, Detail detail, Evaluation<2>& out) {
    neighbors_.update(system);
    const auto n = static_cast<std::size_t>(system.state.size());
    out.force.assign(n, Vec2{});
    out.torque.assign(n, 0.0);
    out.wall.clear();
    out.energy = {};
    out.virial = {};
    terms_.evaluate(system, detail, out);
    contacts_.evaluate(system, system.lag, detail, out);
    if (repulsive_plates_) evaluate_plates(system, contacts_.repulsion(), contacts_.law().contact.k, detail, out);
  }

  /// Accepts the step: contacts remember what this evaluation found.
  void commit(System<2>& system, Evaluation<2>& evaluation) {
    system.pairs.state.swap(evaluation.trial_state);
    system.pairs.history.swap(evaluation.trial_history);
    system.lag = 0;
  }

  void invalidate() { neighbors_.invalidate(); }
  void set_repulsive_plates(bool repulsive) { repulsive_plates_ = repulsive; }
  TermSet<2>& terms() { return terms_; }
  DiscContacts& contacts() { return contacts_; }
  const DiscContacts& contacts() const { return contacts_; }
  const NeighborList<2>& neighbors() const { return neighbors_; }

 private:
  TermSet<2> terms_;
  DiscContacts contacts_;
  NeighborList<2> neighbors_;
  bool repulsive_plates_ = false;
};

}  // namespace supple
