#include "supple/io/hdf5/system_archive.hpp"

#include "supple/io/hdf5/body_archive.hpp"
#include "supple/io/hdf5/contact_archive.hpp"
#include "supple/io/hdf5/elements.hpp"

namespace supple {

template <int Dim>
void write_system(h5::Group& group, const System<Dim>& system, const Units& units) {
  write_all(group, system, units);
  h5::Group box = group.create_group("box"), sites = group.create_group("sites");
  write_all(box, system.box, units);
  write_all(sites, system.state, units);
  if (!system.floor_contact.empty()) write(sites, meaning_of_floor, system.floor_contact, units);
  if (system.knows_acceleration()) {
    h5::Group acceleration = group.create_group("acceleration");
    write_all(acceleration, system.acceleration, units);
  }
  write_topology(group.create_group("topology"), system.topology, units);
  if (!system.shape.empty()) write_shape(group.create_group("shape"), system.shape, units);
  if (!system.solid.empty()) write_solid(group.create_group("solid"), system.solid, units);
  if (!system.terms.empty()) write_body_terms(group.create_group("terms"), system.terms);
  if (!system.species.empty()) write(group, meaning_of_species, system.species, units);
  if (!system.rigid.empty()) write_rigid_bodies(group.create_group("rigid"), system.rigid, units);
  write_pairs(group.create_group("pairs"), system.pairs, units);
  if (!system.touches.rows.empty()) write_touches(group.create_group("touches"), system.touches, units);
  if (!system.links.empty()) write_links(group.create_group("links"), system.links, units);
}

template <int Dim>
System<Dim> read_system(const h5::Group& group) {
  System<Dim> system;
  read_all(group, system);
  read_all(group.open_group("box"), system.box);
  const h5::Group in_sites = group.open_group("sites");
  read_all(in_sites, system.state);
  if (in_sites.has(meaning_of_floor.name)) read(in_sites, meaning_of_floor.name, system.floor_contact);
  const int sites = system.state.size();
  const auto count = static_cast<std::size_t>(sites);
  expect_sound(
      all_have(system.state, count) && (system.floor_contact.empty() || system.floor_contact.size() == count),
      in_sites, "arrays of the sites differ in length");

  system.topology = read_topology<Dim>(group.open_group("topology"), sites);
  if (group.has("shape")) system.shape = read_shape(group.open_group("shape"), system.topology);
  if (group.has("solid")) system.solid = read_solid(group.open_group("solid"), system.topology);
  if (group.has("rigid")) system.rigid = read_rigid_bodies(group.open_group("rigid"), system.topology);
  if (group.has("acceleration")) {
    read_all(group.open_group("acceleration"), system.acceleration);
    expect_sound(system.knows_acceleration(), group, "accelerations are not those of its sites");
  }
  system.pairs = read_pairs(group.open_group("pairs"), sites);
  const int bodies = system.topology.body_count(sites);
  if (group.has("terms")) system.terms = read_body_terms(group.open_group("terms"), bodies);
  if (group.has(meaning_of_species.name)) system.species = read_species(group, bodies);
  if (group.has("touches")) system.touches = read_touches(group.open_group("touches"), sites, bodies);
  if (group.has("links")) system.links = read_links(group.open_group("links"), sites);
  expect_sound(!system.topology.begin.empty() || system.pairs.size() == 0 || system.pairs.width > 0, group,
               "contacts of discs remember nothing");
  return system;
}

template <int Dim>
void write_evaluation(h5::Group& group, const Evaluation<Dim>& evaluation, const Units& units) {
  write_all(group, evaluation, units);
  h5::Group energy = group.create_group("energy");
  write_all(energy, evaluation.energy, units);
}

template <int Dim>
Evaluation<Dim> read_evaluation(const h5::Group& group) {
  Evaluation<Dim> evaluation;
  read_all(group, evaluation);
  read_all(group.open_group("energy"), evaluation.energy, Missing::left);
  expect_sound(evaluation.torque.size() == evaluation.force.size(), group,
               "forces and torques differ in number");
  return evaluation;
}

#define SUPPLE_ARCHIVED(Dim)                                                        \
  template void write_system(h5::Group&, const System<Dim>&, const Units&);         \
  template System<Dim> read_system(const h5::Group&);                               \
  template void write_evaluation(h5::Group&, const Evaluation<Dim>&, const Units&); \
  template Evaluation<Dim> read_evaluation(const h5::Group&);
SUPPLE_ARCHIVED(2)
SUPPLE_ARCHIVED(3)
#undef SUPPLE_ARCHIVED

}  // namespace supple
