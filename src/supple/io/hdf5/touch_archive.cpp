#include "supple/io/hdf5/touch_archive.hpp"

#include <cmath>

#include "supple/io/hdf5/array_views.hpp"
#include "supple/io/hdf5/body_archive.hpp"

namespace supple {

namespace {

constexpr std::size_t directions = 3;
constexpr const char* cells_meaning = "cells of the lattice to subtract from the difference of the positions";

using Cells = std::array<std::int32_t, directions>;

void write_cells(h5::Group& group, const std::vector<Cells>& cells) {
  group.write("cells", flat(cells), {cells.size(), directions}).set("meaning", std::string(cells_meaning));
}

std::vector<Cells> read_cells(const h5::Group& group, std::size_t rows) {
  const auto numbers = group.read<std::int32_t>("cells");
  expect_state(numbers.size() == rows * directions, group, "columns differ in length");
  for (const std::int32_t n : numbers)
    expect_state(std::abs(static_cast<double>(n)) < 1e9, group, "an image is absurdly far");
  return tuples_from<directions>(numbers);
}

}  // namespace

void write_touches(h5::Group group, const TouchTable& touches) {
  std::vector<std::int32_t> site, other;
  std::vector<TouchOn> on;
  std::vector<ContactState> state;
  std::vector<double> elongation;
  std::vector<Cells> cells;
  for (const Touch& t : touches.rows) {
    site.push_back(t.key.site);
    other.push_back(t.key.other);
    on.push_back(t.key.on);
    state.push_back(t.state);
    elongation.push_back(t.elongation);
    cells.push_back(t.key.cells);
  }
  group.write("site", site);
  group.write("other", other);
  group.write("on", codes(on)).set("values", "what other is the number of: 0 a site, 1 a body");
  write_cells(group, cells);
  group.write("state", codes(state)).set("values", "0 open, 1 stick, 2 slip, 3 permanent");
  group.write("elongation", elongation);
}

TouchTable read_touches(const h5::Group& group, int sites, int bodies) {
  const auto site = group.read<std::int32_t>("site"), other = group.read<std::int32_t>("other");
  const auto on = group.read<std::uint8_t>("on"), state = group.read<std::uint8_t>("state");
  const auto elongation = group.read<double>("elongation");
  const std::size_t rows = site.size();
  const std::vector<Cells> cells = read_cells(group, rows);
  expect_state(other.size() == rows && on.size() == rows && state.size() == rows && elongation.size() == rows,
               group, "columns differ in length");
  TouchTable touches;
  for (std::size_t k = 0; k < rows; ++k) {
    const bool exists = 0 <= site[k] && site[k] < sites && on[k] <= 1 && 0 <= other[k] &&
                        other[k] < (on[k] == 0 ? sites : bodies) && state[k] <= 3;
    expect_state(exists, group, "a contact of sites that do not exist, or in no known state");
    const TouchKey key{site[k], other[k], static_cast<TouchOn>(on[k]), cells[k]};
    expect_state(touches.rows.empty() || touches.rows.back().key < key, group, "contacts are not in order");
    touches.rows.push_back({key, static_cast<ContactState>(state[k]), elongation[k]});
  }
  return touches;
}

void write_links(h5::Group group, const std::vector<Link>& links) {
  std::vector<std::int32_t> first, second;
  std::vector<double> rest, elongation;
  std::vector<Cells> cells;
  for (const Link& link : links) {
    first.push_back(link.first);
    second.push_back(link.second);
    rest.push_back(link.rest);
    elongation.push_back(link.elongation);
    cells.push_back(link.cells);
  }
  group.write("first", first);
  group.write("second", second);
  write_cells(group, cells);
  group.write("rest", rest).set("meaning", "distance without force");
  group.write("elongation", elongation);
}

std::vector<Link> read_links(const h5::Group& group, int sites) {
  const auto first = group.read<std::int32_t>("first"), second = group.read<std::int32_t>("second");
  const auto rest = group.read<double>("rest"), elongation = group.read<double>("elongation");
  const std::size_t rows = first.size();
  const std::vector<Cells> cells = read_cells(group, rows);
  expect_state(second.size() == rows && rest.size() == rows && elongation.size() == rows, group,
               "columns differ in length");
  std::vector<Link> links;
  for (std::size_t k = 0; k < rows; ++k) {
    expect_state(0 <= first[k] && first[k] < second[k] && second[k] < sites && rest[k] >= 0, group,
                 "a link of sites that do not exist, or of no length");
    links.push_back({first[k], second[k], cells[k], rest[k], elongation[k]});
  }
  return links;
}

}  // namespace supple
