/// Frames in a run file.
#include <algorithm>
#include <cmath>

#include "supple/io/hdf5/array_views.hpp"
#include "supple/io/run/run_layout.hpp"

namespace supple {
namespace {

/// One array of all frames: per disc (`row` holds the other lengths) or, with an empty row, one number.
template <class T>
void write_rows(h5::Group& group, const char* name, const h5::Shape& row, const std::string& unit,
                const std::vector<T>& values) {
  h5::Shape shape{1};
  for (const std::uint64_t length : row) shape[0] *= length;
  shape[0] = shape[0] ? values.size() / shape[0] : 0;
  shape.insert(shape.end(), row.begin(), row.end());
  h5::Object made = group.write(name, values, shape);
  if (!unit.empty()) made.set("unit", unit);
}

/// The values that `pick` takes from each frame, one after the other.
template <class T, class Pick>
std::vector<T> stacked(const std::vector<Frame>& frames, Pick&& pick) {
  std::vector<T> out;
  for (const Frame& frame : frames) {
    const std::span<const T> values = pick(frame);
    out.insert(out.end(), values.begin(), values.end());
  }
  return out;
}

template <class T, class Pick>
std::vector<T> contact_column(const std::vector<Frame>& frames, Pick&& pick) {
  std::vector<T> out;
  for (const Frame& frame : frames)
    for (const ContactRow& contact : frame.contacts) out.push_back(static_cast<T>(pick(contact)));
  return out;
}

void write_contacts(h5::Group& group, const std::vector<Frame>& frames, const Units& units,
                    std::int64_t contacts) {
  std::vector<std::int64_t> begin, count;
  for (const Frame& frame : frames) {
    begin.push_back(contacts);
    count.push_back(static_cast<std::int64_t>(frame.contacts.size()));
    contacts += count.back();
  }
  const std::string length = unit_text(units, units.length, "m"),
                    force = unit_text(units, units.force(), "N/m");
  const auto column = [&]<class T>(T, const char* name, const std::string& unit, const char* meaning,
                                   auto member) {
    write_rows<T>(group, name, {}, unit,
                  contact_column<T>(frames, [&](const ContactRow& c) { return c.*member; }));
    if (*meaning) group.open_dataset(name).set("meaning", std::string(meaning));
  };
  write_rows<std::int64_t>(group, "contact_begin", {}, "", begin);
  write_rows<std::int64_t>(group, "contact_count", {}, "", count);
  column(std::int32_t{}, "contact_first", "", "site; the smaller number", &ContactRow::first);
  column(std::int32_t{}, "contact_second", "", "site", &ContactRow::second);
  column(std::uint8_t{}, "contact_state", "0 open, 1 stick, 2 slip, 3 permanent", "", &ContactRow::state);
  column(double{}, "contact_elongation", length,
         "of the tangential spring, along t = (-n_y, n_x), n from first to second", &ContactRow::elongation);
  column(double{}, "contact_elongation_back", length,
         "the published package's second one, as the second site sees it", &ContactRow::elongation_back);
  column(double{}, "contact_normal_force", force, "elastic and viscous part; positive: pushes the two apart",
         &ContactRow::normal_force);
  column(double{}, "contact_elastic_force", force, "part of the normal force by repulsion or link",
         &ContactRow::elastic);
  column(double{}, "contact_viscous_force", force, "part of the normal force by the dashpot",
         &ContactRow::viscous);
  column(double{}, "contact_tangential_force", force,
         "on contact_first along t = (-n_y, n_x), n from first to second; the opposite on contact_second",
         &ContactRow::tangential_force);
  std::vector<Vec2> whole;
  for (const Frame& frame : frames)
    for (const ContactRow& contact : frame.contacts) whole.push_back(contact.force);
  h5::Object made = group.write("contact_force", flat(whole), {whole.size(), 2});
  if (!force.empty()) made.set("unit", force);
  made.set("meaning", "on contact_first; the opposite on contact_second");
}

constexpr const char* component =
    "component of the stress tensor, compression positive: force along the first "
    "letter, line of action along the second";

/// Unit and meaning of the numbers of bodies, and of all, that experiments write.
const std::vector<Column>& known_numbers() {
  static const std::vector<Column> known{
      {"pressure", "pressure", "mean normal stress, compression positive (9.27)"},
      {"area", "", "area that the body covers"},
      {"shape_parameter", "", "p^2/(4 pi a); 0 for discs"},
      {"contacts", "", "bodies and walls that it touches"},
      {"rattler", "", "1: held by too few contacts to bear pressure"},
      {"packing_fraction", "", "covered area over area of the cell"},
      {"uniaxial_strain", "", "how far the upper wall has come down, over the first height"},
      {"kinetic_energy", "energy", "energy of motion"},
      {"shape_energy", "energy", "energy of shapes"},
      {"contact_energy", "energy", "energy stored in contacts"},
      {"tangential_energy", "energy", "energy stored in tangential springs"},
      {"wall_energy", "energy", "energy stored in contacts with walls"},
      {"external_energy", "energy", "energy in gravity and tethers"},
  };
  return known;
}

void describe_number(h5::Object& made, const std::string& name, const Units& units) {
  const bool reduced = units.name == reduced_units().name;
  const std::string pressure = reduced ? "pressure_unit" : unit_text(units, units.stress(), "Pa");
  const std::string energy = unit_text(units, units.torque(), "J/m");
  for (const Column& known : known_numbers())
    if (known.name == name) {
      made.set("unit", known.unit == "pressure" ? pressure : known.unit == "energy" ? energy : known.unit);
      made.set("meaning", known.meaning);
    }
  if (name.find("stress_") == name.npos) return;
  made.set("unit", pressure);
  made.set("meaning", (name.starts_with("contact_") ? std::string("of contacts alone: ") : "") + component);
}

void write_body_numbers(h5::Group group, const std::vector<Frame>& frames, const Units& units) {
  for (const auto& [name, first] : frames[0].body) {
    write_rows<double>(group, name.c_str(), {first.size()}, "", stacked<double>(frames, [&](const Frame& f) {
                         return std::span<const double>(f.body.at(name));
                       }));
    h5::Object made = group.open_dataset(name);
    describe_number(made, name, units);
  }
}

void write_system_numbers(h5::Group group, const std::vector<Frame>& frames, const Units& units) {
  for (const auto& [name, first] : frames[0].numbers) {
    std::vector<double> values;
    for (const Frame& f : frames) values.push_back(f.numbers.at(name));
    h5::Object made = group.write(name, values);
    describe_number(made, name, units);
  }
}

/// Reads the arrays of frame k, each of which must have its place and shape in it.
struct FrameReader {
  const h5::Group& frames;
  std::uint64_t k, count, sites;

  /// One row of an array with these lengths behind the first.
  template <class T>
  std::vector<T> row(const h5::Group& group, const std::string& name, const h5::Shape& lengths) const {
    h5::Shape expected{count};
    expected.insert(expected.end(), lengths.begin(), lengths.end());
    expect_run(group.shape(name) == expected, group, name + " has another shape than the frames");
    return group.read_rows<T>(name, k, 1);
  }
  template <class T>
  T number(const char* name) const {
    return row<T>(frames, name, {}).at(0);
  }
  std::vector<double> numbers(const char* name) const { return row<double>(frames, name, {sites}); }
  std::vector<Vec2> vectors(const char* name) const {
    return vectors_from<2>(row<double>(frames, name, {sites, 2}));
  }
};

/// Codes of an enum with values 0 ... most.
template <class Enum>
std::vector<Enum> known_enums(const std::vector<std::uint8_t>& codes, Enum most, const h5::Group& group) {
  for (const std::uint8_t code : codes)
    expect_run(code <= static_cast<std::uint8_t>(most), group, "a code without a meaning");
  return enums_from<Enum>(codes);
}

std::vector<ContactRow> read_contacts(const FrameReader& reader, std::int64_t contacts) {
  const h5::Group& frames = reader.frames;
  const auto begin = static_cast<std::uint64_t>(reader.number<std::int64_t>("contact_begin") - contacts);
  const auto count = static_cast<std::uint64_t>(reader.number<std::int64_t>("contact_count"));
  const auto column = [&]<class T>(T, const char* name, std::uint64_t width = 1) {
    const h5::Shape shape = frames.shape(name);
    expect_run(shape.size() == (width > 1 ? 2u : 1u) && (width == 1 || shape[1] == width), frames,
               std::string(name) + " has another shape than contacts");
    return frames.read_rows<T>(name, begin, count);
  };
  const auto first = column(std::int32_t{}, "contact_first"),
             second = column(std::int32_t{}, "contact_second");
  const auto state = known_enums(column(std::uint8_t{}, "contact_state"), ContactState::permanent, frames);
  const auto elongation = column(double{}, "contact_elongation"),
             back = column(double{}, "contact_elongation_back");
  const auto normal = column(double{}, "contact_normal_force"),
             tangential = column(double{}, "contact_tangential_force");
  std::vector<double> elastic(count), viscous(count);
  std::vector<Vec2> force(count);
  if (frames.has("contact_force")) {  // not in older files
    elastic = column(double{}, "contact_elastic_force");
    viscous = column(double{}, "contact_viscous_force");
    force = vectors_from<2>(column(double{}, "contact_force", 2));
  }
  std::vector<ContactRow> out;
  for (std::size_t c = 0; c < count; ++c) {
    expect_run(0 <= first[c] && first[c] < second[c] && second[c] < static_cast<std::int64_t>(reader.sites),
               frames, "a contact of sites that do not exist");
    out.push_back({first[c], second[c], state[c], elongation[c], back[c], normal[c], tangential[c],
                   elastic[c], viscous[c], force.at(c)});
  }
  return out;
}

}  // namespace

void write_frames(h5::Group& root, const std::vector<Frame>& frames, const Units& units,
                  std::int64_t contacts) {
  if (frames.empty()) return;
  h5::Group group = root.create_group("frames");
  const auto discs = static_cast<std::uint64_t>(frames[0].position.size());
  const auto scalar = [&]<class T>(T Frame::*member, const char* name, const std::string& unit) {
    write_rows<T>(group, name, {}, unit,
                  stacked<T>(frames, [&](const Frame& f) { return std::span<const T>(&(f.*member), 1); }));
  };
  const auto vectors = [&](std::vector<Vec2> Frame::*member, const char* name, const std::string& unit) {
    write_rows<double>(group, name, {discs, 2}, unit,
                       stacked<double>(frames, [&](const Frame& f) { return flat(f.*member); }));
  };
  const auto numbers = [&](std::vector<double> Frame::*member, const char* name, const std::string& unit) {
    write_rows<double>(group, name, {discs}, unit, stacked<double>(frames, [&](const Frame& f) {
                         return std::span<const double>(f.*member);
                       }));
  };
  scalar(&Frame::step, "step", "");
  scalar(&Frame::time, "time", unit_text(units, units.time, "s"));
  scalar(&Frame::strain, "strain", "");
  scalar(&Frame::strain_rate, "strain_rate", unit_text(units, 1 / units.time, "1/s"));
  vectors(&Frame::position, "position", unit_text(units, units.length, "m"));
  vectors(&Frame::velocity, "velocity", unit_text(units, units.speed(), "m/s"));
  vectors(&Frame::force, "force", unit_text(units, units.force(), "N/m"));
  numbers(&Frame::angle, "angle", "rad");
  numbers(&Frame::spin, "spin", unit_text(units, 1 / units.time, "rad/s"));
  numbers(&Frame::torque, "torque", unit_text(units, units.torque(), "N"));
  write_rows<std::uint8_t>(group, "mobility", {discs}, "0 free, 1 lower plate, 2 upper plate, 3 fixed",
                           stacked<std::uint8_t>(frames, [](const Frame& f) { return codes(f.mobility); }));
  write_rows<double>(
      group, "length", {2}, unit_text(units, units.length, "m"),
      stacked<double>(frames, [](const Frame& f) { return std::span<const double>(f.length.e); }));
  write_contacts(group, frames, units, contacts);
  if (!frames[0].body.empty()) write_body_numbers(group.create_group("body"), frames, units);
  if (!frames[0].numbers.empty()) write_system_numbers(group.create_group("system"), frames, units);
}

Frame read_frame(const h5::Group& frames, std::uint64_t k, std::int64_t contacts, const RunInfo& info) {
  const h5::Shape steps = frames.shape("step");
  expect_run(steps.size() == 1 && k < steps[0], frames, "frames are missing");
  const FrameReader reader{frames, k, steps[0], info.radius.size()};
  Frame frame;
  frame.step = reader.number<std::int64_t>("step");
  frame.time = reader.number<double>("time");
  frame.strain = reader.number<double>("strain");
  frame.strain_rate = reader.number<double>("strain_rate");
  frame.position = reader.vectors("position");
  frame.velocity = reader.vectors("velocity");
  frame.force = reader.vectors("force");
  frame.angle = reader.numbers("angle");
  frame.spin = reader.numbers("spin");
  frame.torque = reader.numbers("torque");
  frame.mobility =
      known_enums(reader.row<std::uint8_t>(frames, "mobility", {reader.sites}), Mobility::fixed, frames);
  if (frames.has("length")) frame.length = vectors_from<2>(reader.row<double>(frames, "length", {2})).at(0);
  if (frame.length == Vec2{}) frame.length = info.box.length;  // as in files of older versions
  expect_run(is_cell(frame.length) && std::abs(frame.strain) < far_away, frames, "a cell that is none");
  const double extent = far_away * (frame.length[0] + frame.length[1]);
  for (const Vec2& x : frame.position)
    expect_run(std::abs(x[0]) < extent && std::abs(x[1]) < extent, frames,
               "a position that is not finite, or far away");

  if (frames.has("body")) {
    const h5::Group body = frames.open_group("body");
    const std::uint64_t bodies = info.body_begin.empty() ? reader.sites : info.body_begin.size() - 1;
    for (const std::string& name : body.names()) frame.body[name] = reader.row<double>(body, name, {bodies});
  }
  if (frames.has("system")) {
    const h5::Group all = frames.open_group("system");
    for (const std::string& name : all.names()) frame.numbers[name] = reader.row<double>(all, name, {}).at(0);
  }
  frame.contacts = read_contacts(reader, contacts);
  return frame;
}

}  // namespace supple
