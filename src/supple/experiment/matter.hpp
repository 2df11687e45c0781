/// The kinds of particles that experiments are about, and what a case of each has to be.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "supple/experiment/held_keys.hpp"
#include "supple/experiment/initial_state.hpp"
#include "supple/experiment/problems.hpp"

namespace supple {

/// What a run starts from: particles that it makes, or those of a state.
enum class Start { nothing, state };

/// One kind. Experiments name it in their row; whatever depends on the kind is here.
struct Matter {
  std::string_view name;
  std::vector<std::string_view>
      physics;                        ///< values of the key `physics` that mean it; the first unless given
  bool (*is_held)(const System<2>&);  ///< whether a state holds it
  /// What one key of a case cannot know of another.
  void (*check)(const Case&, Start, Problems&);
  void (*doubt)(const Case&, Doubts&);
  /// Keys that follow from the particles of a state.
  HeldKeys (*known)(const InitialState&);
  /// Takes over what a state says that stands in no key of its own.
  void (*adopt)(Case&, const InitialState&);
  /// Discs and vertices that a case makes.
  std::int64_t (*sites)(const Case&);
  /// "150 discs, documented model"; the state is null where the case makes the particles.
  std::string (*describe)(const Case&, const InitialState*);
};

const Matter& disc_matter();
const Matter& body_matter();

/// The kind that the case asks for by its `physics` or a packing; null where it does not say.
const Matter* asked_matter(const Case& c);

}  // namespace supple
