/// What contacts and links of bodies remember, in an HDF5 group.
#pragma once
#include <vector>

#include "supple/io/hdf5/hdf5.hpp"
#include "supple/model/system.hpp"

namespace supple {

void write_touches(h5::Group group, const TouchTable& touches);
/// Throws a file error where a contact is of sites or bodies that do not exist, or out of order.
TouchTable read_touches(const h5::Group& group, int sites, int bodies);

void write_links(h5::Group group, const std::vector<Link>& links);
std::vector<Link> read_links(const h5::Group& group, int sites);

}  // namespace supple
