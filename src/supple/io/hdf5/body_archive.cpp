#include "supple/io/hdf5/body_archive.hpp"

#include <algorithm>
#include <functional>

#include "supple/core/error.hpp"
#include "supple/io/hdf5/array_views.hpp"

namespace supple {
namespace {

/// An array of later versions: empty where an older file has none.
template <class T>
std::vector<T> read_if_there(const h5::Group& group, const std::string& name) {
  return group.has(name) ? group.read<T>(name) : std::vector<T>{};
}

/// Whether `begin` cuts `count` items into consecutive ranges, one for each body; empty: there are no ranges.
bool is_ranges(const std::vector<std::int32_t>& begin, std::size_t count) {
  return begin.empty() || (begin.front() == 0 && begin.back() == static_cast<std::int64_t>(count) &&
                           std::is_sorted(begin.begin(), begin.end()));
}

template <std::size_t N>
std::vector<std::array<std::int32_t, N>> read_tuples(const h5::Group& group, const char* name, int sites) {
  const h5::Shape shape = group.shape(name);
  expect_state(shape.size() == 2 && shape[1] == N, group, std::string(name) + " has another dimension");
  auto tuples = tuples_from<N>(group.read<std::int32_t>(name));
  for (const auto& tuple : tuples)
    for (const std::int32_t site : tuple)
      expect_state(0 <= site && site < sites, group, std::string(name) + " of a site that does not exist");
  return tuples;
}

/// Facets or hinges [begin[b], begin[b+1]) must be made of sites of body b.
template <int Dim, class Tuples>
bool are_own(const Topology<Dim>& t, const std::vector<std::int32_t>& begin, const Tuples& tuples) {
  for (std::size_t b = 0; b + 1 < begin.size(); ++b)
    for (std::int32_t k = begin[b]; k < begin[b + 1]; ++k)
      for (const std::int32_t site : tuples[static_cast<std::size_t>(k)])
        if (site < t.begin[b] || site >= t.begin[b + 1]) return false;
  return true;
}

/// Each array of RigidBodies with one number per body, by name.
template <class AnyRigid, class Visit>
void for_each_number(AnyRigid& rigid, Visit&& visit) {
  visit("angle", rigid.angle);
  visit("spin", rigid.spin);
  visit("mass", rigid.mass);
  visit("inertia", rigid.inertia);
}

constexpr std::uint64_t stiffness_columns = 4;

}  // namespace

void expect_state(bool good, const h5::Group& group, const std::string& what) {
  if (!good) throw file_error("cannot use the state in " + group.where(), what, "the file is damaged");
}

template <int Dim>
void write_topology(h5::Group group, const Topology<Dim>& t) {
  group.write("begin", t.begin);
  group.write("facet_begin", t.facet_begin);
  group.write("hinge_begin", t.hinge_begin);
  group.write("facet", flat(t.facet), {t.facet.size(), Dim});
  group.write("hinge", flat(t.hinge), {t.hinge.size(), Dim + 1});
  group.write("bond", flat(t.bond), {t.bond.size(), 2});
}

template <int Dim>
Topology<Dim> read_topology(const h5::Group& group, int sites) {
  Topology<Dim> t;
  t.begin = group.read<std::int32_t>("begin");
  t.facet_begin = read_if_there<std::int32_t>(group, "facet_begin");
  t.hinge_begin = read_if_there<std::int32_t>(group, "hinge_begin");
  t.facet = read_tuples<Dim>(group, "facet", sites);
  t.hinge = read_tuples<Dim + 1>(group, "hinge", sites);
  t.bond = read_tuples<2>(group, "bond", sites);
  const bool has_empty_body = std::adjacent_find(t.begin.begin(), t.begin.end()) != t.begin.end();
  expect_state(is_ranges(t.begin, static_cast<std::size_t>(sites)) && !has_empty_body, group,
               "its bodies do not cover the sites");
  for (const auto* begin : {&t.facet_begin, &t.hinge_begin})
    expect_state(begin->empty() || begin->size() == t.begin.size(), group, "its bodies differ in number");
  expect_state(is_ranges(t.facet_begin, t.facet.size()) && are_own(t, t.facet_begin, t.facet), group,
               "facets and bodies disagree");
  expect_state(is_ranges(t.hinge_begin, t.hinge.size()) && are_own(t, t.hinge_begin, t.hinge), group,
               "hinges and bodies disagree");
  return t;
}

void write_shape(h5::Group group, const Shape& shape) {
  static_assert(sizeof(ShapeStiffness) == stiffness_columns * sizeof(double));
  std::vector<double> stiffness;
  for (const ShapeStiffness& k : shape.stiffness)
    stiffness.insert(stiffness.end(), {k.volume, k.facet, k.hinge, k.tension});
  group.write("stiffness", stiffness, {shape.stiffness.size(), stiffness_columns})
      .set("columns", std::vector<std::string>{"volume", "facet", "hinge", "tension"});
  group.write("rest_volume", shape.rest_volume);
  group.write("rest_facet", shape.rest_facet);
  group.write("rest_hinge", shape.rest_hinge);
}

void write_body_terms(h5::Group group, const std::vector<BodyTermData>& terms) {
  for (const BodyTermData& term : terms) group.write(term.name, term.number, {term.bodies(), term.width});
}

std::vector<BodyTermData> read_body_terms(const h5::Group& group, int bodies) {
  std::vector<BodyTermData> terms;
  for (const std::string& name : group.names()) {
    const h5::Shape shape = group.shape(name);
    expect_state(
        shape.size() == 2 && 0 < shape[1] && shape[1] < 100 && shape[0] <= static_cast<std::uint64_t>(bodies),
        group, name + " and bodies disagree");
    terms.push_back({name, shape[1], group.read<double>(name)});
  }
  return terms;
}

std::vector<std::int32_t> read_species(const h5::Group& group, int bodies) {
  auto species = group.read<std::int32_t>("species");
  expect_state(species.size() == static_cast<std::size_t>(bodies), group, "species and bodies disagree");
  for (const std::int32_t s : species)
    expect_state(0 <= s && s < bodies, group, "a body of a species that cannot be");
  return species;
}

template <int Dim>
Shape read_shape(const h5::Group& group, const Topology<Dim>& t) {
  Shape shape;
  const auto k = group.read<double>("stiffness");
  shape.rest_volume = group.read<double>("rest_volume");
  shape.rest_facet = group.read<double>("rest_facet");
  shape.rest_hinge = group.read<double>("rest_hinge");
  const std::size_t bodies = t.facet_begin.empty() ? 0 : t.facet_begin.size() - 1;
  expect_state(bodies > 0 && t.hinge_begin.size() == bodies + 1, group,
               "it is the shape of bodies that have no boundary");
  expect_state(k.size() == stiffness_columns * bodies && shape.rest_volume.size() == bodies &&
                   shape.rest_facet.size() == t.facet.size() && shape.rest_hinge.size() == t.hinge.size(),
               group, "preferred shapes and bodies disagree");
  for (std::size_t b = 0; b < bodies; ++b)
    shape.stiffness.push_back({k[4 * b], k[4 * b + 1], k[4 * b + 2], k[4 * b + 3]});
  return shape;
}

void write_rigid_bodies(h5::Group group, const RigidBodies& rigid) {
  group.write("body", rigid.body);
  group.write("centre", flat(rigid.centre), {rigid.centre.size(), 2});
  group.write("velocity", flat(rigid.velocity), {rigid.velocity.size(), 2});
  for_each_number(rigid, [&](const char* name, const auto& values) { group.write(name, values); });
  group.write("begin", rigid.begin);
  group.write("offset", flat(rigid.offset), {rigid.offset.size(), 2});
}

template <int Dim>
RigidBodies read_rigid_bodies(const h5::Group& group, const Topology<Dim>& t) {
  RigidBodies rigid;
  rigid.body = group.read<std::int32_t>("body");
  const auto n = rigid.body.size();
  const auto vectors = [&](const char* name) {
    const h5::Shape shape = group.shape(name);
    expect_state(shape.size() == 2 && shape[1] == 2, group, std::string(name) + " has another dimension");
    return vectors_from<2>(group.read<double>(name));
  };
  rigid.centre = vectors("centre");
  rigid.velocity = vectors("velocity");
  rigid.begin = group.read<std::int32_t>("begin");
  rigid.offset = vectors("offset");
  bool same_length = rigid.centre.size() == n && rigid.velocity.size() == n && rigid.begin.size() == n + 1;
  for_each_number(rigid, [&](const char* name, std::vector<double>& values) {
    values = group.read<double>(name);
    same_length = same_length && values.size() == n;
  });
  expect_state(same_length, group, "arrays of the rigid bodies differ in length");
  const bool is_ascending =
      std::adjacent_find(rigid.body.begin(), rigid.body.end(), std::greater_equal<>()) == rigid.body.end();
  bool fits = n == 0 ||
              (rigid.body.front() >= 0 && rigid.body.back() < static_cast<std::int64_t>(t.begin.size()) - 1);
  fits = fits && is_ascending && is_ranges(rigid.begin, rigid.offset.size());
  for (std::size_t r = 0; fits && r < n; ++r)
    fits = rigid.begin[r + 1] - rigid.begin[r] == t.body_size(rigid.body[r]) && rigid.mass[r] > 0 &&
           rigid.inertia[r] > 0;
  expect_state(fits, group, "rigid bodies and bodies disagree");
  return rigid;
}

#define SUPPLE_ARCHIVED(Dim)                                         \
  template void write_topology(h5::Group, const Topology<Dim>&);     \
  template Topology<Dim> read_topology(const h5::Group&, int);       \
  template Shape read_shape(const h5::Group&, const Topology<Dim>&); \
  template RigidBodies read_rigid_bodies(const h5::Group&, const Topology<Dim>&);
SUPPLE_ARCHIVED(2)
SUPPLE_ARCHIVED(3)
#undef SUPPLE_ARCHIVED

}  // namespace supple
