/// Bodies that bear no force (rattlers): their contacts leave them free to move.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "supple/observe/contact_network.hpp"

namespace supple {

/// What acts on bodies besides their contacts: walls (Evaluation::wall) and weight.
struct OutsideForces {
  std::span<const SiteForce<2>> wall = {};
  Vec2 gravity{};  ///< [length/time^2]
};

/// One number per body, 1: a rattler. With its neighbours held, a rattler has a motion (a translation, and a
/// rotation unless it is one site) that opens all of its contacts at once: it can leave them all, without
/// energy. By Gordan's theorem every other body has contact forces f >= 0, not all zero, that balance on it:
/// sum f_c w_c = 0 with the wrench w_c (force, torque) of a unit push at contact c. So a particle squeezed by
/// two opposite contacts is none, and one with six contacts on one side is. Rattlers are removed with their
/// contacts until none is left. A particle that rests on a floor is held by its weight; one with a site that
/// cannot move is held. A link holds both ways, and so does a contact that attracts.
///
/// Torques enter wrenches divided by the outer radius of the body. A motion of size 1 must open every contact
/// at a rate of at least `least_rate`, because forces balance only to the tolerance of a minimisation.
std::vector<std::uint8_t> find_rattlers(const System<2>& system, const std::vector<SiteContact>& contacts,
                                        const OutsideForces& outside = {}, double least_rate = 1e-3);

}  // namespace supple
