/// Keys that several experiments use, for their rows.
#pragma once
#include "supple/experiment/used_keys.hpp"

namespace supple {

/// Keys of every experiment on discs, and of every one on deformable particles.
UsedKeys disc_keys();
UsedKeys body_keys();
/// Keys of deformable particles whose energy is minimised.
UsedKeys minimised_keys();
/// Keys of deformable particles in motion.
UsedKeys moving_keys();
/// Keys of deformable particles with friction and links: those of crosslinked discs.
UsedKeys rubbing_keys();

/// Whether the case names a file to start from: what some keys need (Need::met).
bool starts_from_file(const Case& c);

}  // namespace supple
