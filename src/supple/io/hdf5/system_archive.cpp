#include "supple/io/hdf5/system_archive.hpp"

#include <algorithm>

#include "supple/io/hdf5/array_views.hpp"
#include "supple/io/hdf5/body_archive.hpp"
#include "supple/io/hdf5/touch_archive.hpp"

namespace supple {
namespace {

/// Each array of State with one number per site, by name.
template <class AnyState, class Visit>
void for_each_array(AnyState& state, Visit&& visit) {
  visit("mass", state.mass);
  visit("radius", state.radius);
  visit("angle", state.angle);
  visit("inertia", state.inertia);
}

/// Spins and torques: one number per site in 2D, a vector in 3D.
template <int Dim>
void write_angular(h5::Group& group, const char* name, const std::vector<Angular<Dim>>& values) {
  if constexpr (Dim == 2) group.write(name, values);
  else group.write(name, flat(values), {values.size(), Dim});
}

template <int Dim>
std::vector<Angular<Dim>> read_angular(const h5::Group& group, const char* name) {
  if constexpr (Dim == 2) return group.read<double>(name);
  else return vectors_from<Dim>(group.read<double>(name));
}

template <int Dim>
std::vector<Vec<Dim>> read_vectors(const h5::Group& group, const char* name) {
  const h5::Shape shape = group.shape(name);
  expect_state(shape.size() == 2 && shape[1] == Dim, group, std::string(name) + " has another dimension");
  return vectors_from<Dim>(group.read<double>(name));
}

template <class Parts, class Visit>
void for_each_energy(Parts& parts, Visit&& visit) {
  visit("terms", parts.terms);
  visit("elastic", parts.elastic);
  visit("tangential", parts.tangential);
  visit("wall", parts.wall);
  visit("external", parts.external);
  visit("viscous_power", parts.viscous_power);
  visit("tangential_viscous_power", parts.tangential_viscous_power);
  visit("sliding_power", parts.sliding_power);
}

constexpr std::size_t row_image_size = 4;  ///< kept, and the cells in three directions

void write_pairs(h5::Group group, const PairTable& pairs) {
  group.set("width", std::int64_t{pairs.width});
  group.write("begin", pairs.begin);
  group.write("first", pairs.first);
  group.write("second", pairs.second);
  group.write("state", codes(pairs.state)).set("values", "0 open, 1 stick, 2 slip, 3 permanent");
  group.write("history", pairs.history,
              {static_cast<std::uint64_t>(pairs.size()), static_cast<std::uint64_t>(pairs.width)});
  if (pairs.image.empty()) return;
  std::vector<std::int32_t> image;
  for (const RowImage& row : pairs.image) {
    image.push_back(row.kept);
    image.insert(image.end(), row.cells.begin(), row.cells.end());
  }
  group.write("image", image, {static_cast<std::uint64_t>(pairs.size()), row_image_size})
      .set("meaning", "1: the row keeps its image, 0: the nearest; cells to subtract from second - first");
}

void read_images(const h5::Group& group, PairTable& pairs) {
  const auto image = group.read<std::int32_t>("image");
  const auto rows = static_cast<std::size_t>(pairs.size());
  expect_state(image.size() == rows * row_image_size, group, "columns of the pairs differ in length");
  pairs.image.resize(rows);
  for (std::size_t r = 0; r < rows; ++r) {
    const std::int32_t* from = &image[r * row_image_size];
    pairs.image[r].kept = *from != 0;
    for (std::int32_t& cells : pairs.image[r].cells) {
      cells = *++from;
      expect_state(std::abs(static_cast<double>(cells)) < 1e9, group, "an image is absurdly far");
    }
  }
}

PairTable read_pairs(const h5::Group& group, int sites) {
  PairTable pairs;
  const std::int64_t width = group.integer("width");
  expect_state(0 <= width && width < 1000, group, "a row of the pairs has no such width");
  pairs.width = static_cast<int>(width);
  pairs.begin = group.read<std::int32_t>("begin");
  pairs.first = group.read<std::int32_t>("first");
  pairs.second = group.read<std::int32_t>("second");
  const auto states = group.read<std::uint8_t>("state");
  pairs.state = enums_from<ContactState>(states);
  pairs.history = group.read<double>("history");

  const auto rows = static_cast<std::size_t>(pairs.size());
  expect_state(pairs.second.size() == rows && states.size() == rows &&
                   pairs.history.size() == rows * static_cast<std::size_t>(pairs.width),
               group, "columns of the pairs differ in length");
  expect_state(pairs.begin.empty() ? rows == 0
                                   : static_cast<int>(pairs.begin.size()) == sites + 1 &&
                                         pairs.begin.front() == 0 && pairs.begin.back() == pairs.size() &&
                                         std::is_sorted(pairs.begin.begin(), pairs.begin.end()),
               group, "pairs and sites disagree");
  for (std::size_t r = 0; r < rows; ++r)
    expect_state(
        0 <= pairs.first[r] && pairs.first[r] < pairs.second[r] && pairs.second[r] < sites && states[r] <= 3,
        group, "a pair of sites that do not exist, or in no known state");
  if (group.has("image")) read_images(group, pairs);
  return pairs;
}

}  // namespace

template <int Dim>
void write_box(h5::Group& group, const Box<Dim>& box) {
  group.write("length", std::span<const double>(box.length.e));
  std::vector<std::uint8_t> periodic(box.periodic.begin(), box.periodic.end());
  group.write("periodic", periodic);
  group.write_scalar("strain", box.strain);
  group.write_scalar("strain_rate", box.strain_rate);
}

template <int Dim>
Box<Dim> read_box(const h5::Group& group) {
  Box<Dim> box;
  const auto length = group.read<double>("length");
  const auto periodic = group.read<std::uint8_t>("periodic");
  expect_state(length.size() == Dim && periodic.size() == Dim, group, "its box has another dimension");
  for (std::size_t d = 0; d < Dim; ++d) {
    box.length[static_cast<int>(d)] = length[d];
    box.periodic[d] = periodic[d] != 0;
  }
  box.strain = group.read_scalar<double>("strain");
  box.strain_rate = group.read_scalar<double>("strain_rate");
  return box;
}

template <int Dim>
void write_system(h5::Group& group, const System<Dim>& system) {
  const State<Dim>& state = system.state;
  const auto sites = static_cast<std::uint64_t>(state.size());
  group.write_scalar("time", system.time);
  group.write_scalar("lag", system.lag)
      .set("meaning", std::string("velocities and spins are of half this time before the positions"));
  group.write_scalar("step", system.step);
  h5::Group box = group.create_group("box");
  write_box(box, system.box);

  h5::Group sites_group = group.create_group("sites");
  sites_group.write("position", flat(state.position), {sites, Dim});
  sites_group.write("velocity", flat(state.velocity), {sites, Dim});
  for_each_array(state, [&](const char* name, const auto& values) { sites_group.write(name, values); });
  write_angular<Dim>(sites_group, "spin", state.spin);
  sites_group.write("mobility", codes(state.mobility))
      .set("values", "0 free, 1 lower plate, 2 upper plate, 3 fixed");
  if (!system.floor_contact.empty())
    sites_group.write("floor_contact", system.floor_contact)
        .set("meaning", "where a site sticks to the floor; nan: nowhere");

  write_topology(group.create_group("topology"), system.topology);
  if (!system.shape.empty()) write_shape(group.create_group("shape"), system.shape);
  if (!system.terms.empty()) write_body_terms(group.create_group("terms"), system.terms);
  if (!system.species.empty())
    group.write("species", system.species).set("meaning", "of each body, from 0, as the case has them");
  if (!system.rigid.empty()) write_rigid_bodies(group.create_group("rigid"), system.rigid);
  write_pairs(group.create_group("pairs"), system.pairs);
  if (!system.touches.rows.empty()) write_touches(group.create_group("touches"), system.touches);
  if (!system.links.empty()) write_links(group.create_group("links"), system.links);
}

template <int Dim>
System<Dim> read_system(const h5::Group& group) {
  System<Dim> system;
  system.time = group.read_scalar<double>("time");
  system.lag = group.read_scalar<double>("lag");
  system.step = group.read_scalar<std::int64_t>("step");
  system.box = read_box<Dim>(group.open_group("box"));

  const h5::Group sites = group.open_group("sites");
  State<Dim>& state = system.state;
  state.position = read_vectors<Dim>(sites, "position");
  state.velocity = read_vectors<Dim>(sites, "velocity");
  const auto mobility = sites.read<std::uint8_t>("mobility");
  expect_state(std::all_of(mobility.begin(), mobility.end(), [](std::uint8_t code) { return code <= 3; }),
               sites, "a site of no known mobility");
  state.mobility = enums_from<Mobility>(mobility);
  const std::size_t n = state.position.size();
  state.spin = read_angular<Dim>(sites, "spin");
  expect_state(state.velocity.size() == n && state.mobility.size() == n && state.spin.size() == n, sites,
               "arrays of the sites differ in length");
  for_each_array(state, [&](const char* name, std::vector<double>& values) {
    values = sites.read<double>(name);
    expect_state(values.size() == n, sites, "arrays of the sites differ in length");
  });

  if (sites.has("floor_contact")) system.floor_contact = sites.read<double>("floor_contact");
  expect_state(system.floor_contact.empty() || system.floor_contact.size() == n, sites,
               "arrays of the sites differ in length");

  system.topology = read_topology<Dim>(group.open_group("topology"), state.size());
  if (group.has("shape")) system.shape = read_shape(group.open_group("shape"), system.topology);
  if (group.has("rigid")) system.rigid = read_rigid_bodies(group.open_group("rigid"), system.topology);
  system.pairs = read_pairs(group.open_group("pairs"), state.size());
  const int bodies = system.topology.body_count(state.size());
  if (group.has("terms")) system.terms = read_body_terms(group.open_group("terms"), bodies);
  if (group.has("species")) system.species = read_species(group, bodies);
  if (group.has("touches")) system.touches = read_touches(group.open_group("touches"), state.size(), bodies);
  if (group.has("links")) system.links = read_links(group.open_group("links"), state.size());
  expect_state(!system.topology.begin.empty() || system.pairs.size() == 0 || system.pairs.width > 0, group,
               "contacts of discs remember nothing");
  return system;
}

template <int Dim>
void write_evaluation(h5::Group& group, const Evaluation<Dim>& evaluation) {
  group.write("force", flat(evaluation.force), {evaluation.force.size(), Dim});
  write_angular<Dim>(group, "torque", evaluation.torque);
  group.write("virial", std::span<const double>(&evaluation.virial.e[0][0], Dim * Dim), {Dim, Dim});
  h5::Group energy = group.create_group("energy");
  for_each_energy(evaluation.energy,
                  [&](const char* name, double value) { energy.write_scalar(name, value); });
}

template <int Dim>
Evaluation<Dim> read_evaluation(const h5::Group& group) {
  Evaluation<Dim> evaluation;
  evaluation.force = read_vectors<Dim>(group, "force");
  evaluation.torque = read_angular<Dim>(group, "torque");
  expect_state(evaluation.torque.size() == evaluation.force.size(), group,
               "forces and torques differ in number");
  const auto virial = group.read<double>("virial");
  expect_state(virial.size() == Dim * Dim, group, "its virial has another dimension");
  std::copy(virial.begin(), virial.end(), &evaluation.virial.e[0][0]);
  const h5::Group energy = group.open_group("energy");
  for_each_energy(evaluation.energy, [&](const char* name, double& value) {
    if (energy.has(name)) value = energy.read_scalar<double>(name);  // older files have fewer
  });
  return evaluation;
}

#define SUPPLE_ARCHIVED(Dim)                                          \
  template void write_box(h5::Group&, const Box<Dim>&);               \
  template Box<Dim> read_box(const h5::Group&);                       \
  template void write_system(h5::Group&, const System<Dim>&);         \
  template System<Dim> read_system(const h5::Group&);                 \
  template void write_evaluation(h5::Group&, const Evaluation<Dim>&); \
  template Evaluation<Dim> read_evaluation(const h5::Group&);
SUPPLE_ARCHIVED(2)
SUPPLE_ARCHIVED(3)
#undef SUPPLE_ARCHIVED

}  // namespace supple
