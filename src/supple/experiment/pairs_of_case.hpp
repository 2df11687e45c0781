/// Contacts that differ with the species that meet: what the sections [contact.A.B] of a case say.
#pragma once
#include <cstdint>
#include <vector>

#include "supple/contact/laws/table.hpp"
#include "supple/experiment/case.hpp"
#include "supple/experiment/matter.hpp"

namespace supple {

/// Two species of the case, by their places from 0, and all keys of their contacts: those that are not given
/// are as in [contact] and [material].
struct PairOfSpecies {
  std::int32_t first, second;
  ContactOfSpecies contact;
};
/// The pairs that the case says something of. Input error where a species does not exist.
std::vector<PairOfSpecies> pairs_of(const Case& c);

/// The elastic laws of all contacts of the case.
ContactLaws contact_laws(const Case& c);

/// Names that cannot be, and pairs of species that do not exist.
void check_pairs(const Case& c, Problems& problems);
/// Keys of pairs that have no effect beside others.
void doubt_pairs(const Case& c, Doubts& doubts);

}  // namespace supple
