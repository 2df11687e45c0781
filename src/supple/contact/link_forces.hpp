/// Permanent links between bodies of many sites.
#pragma once
#include "supple/contact/interaction.hpp"
#include "supple/contact/laws/table.hpp"
#include "supple/contact/laws/touch.hpp"
#include "supple/contact/touch_frame.hpp"

namespace supple {

/// The forces of System::links: a central spring about the rest distance, a central dashpot, and a tangential
/// spring and dashpot without a limit. The tangential velocity is relative to the rotations of the two
/// boundaries, shared in proportion to the radii (TouchFrame). Elongations follow the motion as in
/// TouchFriction. Linked sites have no other contact (LinkedTouches).
class LinkForces final : public Interaction<2> {
 public:
  explicit LinkForces(const LawTable<LinkLaw>& laws) : laws_(laws) {}

  const LawTable<LinkLaw>& laws() const { return laws_; }
  LossPower loss_power(const System<2>& system) const override { return power_of(lossy_, system); }
  std::unique_ptr<Interaction<2>> clone() const override { return std::make_unique<LinkForces>(*this); }
  void evaluate(const System<2>& system, BodyContacts<2>& contacts, double dt, Detail detail,
                Evaluation<2>& out) override;
  void commit(System<2>& system, Evaluation<2>& evaluation) override;

 private:
  void fill(TouchFrame& frame, const System<2>& system, const Link& link, const Instant& at) const;

  LawTable<LinkLaw> laws_;
  std::vector<LossyTouch> lossy_;   ///< of the last evaluation with energies
  std::vector<std::int32_t> body_;  ///< of each site
  TouchFrame frame_, earlier_;      ///< at present, and at the instant of the velocities
};

}  // namespace supple
