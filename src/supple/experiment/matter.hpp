/// The kinds of particles that experiments are about, and what a case of each kind must fulfil.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "supple/experiment/held_keys.hpp"
#include "supple/experiment/initial_state.hpp"
#include "supple/experiment/problems.hpp"

namespace supple {

/// What a run starts from: nothing (it makes its particles), or a state.
enum class Start { nothing, state };

/// A kind of particles. Experiments name it in their row; all that depends on the kind stands here.
struct Matter {
  std::string_view name;
  std::vector<std::string_view>
      physics;                        ///< values of the key `physics` for this kind; the first is the default
  bool (*is_held)(const System<2>&);  ///< whether a state holds it
  /// Add problems and doubts about keys of a case that one key alone does not show.
  void (*check)(const Case&, Start, Problems&);
  void (*doubt)(const Case&, Doubts&);
  /// The values of keys that the particles of a state themselves tell.
  HeldKeys (*known)(const InitialState&);
  /// Takes over what a state knows other than by keys.
  void (*adopt)(Case&, const InitialState&);
  /// Number of discs and vertices that a case makes.
  std::int64_t (*sites)(const Case&);
  /// The particles in words, "150 discs, documented model"; the state is null where the case makes them.
  std::string (*describe)(const Case&, const InitialState*);
};

const Matter& disc_matter();
const Matter& body_matter();

/// The kind that the case asks for by `physics` or initial.packing; null where it does not say.
const Matter* asked_matter(const Case& c);

}  // namespace supple
