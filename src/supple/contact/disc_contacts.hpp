/// The fast loop over disc-disc contacts in 2D: pair table in, forces, torques and trial history out.
#pragma once
#include <algorithm>
#include <variant>

#include "supple/contact/laws/list.hpp"
#include "supple/contact/pushes.hpp"
#include "supple/model/evaluation.hpp"
#include "supple/model/loss_power.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// The law of microgel discs with its repulsion, on every row of the pair table.
class DiscContacts {
 public:
  DiscContacts() = default;
  DiscContacts(Repulsion repulsion, DiscLaw law) : repulsion_(std::move(repulsion)), law_(law) {}

  const DiscLaw& law() const { return law_; }
  const Repulsion& repulsion() const { return repulsion_; }
  void set_friction(double coefficient) { law_.friction = coefficient; }

  /// Adds forces and torques of all contacts to `out`, and fills its pair rows and trial history. Elongations
  /// advance as if the present velocities had acted for dt [time]; 0 leaves them as they are.
  void evaluate(const System<2>& system, double dt, Detail detail, Evaluation<2>& out);

  /// Of the forces that the last evaluation with energies found, at the velocities and the shear rate of now.
  LossPower loss_power(const System<2>& system, const Evaluation<2>& evaluation) const;

 private:
  /// The forces along contacts by which they lose energy.
  struct LossyTangential {
    double dashpot, sliding;
  };
  /// The force on the first disc of a row, and the torque on each over its radius.
  struct Push {
    std::int32_t first, second;
    Vec2 force;
    double twist;
  };
  void keep_lossy(const Evaluation<2>& evaluation);
  template <class R>
  void fill_rows(const R& repulsion, const System<2>& system, double dt, Detail detail, Evaluation<2>& out);

  Repulsion repulsion_;
  DiscLaw law_;
  Pushes<Push> pushes_;                 ///< with several threads
  std::vector<LossyTangential> lossy_;  ///< of each row, from the last evaluation with energies
};

}  // namespace supple
