#include "supple/io/hdf5/body_archive.hpp"

#include <algorithm>
#include <functional>

#include "supple/io/hdf5/elements.hpp"

namespace supple {
namespace {

/// Whether `begin` cuts `count` items into consecutive ranges, one for each body; empty: there are no ranges.
bool is_ranges(const std::vector<std::int32_t>& begin, std::size_t count) {
  return begin.empty() || (begin.front() == 0 && begin.back() == static_cast<std::int64_t>(count) &&
                           std::is_sorted(begin.begin(), begin.end()));
}

template <std::size_t N>
void expect_sites(const std::vector<std::array<std::int32_t, N>>& tuples, int sites, const h5::Group& group,
                  const char* name) {
  for (const auto& tuple : tuples)
    for (const std::int32_t site : tuple)
      expect_sound(0 <= site && site < sites, group, std::string(name) + " of a site that does not exist");
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

/// Writes the stiffnesses of all bodies as a table with a column for each quantity of Stiffness.
template <class Stiffness>
void write_stiffness(h5::Group& group, const NamedNumber& meaning, const std::vector<Stiffness>& all,
                     const Units& units) {
  std::vector<double> numbers;
  std::vector<std::string> columns;
  for_each_quantity(static_cast<const Stiffness&>(Stiffness{}),
                    [&](const auto& q, double) { columns.push_back(q.name); });
  for (const Stiffness& k : all)
    for_each_quantity(k, [&](const auto&, double value) { numbers.push_back(value); });
  h5::Object made = group.write(meaning.name, numbers, {all.size(), columns.size()});
  describe(made, meaning, units);
  made.set("columns", columns);
}

/// Reads such a table; it has `bodies` rows.
template <class Stiffness>
std::vector<Stiffness> read_stiffness(const h5::Group& group, const NamedNumber& meaning,
                                      std::size_t bodies) {
  constexpr std::size_t columns = std::tuple_size_v<decltype(quantities<Stiffness>)>;
  const auto numbers = group.read<double>(meaning.name);
  expect_sound(numbers.size() == columns * bodies, group, "stiffnesses and bodies differ in number");
  std::vector<Stiffness> all(bodies);
  std::size_t k = 0;
  for (Stiffness& stiffness : all)
    for_each_quantity(stiffness, [&](const auto&, double& value) { value = numbers[k++]; });
  return all;
}

}  // namespace

template <int Dim>
void write_topology(h5::Group group, const Topology<Dim>& t, const Units& units) {
  write_all(group, t, units);
}

template <int Dim>
Topology<Dim> read_topology(const h5::Group& group, int sites) {
  Topology<Dim> t;
  for (const char* name : {"begin", "facet", "hinge"})
    expect_sound(group.has(name), group, std::string(name) + " is missing");
  read_all(group, t, Missing::left);
  expect_sites(t.facet, sites, group, "facet");
  expect_sites(t.hinge, sites, group, "hinge");
  const bool has_empty_body = std::adjacent_find(t.begin.begin(), t.begin.end()) != t.begin.end();
  expect_sound(is_ranges(t.begin, static_cast<std::size_t>(sites)) && !has_empty_body, group,
               "its bodies do not cover the sites");
  for (const auto* begin : {&t.facet_begin, &t.hinge_begin})
    expect_sound(begin->empty() || begin->size() == t.begin.size(), group, "its bodies differ in number");
  expect_sound(is_ranges(t.facet_begin, t.facet.size()) && are_own(t, t.facet_begin, t.facet), group,
               "facets and bodies disagree");
  expect_sound(is_ranges(t.hinge_begin, t.hinge.size()) && are_own(t, t.hinge_begin, t.hinge), group,
               "hinges and bodies disagree");
  return t;
}

void write_shape(h5::Group group, const Shape& shape, const Units& units) {
  write_stiffness(group, meaning_of_stiffness, shape.stiffness, units);
  write_all(group, shape, units);
}

template <int Dim>
void write_solid(h5::Group group, const Solid<Dim>& solid, const Units& units) {
  write_stiffness(group, meaning_of_inside, solid.stiffness, units);
  write_all(group, solid, units);
}

void write_body_terms(h5::Group group, const std::vector<BodyTermData>& terms) {
  for (const BodyTermData& term : terms) group.write(term.name, term.number, {term.bodies(), term.width});
}

std::vector<BodyTermData> read_body_terms(const h5::Group& group, int bodies) {
  std::vector<BodyTermData> terms;
  for (const std::string& name : group.names()) {
    const h5::Shape shape = group.shape(name);
    expect_sound(
        shape.size() == 2 && 0 < shape[1] && shape[1] < 100 && shape[0] <= static_cast<std::uint64_t>(bodies),
        group, name + " and bodies disagree");
    terms.push_back({name, shape[1], group.read<double>(name)});
  }
  return terms;
}

std::vector<std::int32_t> read_species(const h5::Group& group, int bodies) {
  std::vector<std::int32_t> species;
  read(group, meaning_of_species.name, species);
  expect_sound(species.size() == static_cast<std::size_t>(bodies), group, "species and bodies disagree");
  for (const std::int32_t s : species)
    expect_sound(0 <= s && s < bodies, group, "a body of a species that cannot be");
  return species;
}

template <int Dim>
Shape read_shape(const h5::Group& group, const Topology<Dim>& t) {
  Shape shape;
  read_all(group, shape);
  const std::size_t bodies = t.facet_begin.empty() ? 0 : t.facet_begin.size() - 1;
  expect_sound(bodies > 0 && t.hinge_begin.size() == bodies + 1, group,
               "it is the shape of bodies that have no boundary");
  shape.stiffness = read_stiffness<ShapeStiffness>(group, meaning_of_stiffness, bodies);
  expect_sound(shape.rest_volume.size() == bodies && shape.rest_facet.size() == t.facet.size() &&
                   shape.rest_hinge.size() == t.hinge.size(),
               group, "preferred shapes and bodies disagree");
  return shape;
}

template <int Dim>
Solid<Dim> read_solid(const h5::Group& group, const Topology<Dim>& t) {
  Solid<Dim> solid;
  read_all(group, solid);
  const std::size_t bodies = solid.bond_begin.empty() ? 0 : solid.bond_begin.size() - 1;
  expect_sound(bodies > 0 && bodies < t.begin.size() && solid.element_begin.size() == bodies + 1, group,
               "its bodies differ in number");
  expect_sound(is_ranges(solid.bond_begin, solid.bond.size()) && are_own(t, solid.bond_begin, solid.bond) &&
                   solid.rest_bond.size() == solid.bond.size(),
               group, "bonds and bodies disagree");
  expect_sound(is_ranges(solid.element_begin, solid.element.size()) &&
                   are_own(t, solid.element_begin, solid.element) &&
                   solid.rest_element.size() == solid.element.size(),
               group, "elements and bodies disagree");
  for (const Mat<Dim>& inverse : solid.rest_element)
    expect_sound(determinant(inverse) > 0, group, "an element has no area or volume");
  solid.stiffness = read_stiffness<SolidStiffness>(group, meaning_of_inside, bodies);
  return solid;
}

template <int Dim>
void write_rigid_bodies(h5::Group group, const RigidBodiesOf<Dim>& rigid, const Units& units) {
  write_all(group, rigid, units);
}

namespace {

bool is_inertia(double inertia) { return inertia > 0; }
/// Symmetric, and by its minors positive.
bool is_inertia(const Mat<3>& m) {
  const double minor = m[0][0] * m[1][1] - m[0][1] * m[1][0];
  const double determinant = m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]) -
                             m[1][2] * (m[0][0] * m[2][1] - m[0][1] * m[2][0]) + m[2][2] * minor;
  return m[0][1] == m[1][0] && m[0][2] == m[2][0] && m[1][2] == m[2][1] && m[0][0] > 0 && minor > 0 &&
         determinant > 0;
}

}  // namespace

template <int Dim>
RigidBodiesOf<Dim> read_rigid_bodies(const h5::Group& group, const Topology<Dim>& t) {
  RigidBodiesOf<Dim> rigid;
  read_all(group, rigid);
  const auto n = rigid.body.size();
  bool same_length = rigid.begin.size() == n + 1;
  for (const std::size_t length : {rigid.centre.size(), rigid.velocity.size(), rigid.angle.size(),
                                   rigid.spin.size(), rigid.mass.size(), rigid.inertia.size()})
    same_length = same_length && length == n;
  expect_sound(same_length, group, "arrays of the rigid bodies differ in length");
  const bool is_ascending =
      std::adjacent_find(rigid.body.begin(), rigid.body.end(), std::greater_equal<>()) == rigid.body.end();
  bool fits = n == 0 ||
              (rigid.body.front() >= 0 && rigid.body.back() < static_cast<std::int64_t>(t.begin.size()) - 1);
  fits = fits && is_ascending && is_ranges(rigid.begin, rigid.offset.size());
  for (std::size_t r = 0; fits && r < n; ++r)
    fits = rigid.begin[r + 1] - rigid.begin[r] == t.body_size(rigid.body[r]) && rigid.mass[r] > 0 &&
           is_inertia(rigid.inertia[r]);
  expect_sound(fits, group, "rigid bodies and bodies disagree");
  return rigid;
}

#define SUPPLE_ARCHIVED(Dim)                                                            \
  template void write_topology(h5::Group, const Topology<Dim>&, const Units&);          \
  template Topology<Dim> read_topology(const h5::Group&, int);                          \
  template Shape read_shape(const h5::Group&, const Topology<Dim>&);                    \
  template void write_solid(h5::Group, const Solid<Dim>&, const Units&);                \
  template Solid<Dim> read_solid(const h5::Group&, const Topology<Dim>&);               \
  template void write_rigid_bodies(h5::Group, const RigidBodiesOf<Dim>&, const Units&); \
  template RigidBodiesOf<Dim> read_rigid_bodies(const h5::Group&, const Topology<Dim>&);
SUPPLE_ARCHIVED(2)
SUPPLE_ARCHIVED(3)
#undef SUPPLE_ARCHIVED

}  // namespace supple
