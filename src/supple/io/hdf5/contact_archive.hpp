/// Contacts and links and what they remember, in an HDF5 group.
#pragma once
#include "supple/io/hdf5/hdf5.hpp"
#include "supple/model/system.hpp"
#include "supple/model/units.hpp"

namespace supple {

void write_pairs(h5::Group group, const PairTable& pairs, const Units& units);
/// Throws a file error where a pair is of sites that do not exist or columns differ in length.
PairTable read_pairs(const h5::Group& group, int sites);

void write_touches(h5::Group group, const TouchTable& touches, const Units& units);
/// Throws a file error where a contact is of sites or bodies that do not exist, or out of order.
TouchTable read_touches(const h5::Group& group, int sites, int bodies);

void write_links(h5::Group group, const std::vector<Link>& links, const Units& units);
std::vector<Link> read_links(const h5::Group& group, int sites);

}  // namespace supple
