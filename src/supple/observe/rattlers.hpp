/// Bodies that bear no force (rattlers): their contacts leave them free to move.
#pragma once
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "supple/observe/contact_network.hpp"

namespace supple {

/// What acts on bodies besides their contacts: walls (Evaluation::wall) and weight.
template <int Dim>
struct OutsideForces {
  std::span<const SiteForce<Dim>> wall = {};
  Vec<Dim> gravity{};  ///< [length/time^2]
};

/// One number for each body, 1 where it is a rattler. While its neighbours are held, a rattler has a motion
/// (a translation, with a rotation unless it is one site) that opens all of its contacts at once, so that it
/// can leave them without energy. By Gordan's theorem every other body has contact forces f_c >= 0, not all
/// zero, that balance on it: sum f_c w_c = 0, w_c being the wrench (force, torque) of a unit push at contact
/// c. So a particle squeezed by two opposite contacts is no rattler, and one with six contacts on one side
/// is. Rattlers are removed with their contacts until none is left. Weight holds a particle that rests on a
/// floor; a particle with a site that cannot move is held; a link, and a contact that attracts, push and
/// pull.
///
/// Torques enter wrenches divided by the outer radius of the body. A motion of size 1 must open every contact
/// at a rate of at least `least_rate`, because forces balance only to the tolerance of a minimisation.
template <int Dim>
std::vector<std::uint8_t> find_rattlers(const System<Dim>& system,
                                        const std::vector<SiteContact<Dim>>& contacts,
                                        const std::type_identity_t<OutsideForces<Dim>>& outside = {},
                                        double least_rate = 1e-3);

}  // namespace supple
