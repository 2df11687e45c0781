#include "supple/io/hdf5/contact_archive.hpp"

#include <algorithm>
#include <cmath>

#include "supple/io/hdf5/elements.hpp"

namespace supple {

namespace {

void expect_near(const std::array<std::int32_t, 3>& cells, const h5::Group& group) {
  for (const std::int32_t n : cells)
    expect_sound(std::abs(static_cast<double>(n)) < 1e9, group, "an image is absurdly far");
}

using ImageRow = std::array<std::int32_t, 4>;  // kept, and the cells in three directions

void write_images(h5::Group& group, const std::vector<RowImage>& images, const Units& units) {
  if (images.empty()) return;
  std::vector<ImageRow> rows;
  for (const RowImage& row : images) rows.push_back({row.kept, row.cells[0], row.cells[1], row.cells[2]});
  write(group, meaning_of_images, rows, units);
}

void read_images(const h5::Group& group, PairTable& pairs) {
  std::vector<ImageRow> rows;
  read(group, meaning_of_images.name, rows);
  expect_sound(rows.size() == pairs.first.size(), group, "columns of the pairs differ in length");
  for (const ImageRow& row : rows) {
    pairs.image.push_back({{row[1], row[2], row[3]}, row[0] != 0});
    expect_near(pairs.image.back().cells, group);
  }
}

constexpr auto key_of = [](auto& touch) -> auto& { return touch.key; };
constexpr auto itself = [](auto& row) -> auto& { return row; };

}  // namespace

void write_pairs(h5::Group group, const PairTable& pairs, const Units& units) {
  group.set("width", std::int64_t{pairs.width});
  write_all(group, pairs, units);
  h5::Object history =
      group.write(meaning_of_history.name, pairs.history,
                  {static_cast<std::uint64_t>(pairs.size()), static_cast<std::uint64_t>(pairs.width)});
  describe(history, meaning_of_history, units);
  write_images(group, pairs.image, units);
}

PairTable read_pairs(const h5::Group& group, int sites) {
  PairTable pairs;
  const std::int64_t width = group.integer("width");
  expect_sound(0 <= width && width < 1000, group, "a row of the pairs has no such width");
  pairs.width = static_cast<int>(width);
  read_all(group, pairs);
  pairs.history = group.read<double>(meaning_of_history.name);

  const std::size_t rows = pairs.first.size();
  expect_sound(pairs.second.size() == rows && pairs.state.size() == rows &&
                   pairs.history.size() == rows * static_cast<std::size_t>(pairs.width),
               group, "columns of the pairs differ in length");
  expect_sound(pairs.begin.empty() ? rows == 0
                                   : static_cast<int>(pairs.begin.size()) == sites + 1 &&
                                         pairs.begin.front() == 0 && pairs.begin.back() == pairs.size() &&
                                         std::is_sorted(pairs.begin.begin(), pairs.begin.end()),
               group, "pairs and sites disagree");
  for (std::size_t r = 0; r < rows; ++r)
    expect_sound(0 <= pairs.first[r] && pairs.first[r] < pairs.second[r] && pairs.second[r] < sites, group,
                 "a pair of sites that do not exist");
  if (group.has(meaning_of_images.name)) read_images(group, pairs);
  return pairs;
}

void write_touches(h5::Group group, const TouchTable& touches, const Units& units) {
  write_columns<TouchKey>(group, touches.rows, units, key_of);
  write_columns<Touch>(group, touches.rows, units, itself);
}

TouchTable read_touches(const h5::Group& group, int sites, int bodies) {
  TouchTable touches;
  const std::uint64_t rows = rows_in(group, "site");
  touches.rows.resize(rows);
  read_columns<TouchKey>(group, 0, rows, touches.rows, key_of);
  read_columns<Touch>(group, 0, rows, touches.rows, itself);
  for (std::size_t k = 0; k < touches.rows.size(); ++k) {
    const TouchKey& key = touches.rows[k].key;
    expect_near(key.cells, group);
    expect_sound(0 <= key.site && key.site < sites && 0 <= key.other &&
                     key.other < (key.on == TouchOn::site ? sites : bodies),
                 group, "a contact of sites that do not exist");
    expect_sound(k == 0 || touches.rows[k - 1].key < key, group, "contacts are not in order");
  }
  return touches;
}

void write_links(h5::Group group, const std::vector<Link>& links, const Units& units) {
  write_columns<Link>(group, links, units, itself);
}

std::vector<Link> read_links(const h5::Group& group, int sites) {
  const std::uint64_t rows = rows_in(group, "first");
  std::vector<Link> links(rows);
  read_columns<Link>(group, 0, rows, links, itself);
  for (const Link& link : links) {
    expect_near(link.cells, group);
    expect_sound(0 <= link.first && link.first < link.second && link.second < sites && link.rest >= 0, group,
                 "a link of sites that do not exist, or of no length");
  }
  return links;
}

}  // namespace supple
