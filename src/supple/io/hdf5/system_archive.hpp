/// A system in an HDF5 group, bit for bit, with the names and units of model/quantities.hpp.
#pragma once
#include "supple/io/hdf5/hdf5.hpp"
#include "supple/model/evaluation.hpp"
#include "supple/model/system.hpp"
#include "supple/model/units.hpp"

namespace supple {

/// Writes box, sites, topology, preferred shapes, rigid bodies, pairs, contacts and links with their memory,
/// time, lag and step. Parts that only some systems have are left out where they are empty.
template <int Dim>
void write_system(h5::Group& group, const System<Dim>& system, const Units& units);
/// Throws a file error where arrays are missing or do not fit together.
template <int Dim>
System<Dim> read_system(const h5::Group& group);

/// Writes forces, torques, energies and virial, but not the forces of pairs, which follow from the system.
template <int Dim>
void write_evaluation(h5::Group& group, const Evaluation<Dim>& evaluation, const Units& units);
template <int Dim>
Evaluation<Dim> read_evaluation(const h5::Group& group);

}  // namespace supple
