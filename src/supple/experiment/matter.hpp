/// The kinds of particles that experiments are about, and what a case of each kind must fulfil.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "supple/experiment/held_keys.hpp"
#include "supple/experiment/initial_state.hpp"
#include "supple/experiment/problems.hpp"

namespace supple {

struct SuspensionModel;

/// What a run starts from: particles that it makes, or those of a state.
enum class Start { nothing, state };

/// A kind of particles. Experiments name it in their row; all that depends on the kind stands here.
struct Matter {
  std::string_view name;
  std::string_view physics;                     ///< value of the key `physics` that means it
  const SuspensionModel* suspension = nullptr;  ///< of discs: how they are made and moved
  bool (*is_held)(const AnySystem&);            ///< whether a state holds it
  /// What one key of a case cannot know of another.
  void (*check)(const Case&, Start, Problems&);
  void (*doubt)(const Case&, Doubts&);
  /// The values of keys that the particles of a state themselves tell.
  HeldKeys (*known)(const InitialState&);
  /// Takes over what a state knows other than by keys.
  void (*adopt)(Case&, const InitialState&);
  /// The shear stresses that a figure shows, if the run has them: name of the column, and name in the legend.
  std::vector<std::pair<std::string_view, std::string_view>> curves = {};
  /// Discs and vertices that a case makes.
  std::int64_t (*sites)(const Case&);
  /// The particles in words, "150 discs, documented model"; the state is null where the case makes them.
  std::string (*describe)(const Case&, const InitialState*);
};

const Matter& disc_matter();
const Matter& body_matter();
/// All kinds of particles that experiments are about.
std::vector<const Matter*> every_matter();

/// The kind that the case asks for by `physics` or initial.packing; null where it does not say.
const Matter* asked_matter(const Case& c);

}  // namespace supple
