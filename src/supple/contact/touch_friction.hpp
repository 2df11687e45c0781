/// Friction and viscosity of the contacts of bodies of many sites.
#pragma once
#include <memory>

#include "supple/contact/body_contacts.hpp"
#include "supple/contact/interaction.hpp"
#include "supple/contact/laws/touch.hpp"
#include "supple/contact/touch_frame.hpp"

namespace supple {

/// Acts on every touch (sum_touches) of the contacts of the force field, which add their elastic force F
/// themselves. Along n = F/|F| (-F/|F| where F pulls) there is a dashpot; along t a spring and a dashpot,
/// together up to mu |F|, and nothing where F pulls. The frame of a touch of several records is the mean of
/// theirs, each weighted by its part of F along n.
///
/// The elongation u (System::touches) grows by v.t dt, with v and t about the positions of dt/2 ago, to which
/// the velocities of a leapfrog belong (Instant). A pair that turns rigidly by straight steps, as a leapfrog
/// makes them, then winds up nothing at any length of step.
class TouchFriction final : public Interaction<2> {
 public:
  explicit TouchFriction(const LawTable<TouchLaw>& laws) : laws_(laws) {}
  std::unique_ptr<Interaction<2>> clone() const override { return std::make_unique<TouchFriction>(*this); }

  const LawTable<TouchLaw>& laws() const { return laws_; }
  void evaluate(const System<2>& system, BodyContacts<2>& contacts, double dt, Detail detail,
                Evaluation<2>& out) override;
  LossPower loss_power(const System<2>& system) const override { return power_of(lossy_, system); }
  void commit(System<2>& system, Evaluation<2>& evaluation) override {
    system.touches.rows.swap(evaluation.trial_touch);
  }

 private:
  void act(const System<2>& system, const BodyContacts<2>& contacts, const BodyTouch<2>& touch, double dt,
           Detail detail, Evaluation<2>& out);
  void book_opened(const System<2>& system, const BodyContacts<2>& contacts, double dt,
                   Evaluation<2>& out) const;
  TouchKey key_of(const ContactRecord<2>& record, Meeting meeting) const;
  double scale_of(const System<2>& system, const BodyContacts<2>& contacts, std::int32_t site) const {
    return contacts.scale(ring_of(system.topology, body_[site]));
  }

  LawTable<TouchLaw> laws_;
  std::vector<std::int32_t> body_;  ///< of each site
  std::vector<ContactRecord<2>> records_;
  std::vector<LossyTouch> lossy_;  ///< of the last evaluation with energies
  TouchFrame frame_, earlier_;     ///< at present, and at the instant of the velocities
};

}  // namespace supple
