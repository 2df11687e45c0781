/// Which bodies touch: contact numbers, and what a rigid packing needs.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "supple/contact/body_contacts.hpp"
#include "supple/model/evaluation.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// All that acts between one site and one other body (sum_touches). Rough contacts and discs: one other site.
struct SiteContact {
  std::int32_t site, other;  ///< the site that acts, and the site of the other body that bears most of it
  std::int32_t body, other_body;
  Vec2 force;  ///< on `site`, along a line through it
  /// The copy of the other body that is met is displaced by this from its unwrapped sites.
  Vec2 shift{};
  bool pulls = false;  ///< the site toward the other body
  bool holds = false;  ///< both ways: it takes energy to open it too

  /// Positive: repulsion.
  double normal_force() const { return pulls ? -norm(force) : norm(force); }
};

/// The contacts of these records under their law, in the order in which they act.
std::vector<SiteContact> site_contacts(const System<2>& system, const std::vector<ContactRecord<2>>& records,
                                       const BodyLaw& law);

/// Mean depth of these contacts: how much nearer a site is to the other body than where they meet, over that
/// distance; 0 without any.
double mean_overlap(const System<2>& system, const std::vector<ContactRecord<2>>& records,
                    const BodyLaw& law);

/// The bodies that touch each other, or a wall. Two bodies that meet through two images, as in a very small
/// cell, are two pairs: each of them has two neighbours.
struct ContactNetwork {
  struct Pair {
    std::int32_t first, second;  ///< bodies, first <= second
    std::int32_t across, up;     ///< cells by which the copy of `second` is displaced along flow and gradient
    std::int32_t site_contacts;
  };
  std::vector<Pair> pairs;          ///< ascending (first, second, across, up)
  std::vector<std::int32_t> walls;  ///< that each body touches

  int bodies() const { return static_cast<int>(walls.size()); }
  /// Bodies and walls that each body touches.
  std::vector<std::int32_t> contacts_of_bodies() const;
};

/// `wall` are the forces of walls (Evaluation::wall).
ContactNetwork contact_network(const System<2>& system, const std::vector<SiteContact>& contacts,
                               std::span<const SiteForce<2>> wall = {});

/// Contact numbers of the bodies that are not left out.
struct ContactNumbers {
  int bodies = 0, pairs = 0, site_contacts = 0, walls = 0;
  /// Contacts of a body in the mean, 2 pairs / bodies; a wall counts once.
  double mean() const { return bodies > 0 ? (2.0 * pairs + walls) / bodies : 0; }
};

/// `left_out`: 1 for bodies that do not count, with their contacts (find_rattlers); empty: all count.
ContactNumbers count_contacts(const ContactNetwork& network, std::span<const std::uint8_t> left_out = {});

/// Degrees of freedom against constraints [Maxwell 1864; MacKeith 2025, section 9.4.3]. A packing under
/// compression that is just rigid has one constraint more than the motions left: one state of self-stress.
struct ConstraintCount {
  int freedoms = 0;      ///< of the bodies that count
  int translations = 0;  ///< of the whole packing that cost nothing: one for each periodic direction
  int shape = 0;         ///< independent constraints by the shape energy
  int contacts = 0;      ///< site contacts, and sites on walls

  /// Contacts of an isostatic packing: 2N - 1 for smooth discs in a periodic cell, 3N - 1 for shells.
  int needed() const { return freedoms - translations - shape + 1; }
  /// Positive: more than enough. Floppy packings are short of N(n - 1) - 1 - contacts, their number of
  /// quartic modes.
  int excess() const { return contacts - needed(); }
};

/// Counts the bodies that are not left out: 3 freedoms of a rigid one, 2 of each free site of the others. The
/// shape energy of a polygon of n sites fixes as many of its 2n - 3 deformations as it has stiff terms (1 for
/// its area, n for its edges), and all of them where corners are stiff or edges have line tension.
ConstraintCount count_constraints(const System<2>& system, const std::vector<SiteContact>& contacts,
                                  std::span<const std::uint8_t> left_out = {},
                                  std::span<const SiteForce<2>> wall = {});

}  // namespace supple
