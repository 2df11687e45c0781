#include "supple/io/run/run_layout.hpp"
#include "supple/core/version.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "supple/core/error.hpp"
#include "supple/io/hdf5/elements.hpp"

namespace supple {
namespace {

template <class Section>
std::string attribute_name(const std::string& section, const Field<Section>& field) {
  return (section.empty() ? "" : section + ".") + std::string(field.name);
}

void store_keys(h5::Object& dataset, const Case& c) {
  for_each_section(c, [&](const std::string& section, const auto& values) {
    using Section = std::decay_t<decltype(values)>;
    for (const Field<Section>& field : fields<Section>()) {
      if (field.role == Role::exception && !c.is_given(attribute_name(section, field))) continue;
      std::visit(
          [&](auto member) {
            using Value = std::decay_t<decltype(values.*member)>;
            if constexpr (std::is_integral_v<Value>)
              dataset.set(attribute_name(section, field), static_cast<std::int64_t>(values.*member));
            else dataset.set(attribute_name(section, field), values.*member);
          },
          field.member);
    }
  });
}

/// Makes the sections of a stored case: its species and the pairs of them of which it says something.
void make_sections(const h5::Object& dataset, Case& c) {
  while (dataset.has_attribute(species_section(c.species.size()) + ".family")) {
    Species& last = c.species.emplace_back();
    const std::string name = species_section(c.species.size() - 1) + ".name";
    if (dataset.has_attribute(name)) last.name = dataset.text(name);
  }
  for (std::size_t a = 0; a < c.species.size(); ++a)
    for (std::size_t b = 0; b <= a; ++b) {
      Case with = c;
      const ContactOfSpecies pair = contact_between(with, name_of_species(c, a), name_of_species(c, b));
      for (const Field<ContactOfSpecies>& field : fields<ContactOfSpecies>()) {
        const std::string key = attribute_name(pair_section(pair), field);
        if (!dataset.has_attribute(key)) continue;
        contact_between(c, pair.first, pair.second);
        c.given.insert(key);
      }
    }
}

}  // namespace

std::string partial_folder(const std::string& path) { return path + ".partial"; }
std::string segment_name(int index) { return fmt::format("segment-{:06}.h5", index); }

template <int Dim>
void write_header(h5::Group& root, const Case& resolved, const std::string& case_text,
                  const RunInfo<Dim>& info) {
  root.set("format", std::string(run_format));
  root.set("supple_version", std::string(version()));
  root.set("compiler", std::string(__VERSION__));
  root.set("experiment", resolved.general.experiment);
  root.set("physics", resolved.general.physics);
  root.set("seed", resolved.general.seed);
  root.set("units", info.units.name);
  root.set("unit_length", info.units.length);
  root.set("unit_mass", info.units.mass);
  root.set("unit_time", info.units.time);
  root.set("sign_of_stress", std::string("compression positive"));
  root.set("definition_of_strain",
           std::string("time integral of the shear rate: displacement of the upper image along "
                       "x over the height of the cell; 0.2 is 20 %"));
  root.set("definition_of_phase",
           std::string("strain = A sin(2 pi (f t - pre_periods)); storage modulus: in phase with "
                       "the strain (sin), loss modulus: with its rate (cos)"));
  store_case(root, resolved, case_text);

  h5::Group box = root.create_group("box");
  write_all(box, info.box, info.units);
  h5::Group discs = root.create_group("discs");
  write_all(discs, info, info.units);
  if (!info.body_begin.empty())
    discs.write("body_begin", info.body_begin).set("meaning", "sites [k, k + 1) of these form body k");
  if (!info.facet.empty())
    discs.write("facet", flat(info.facet), {info.facet.size(), Dim})
        .set("meaning", "sites of each triangle, seen counter-clockwise from outside");
  if (!info.boundary_sites.empty())
    discs.write("boundary_sites", info.boundary_sites)
        .set("meaning", "sites on the boundary of each body, the first of its sites");
  if (!info.bond.empty())
    discs.write("bond", flat(info.bond), {info.bond.size(), 2}).set("meaning", "sites of each spring inside");
}

void store_case(h5::Group& root, const Case& resolved, const std::string& case_text) {
  h5::Object stored = root.write_scalar("case", case_text);
  store_keys(stored, resolved);
}

int dimensions_of(const h5::Group& root) {
  const h5::Group box = root.open_group("box");
  const h5::Shape shape = box.shape("length");
  expect_sound(shape == h5::Shape{2} || shape == h5::Shape{3}, box, "a cell that is none");
  return static_cast<int>(shape[0]);
}

namespace {

/// The triangles of a run in 3D; each is of sites of one body, and those of a body stand together.
void read_facets(const h5::Group& discs, RunInfo<3>& info) {
  if (discs.has("facet")) read(discs, "facet", info.facet);
  for (const auto& triangle : info.facet)
    for (const std::int32_t site : triangle)
      expect_sound(0 <= site && site < static_cast<std::int64_t>(info.particle.size()) &&
                       info.particle[site] == info.particle[triangle[0]],
                   discs, "a triangle of sites that are not those of one body");
  const auto body = [&](const auto& triangle) { return info.particle[triangle[0]]; };
  expect_sound(std::ranges::is_sorted(info.facet, {}, body), discs,
               "its triangles are not in order of bodies");
}

/// The inside of solids, if there are any.
template <int Dim>
void read_inside(const h5::Group& discs, RunInfo<Dim>& info) {
  const std::vector<std::int32_t>& begin = info.body_begin;
  if (discs.has("boundary_sites")) {
    info.boundary_sites = discs.read<std::int32_t>("boundary_sites");
    bool fits = info.boundary_sites.size() + 1 == begin.size();
    for (std::size_t b = 0; fits && b + 1 < begin.size(); ++b)
      fits = 0 < info.boundary_sites[b] && info.boundary_sites[b] <= begin[b + 1] - begin[b];
    expect_sound(fits, discs, "boundaries and bodies disagree");
  }
  if (discs.has("bond")) read(discs, "bond", info.bond);
  const auto sites = static_cast<std::int64_t>(info.particle.size());
  for (const auto& [i, j] : info.bond)
    expect_sound(0 <= i && i < sites && 0 <= j && j < sites && info.particle[i] == info.particle[j], discs,
                 "a spring between sites that are not those of one body");
}

}  // namespace

template <int Dim>
RunInfo<Dim> read_info(const h5::Group& root) {
  RunInfo<Dim> info;
  info.units = {root.text("units"), root.number("unit_length"), root.number("unit_mass"),
                root.number("unit_time")};
  for (const double unit : {info.units.length, info.units.mass, info.units.time})
    expect_sound(std::isfinite(unit) && unit > 0, root, "a unit that is none");
  const h5::Group box = root.open_group("box"), discs = root.open_group("discs");
  read_all(box, info.box);
  expect_sound(is_cell<Dim>(info.box.length) && std::abs(info.box.strain) < far_away, box,
               "a cell that is none");
  read_all(discs, info);
  if (discs.has("body_begin")) info.body_begin = discs.read<std::int32_t>("body_begin");

  const std::size_t sites = info.radius.size();
  expect_sound(all_have(info, sites), discs, "its arrays differ in length");
  for (std::size_t i = 0; i < sites; ++i)
    expect_sound(info.radius[i] > 0 && std::isfinite(info.radius[i]) && info.particle[i] >= 0 &&
                     info.particle[i] < static_cast<std::int64_t>(sites),
                 discs, "a site without size, or of a particle that does not exist");
  const std::vector<std::int32_t>& begin = info.body_begin;
  expect_sound(begin.empty() ||
                   (begin.front() == 0 && begin.back() == static_cast<std::int64_t>(sites) &&
                    std::adjacent_find(begin.begin(), begin.end(), std::greater_equal<>()) == begin.end()),
               discs, "its bodies do not cover the sites");
  if constexpr (Dim == 3) read_facets(discs, info);
  read_inside(discs, info);
  return info;
}

Case read_stored_case(const h5::Group& root) {
  Case c;
  const h5::Object dataset = root.open_dataset("case");
  make_sections(dataset, c);
  for_each_section(c, [&](const std::string& section, auto& values) {
    using Section = std::decay_t<decltype(values)>;
    for (const Field<Section>& field : fields<Section>()) {
      const std::string name = attribute_name(section, field);
      if (!dataset.has_attribute(name)) continue;  // a key that is younger than the file
      std::visit(
          [&](auto member) {
            using Value = std::decay_t<decltype(values.*member)>;
            if constexpr (std::is_same_v<Value, std::string>) values.*member = dataset.text(name);
            else if constexpr (std::is_same_v<Value, double>) values.*member = dataset.number(name);
            else values.*member = static_cast<Value>(dataset.integer(name));
          },
          field.member);
    }
  });
  return c;
}

void write_value(h5::Group& group, const RunValue& value) {
  h5::Object dataset = group.write_scalar(value.name.name, value.value);
  dataset.set("unit", value.name.unit);
  dataset.set("meaning", value.name.meaning);
  if (value.error >= 0) dataset.set("error", value.error);
}

std::vector<RunValue> read_values(const h5::Group& group) {
  std::vector<RunValue> out;
  for (const std::string& name : group.names()) {
    const h5::Object dataset = group.open_dataset(name);
    out.push_back({{name, dataset.text("unit"), dataset.text("meaning")},
                   group.read_scalar<double>(name),
                   dataset.has_attribute("error") ? dataset.number("error") : -1});
  }
  return out;
}

template void write_header(h5::Group&, const Case&, const std::string&, const RunInfo<2>&);
template void write_header(h5::Group&, const Case&, const std::string&, const RunInfo<3>&);
template RunInfo<2> read_info(const h5::Group&);
template RunInfo<3> read_info(const h5::Group&);

}  // namespace supple
