/// Frames in a run file.
#include <algorithm>
#include <cmath>

#include "supple/io/hdf5/elements.hpp"
#include "supple/io/run/run_layout.hpp"

namespace supple {
namespace {

constexpr auto itself = [](auto& row) -> auto& { return row; };

/// A quantity of all frames, one after the other: an array of one more dimension.
template <class Q, int Dim, class T>
void write_stacked(h5::Group& group, const Q& quantity, const std::vector<Frame<Dim>>& frames,
                   const std::vector<T>& like, const Units& units) {
  std::vector<T> all;
  for (const Frame<Dim>& frame : frames)
    all.insert(all.end(), (frame.*(quantity.member)).begin(), (frame.*(quantity.member)).end());
  h5::Object made = group.write(quantity.name, flat(all), shape_of<T>({frames.size(), like.size()}));
  describe(made, quantity, units);
}
template <class Q, int Dim, class T>
void write_stacked(h5::Group& group, const Q& quantity, const std::vector<Frame<Dim>>& frames, const T&,
                   const Units& units) {
  std::vector<T> all;
  for (const Frame<Dim>& frame : frames) all.push_back(frame.*(quantity.member));
  write(group, quantity, all, units);
}

template <int Dim>
void write_contacts(h5::Group& group, const std::vector<Frame<Dim>>& frames, const Units& units,
                    std::int64_t contacts) {
  std::vector<std::int64_t> begin, count;
  std::vector<ContactRow<Dim>> all;
  for (const Frame<Dim>& frame : frames) {
    begin.push_back(contacts + static_cast<std::int64_t>(all.size()));
    count.push_back(static_cast<std::int64_t>(frame.contacts.size()));
    all.insert(all.end(), frame.contacts.begin(), frame.contacts.end());
  }
  write(group, first_contact, begin, units);
  write(group, number_of_contacts, count, units);
  write_columns<ContactRow<Dim>>(group, all, units, itself);
}

/// "stress" of "stress_xy".
std::string without_component(const std::string& name) {
  const auto is_axis = [](char c) { return 'x' <= c && c <= 'z'; };
  const std::size_t n = name.size();
  const bool has_one = n > 3 && name[n - 3] == '_' && is_axis(name[n - 2]) && is_axis(name[n - 1]);
  return has_one ? name.substr(0, n - 3) : name;
}

void describe_number(h5::Object made, const std::string& name, const Units& units) {
  const bool reduced = units.name == reduced_units().name;
  for (const NamedNumber& number : numbers_in_frames) {
    if (number.name != without_component(name)) continue;
    describe(made, number, units);
    if (reduced && number.unit.si == unit::stress.si) made.set("unit", std::string("pressure_unit"));
  }
}

template <int Dim>
void write_body_numbers(h5::Group group, const std::vector<Frame<Dim>>& frames, const Units& units) {
  for (const auto& [name, first] : frames[0].body) {
    std::vector<double> all;
    for (const Frame<Dim>& f : frames) all.insert(all.end(), f.body.at(name).begin(), f.body.at(name).end());
    describe_number(group.write(name, all, {frames.size(), first.size()}), name, units);
  }
}

template <int Dim>
void write_system_numbers(h5::Group group, const std::vector<Frame<Dim>>& frames, const Units& units) {
  for (const auto& [name, first] : frames[0].numbers) {
    std::vector<double> values;
    for (const Frame<Dim>& f : frames) values.push_back(f.numbers.at(name));
    describe_number(group.write(name, values), name, units);
  }
}

/// Reads the arrays of frame k, each of which must have its place and shape in it.
struct FrameReader {
  const h5::Group& frames;
  std::uint64_t k, count, sites;

  /// One row of an array with these lengths behind the first.
  template <class T>
  std::vector<T> row(const h5::Group& group, const std::string& name, h5::Shape lengths) const {
    lengths.insert(lengths.begin(), count);
    expect_sound(group.shape(name) == shape_of<T>(lengths), group,
                 name + " has another shape than the frames");
    return values_from<T>(group.read_rows<NumberOf<T>>(name, k, 1), group, name);
  }
  template <class T>
  void get(const char* name, std::vector<T>& out) const {
    out = row<T>(frames, name, {sites});
  }
  template <class T>
  void get(const char* name, T& out) const {
    out = row<T>(frames, name, {}).at(0);
  }
};

template <int Dim>
std::vector<ContactRow<Dim>> read_contacts(const FrameReader& reader, std::int64_t contacts) {
  const h5::Group& frames = reader.frames;
  std::int64_t begin = 0, count = 0;
  reader.get(first_contact.name, begin);
  reader.get(number_of_contacts.name, count);
  begin -= contacts;
  const std::uint64_t total = rows_in(frames, "contact_first");
  const auto all = static_cast<std::int64_t>(total);
  expect_sound(0 <= begin && begin <= all && 0 <= count && count <= all - begin, frames,
               "contacts: rows are missing");
  std::vector<ContactRow<Dim>> rows(static_cast<std::size_t>(count));
  read_columns<ContactRow<Dim>>(frames, static_cast<std::uint64_t>(begin), total, rows, itself);
  for (const ContactRow<Dim>& c : rows)
    expect_sound(0 <= c.first && c.first < c.second && c.second < static_cast<std::int64_t>(reader.sites),
                 frames, "a contact of sites that do not exist");
  return rows;
}

}  // namespace

template <int Dim>
void write_frames(h5::Group& root, const std::vector<Frame<Dim>>& frames, const Units& units,
                  std::int64_t contacts) {
  if (frames.empty()) return;
  h5::Group group = root.create_group("frames");
  for_each_quantity(frames[0], [&](const auto& quantity, const auto& like) {
    write_stacked(group, quantity, frames, like, units);
  });
  write_contacts(group, frames, units, contacts);
  if (!frames[0].body.empty()) write_body_numbers(group.create_group("body"), frames, units);
  if (!frames[0].numbers.empty()) write_system_numbers(group.create_group("system"), frames, units);
}

template <int Dim>
Frame<Dim> read_frame(const h5::Group& frames, std::uint64_t k, std::int64_t contacts,
                      const RunInfo<Dim>& info) {
  const std::uint64_t steps = rows_in(frames, "step");
  expect_sound(k < steps, frames, "frames are missing");
  const FrameReader reader{frames, k, steps, info.radius.size()};
  Frame<Dim> frame;
  for_each_quantity(frame, [&](const auto& quantity, auto& value) { reader.get(quantity.name, value); });
  if (frame.length == Vec<Dim>{}) frame.length = info.box.length;
  expect_sound(is_cell<Dim>(frame.length) && std::abs(frame.strain) < far_away, frames,
               "a cell that is none");
  double extent = 0;
  for (int d = 0; d < Dim; ++d) extent += far_away * frame.length[d];
  for (const Vec<Dim>& x : frame.position)
    for (int d = 0; d < Dim; ++d)
      expect_sound(std::abs(x[d]) < extent, frames, "a position that is not finite, or far away");

  if (frames.has("body")) {
    const h5::Group body = frames.open_group("body");
    const std::uint64_t bodies = info.body_begin.empty() ? reader.sites : info.body_begin.size() - 1;
    for (const std::string& name : body.names()) frame.body[name] = reader.row<double>(body, name, {bodies});
  }
  if (frames.has("system")) {
    const h5::Group all = frames.open_group("system");
    for (const std::string& name : all.names()) frame.numbers[name] = reader.row<double>(all, name, {}).at(0);
  }
  frame.contacts = read_contacts<Dim>(reader, contacts);
  return frame;
}

template void write_frames(h5::Group&, const std::vector<Frame<2>>&, const Units&, std::int64_t);
template void write_frames(h5::Group&, const std::vector<Frame<3>>&, const Units&, std::int64_t);
template Frame<2> read_frame(const h5::Group&, std::uint64_t, std::int64_t, const RunInfo<2>&);
template Frame<3> read_frame(const h5::Group&, std::uint64_t, std::int64_t, const RunInfo<3>&);

}  // namespace supple
