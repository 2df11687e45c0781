/// Bodies of many sites in an HDF5 group: how sites are grouped, what shape the bodies prefer, which are
/// rigid.
#pragma once
#include <string>

#include "supple/io/hdf5/hdf5.hpp"
#include "supple/model/body_terms.hpp"
#include "supple/model/rigid_bodies.hpp"
#include "supple/model/shape.hpp"
#include "supple/model/solid.hpp"
#include "supple/model/topology.hpp"
#include "supple/model/units.hpp"

namespace supple {

template <int Dim>
void write_topology(h5::Group group, const Topology<Dim>& topology, const Units& units);
/// Throws a file error where bodies, facets and hinges do not fit together or the sites.
template <int Dim>
Topology<Dim> read_topology(const h5::Group& group, int sites);

void write_shape(h5::Group group, const Shape& shape, const Units& units);
void write_body_terms(h5::Group group, const std::vector<BodyTermData>& terms);
/// Throws a file error where there are more rows than bodies.
std::vector<BodyTermData> read_body_terms(const h5::Group& group, int bodies);
/// The species of the bodies in a group of a system. Throws a file error where they are not one for each.
std::vector<std::int32_t> read_species(const h5::Group& group, int bodies);
/// Throws a file error where the preferred shapes do not fit the bodies.
template <int Dim>
Shape read_shape(const h5::Group& group, const Topology<Dim>& topology);

template <int Dim>
void write_solid(h5::Group group, const Solid<Dim>& solid, const Units& units);
/// Throws a file error where bonds and elements do not fit the bodies.
template <int Dim>
Solid<Dim> read_solid(const h5::Group& group, const Topology<Dim>& topology);

template <int Dim>
void write_rigid_bodies(h5::Group group, const RigidBodiesOf<Dim>& rigid, const Units& units);
/// Throws a file error where the rigid bodies do not fit the topology.
template <int Dim>
RigidBodiesOf<Dim> read_rigid_bodies(const h5::Group& group, const Topology<Dim>& topology);

}  // namespace supple
