/// Which bodies touch: contact numbers, and what a rigid packing needs.
#pragma once
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "supple/contact/body_contacts.hpp"
#include "supple/model/evaluation.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// One contact: all that acts between a site and another body (sum_touches); of rough contacts and discs,
/// between two sites.
template <int Dim>
struct SiteContact {
  std::int32_t site, other;  ///< the site that acts, and the site of the other body that bears most of it
  std::int32_t body, other_body;
  Vec<Dim> force;  ///< on `site`, along a line through it
  /// Displacement from the unwrapped sites of the other body to the copy that is met [length].
  Vec<Dim> shift{};
  bool pulls = false;  ///< the site toward the other body
  bool holds = false;  ///< both ways: it takes energy to open it too

  /// Positive: repulsion.
  double normal_force() const { return pulls ? -norm(force) : norm(force); }
};

/// The contacts that these records make under these laws, in the order of the records.
template <int Dim>
std::vector<SiteContact<Dim>> site_contacts(const System<Dim>& system,
                                            const std::vector<ContactRecord<Dim>>& records,
                                            const ContactLaws& laws);

/// Mean relative overlap of the contacts of these records: (reach - distance)/reach, of a contact of several
/// records the largest. 0 without contacts.
template <int Dim>
double mean_overlap(const System<Dim>& system, const std::vector<ContactRecord<Dim>>& records,
                    const ContactLaws& laws);

/// Which bodies touch each other or a wall. Two bodies that touch through two images, as in a very small
/// cell, are two pairs.
struct ContactNetwork {
  struct Pair {
    std::int32_t first, second;  ///< bodies, first <= second
    /// Cells by which the copy of `second` is displaced along flow, gradient and, in 3D, vorticity.
    std::int32_t across, up, along;
    std::int32_t site_contacts;
  };
  std::vector<Pair> pairs;          ///< ascending (first, second, across, up, along)
  std::vector<std::int32_t> walls;  ///< number of walls that each body touches

  int bodies() const { return static_cast<int>(walls.size()); }
  /// Bodies and walls that each body touches.
  std::vector<std::int32_t> contacts_of_bodies() const;
};

/// The network of these contacts; `wall` holds the forces of walls (Evaluation::wall).
template <int Dim>
ContactNetwork contact_network(const System<Dim>& system, const std::vector<SiteContact<Dim>>& contacts,
                               std::type_identity_t<std::span<const SiteForce<Dim>>> wall = {});

/// Contact numbers of the bodies that are not left out.
struct ContactNumbers {
  int bodies = 0, pairs = 0, site_contacts = 0, walls = 0;
  /// Mean number of bodies and walls that a body touches, (2 pairs + walls) / bodies.
  double mean() const { return bodies > 0 ? (2.0 * pairs + walls) / bodies : 0; }
};

/// `left_out` is 1 for each body that does not count, nor do its contacts (find_rattlers); empty: all count.
ContactNumbers count_contacts(const ContactNetwork& network, std::span<const std::uint8_t> left_out = {});

/// Degrees of freedom and constraints [Maxwell 1864; MacKeith 2025, section 9.4.3]. A compressed packing that
/// is just rigid (isostatic) has one constraint more than degrees of freedom that are not translations: one
/// state of self-stress.
struct ConstraintCount {
  int freedoms = 0;      ///< of the bodies that count
  int translations = 0;  ///< of the whole packing, free of energy: one for each periodic direction
  int shape = 0;         ///< independent constraints that the shape energy makes
  int contacts = 0;      ///< site contacts, and sites on walls

  /// Contacts of an isostatic packing: in a periodic cell 2N - 1 for N smooth discs, 3N - 1 for N shells; in
  /// 3D 3N - 2 for N smooth spheres, 6N - 2 for N shells or rigid surfaces.
  int needed() const { return freedoms - translations - shape + 1; }
  /// Contacts beyond isostatic. Packings of N floppy polygons of n sites lack N(n - 1) - 1 - contacts, which
  /// is their number of quartic modes.
  int excess() const { return contacts - needed(); }
};

/// Counts over the bodies that are not left out. A rigid body has 3 degrees of freedom (3D: 6), each free
/// site of another one has 2 (3D: 3). The shape energy of a polygon (surface) of n sites constrains as many
/// of its 2n - 3 (3n - 6) deformations as it has stiff terms (1 for its area or volume, one for each of its
/// edges or triangles), and all of them where hinges are stiff or facets have tension.
template <int Dim>
ConstraintCount count_constraints(const System<Dim>& system, const std::vector<SiteContact<Dim>>& contacts,
                                  std::span<const std::uint8_t> left_out = {},
                                  std::type_identity_t<std::span<const SiteForce<Dim>>> wall = {});

}  // namespace supple
