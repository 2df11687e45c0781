/// Keys that several experiments use, for their rows.
#pragma once
#include "supple/experiment/used_keys.hpp"

namespace supple {

/// Of every experiment on discs, and on deformable particles.
UsedKeys disc_keys();
UsedKeys body_keys();
/// Of deformable particles whose energy is minimised.
UsedKeys minimised_keys();
/// Of deformable particles in motion.
UsedKeys moving_keys();
/// Of deformable particles that rub and are linked: the keys of crosslinked discs.
UsedKeys rubbing_keys();

/// Needs of keys that follow from how a run begins: whether the case names a file to start from.
bool starts_from_file(const Case& c);

}  // namespace supple
