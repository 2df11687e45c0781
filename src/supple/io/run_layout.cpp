#include "supple/io/run_layout.hpp"

#include <fmt/format.h>

#include "supple/core/error.hpp"
#include "supple/io/array_views.hpp"
#include "supple/io/system_archive.hpp"

namespace supple {
namespace {

/// "m/s" in SI units, "1e-06 m/s" in others, nothing where a run has no units.
std::string unit_text(const Units& units, double in_si, const char* si) {
  if (units.name == reduced_units().name) return "";
  return in_si == 1 ? si : fmt::format("{} {}", in_si, si);
}

template <class Section>
std::string attribute_name(const std::string& section, const Field<Section>& field) {
  return (section.empty() ? "" : section + ".") + std::string(field.name);
}

void store_case(h5::Object& dataset, const Case& c) {
  for_each_section(c, [&](const std::string& section, const auto& values) {
    using Section = std::decay_t<decltype(values)>;
    for (const Field<Section>& field : fields<Section>())
      std::visit([&](auto member) {
        using Value = std::decay_t<decltype(values.*member)>;
        if constexpr (std::is_integral_v<Value>)
          dataset.set(attribute_name(section, field), static_cast<std::int64_t>(values.*member));
        else
          dataset.set(attribute_name(section, field), values.*member);
      }, field.member);
  });
}

/// One array of a frame: per disc (`width` numbers each) or, with width 0, one number.
template <class T>
void append(h5::Group& group, const char* name, const h5::Shape& row, const std::string& unit,
            std::span<const T> values) {
  if (!group.has(name)) {
    h5::Object made = group.create_rows<T>(name, row);
    if (!unit.empty()) made.set("unit", unit);
  }
  group.append_rows(name, values);
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

void append_contacts(h5::Group& group, const std::vector<Frame>& frames, const Units& units, std::int64_t contacts) {
  std::vector<std::int64_t> begin, count;
  for (const Frame& frame : frames) {
    begin.push_back(contacts);
    count.push_back(static_cast<std::int64_t>(frame.contacts.size()));
    contacts += count.back();
  }
  const std::string length = unit_text(units, units.length, "m"), force = unit_text(units, units.force(), "N/m");
  const auto column = [&]<class T>(T, const char* name, const std::string& unit, auto member) {
    append<T>(group, name, {}, unit, contact_column<T>(frames, [&](const ContactRow& c) { return c.*member; }));
  };
  append<std::int64_t>(group, "contact_begin", {}, "", begin);
  append<std::int64_t>(group, "contact_count", {}, "", count);
  column(std::int32_t{}, "contact_first", "", &ContactRow::first);
  column(std::int32_t{}, "contact_second", "", &ContactRow::second);
  column(std::uint8_t{}, "contact_state", "0 open, 1 stick, 2 slip, 3 permanent", &ContactRow::state);
  column(double{}, "contact_elongation", length, &ContactRow::elongation);
  column(double{}, "contact_elongation_back", length, &ContactRow::elongation_back);
  column(double{}, "contact_normal_force", force, &ContactRow::normal_force);
  column(double{}, "contact_tangential_force", force, &ContactRow::tangential_force);
}

/// Unit and meaning of the numbers of bodies that experiments write.
const std::vector<Column>& known_body_numbers() {
  static const std::vector<Column> known{
      {"pressure", "pressure_unit", "pressure of the body, compression positive (9.27)"},
      {"area", "", "area that the body covers"},
      {"shape_parameter", "", "p^2/(4 pi a); 0 for discs"},
      {"contacts", "", "bodies and walls that it touches"},
      {"rattler", "", "1: held by too few contacts to bear pressure"},
  };
  return known;
}

void append_body_numbers(h5::Group group, const std::vector<Frame>& frames) {
  for (const auto& [name, first] : frames[0].body) {
    const bool is_new = !group.has(name);
    append<double>(group, name.c_str(), {first.size()}, "", stacked<double>(frames, [&](const Frame& f) {
      return std::span<const double>(f.body.at(name));
    }));
    if (!is_new) continue;
    for (const Column& known : known_body_numbers())
      if (known.name == name) {
        h5::Object made = group.open_dataset(name);
        made.set("unit", known.unit);
        made.set("meaning", known.meaning);
      }
  }
}

}  // namespace

std::string partial_folder(const std::string& path) { return path + ".partial"; }
std::string segment_name(int index) { return fmt::format("segment-{:06}.h5", index); }

void write_header(h5::Group& root, const Case& resolved, const std::string& case_text, const RunInfo& info) {
  root.set("format", std::string(run_format));
  root.set("supple_version", std::string(SUPPLE_VERSION));
  root.set("compiler", std::string(__VERSION__));
  root.set("experiment", resolved.general.experiment);
  root.set("physics", resolved.general.physics);
  root.set("seed", resolved.general.seed);
  root.set("units", info.units.name);
  root.set("unit_length", info.units.length);
  root.set("unit_mass", info.units.mass);
  root.set("unit_time", info.units.time);
  root.set("sign_of_stress", std::string("compression positive"));
  root.set("definition_of_strain", std::string("time integral of the shear rate: displacement of the upper image along "
                                               "x over the height of the cell; 0.2 is 20 %"));
  root.set("definition_of_phase",
           std::string("strain = A sin(2 pi (f t - pre_periods)); storage modulus: in phase with "
                       "the strain (sin), loss modulus: with its rate (cos)"));
  h5::Object stored = root.write_scalar("case", case_text);
  store_case(stored, resolved);

  h5::Group box = root.create_group("box");
  write_box(box, info.box);
  h5::Group discs = root.create_group("discs");
  discs.write("radius", info.radius).set("unit", unit_text(info.units, info.units.length, "m"));
  discs.write("mass", info.mass).set("unit", unit_text(info.units, info.units.mass, "kg/m"));
  discs.write("inertia", info.inertia).set("unit", unit_text(info.units, info.units.inertia(), "kg m"));
  discs.write("particle", info.particle)
      .set("meaning",
           info.body_begin.empty() ? "crosslinked particle of the disc, from 0" : "body of the site, from 0");
  if (!info.body_begin.empty())
    discs.write("body_begin", info.body_begin).set("meaning", "sites [k, k + 1) of these form body k");
}

RunInfo read_info(const h5::Group& root) {
  RunInfo info;
  info.units = {root.text("units"), root.number("unit_length"), root.number("unit_mass"), root.number("unit_time")};
  info.box = read_box<2>(root.open_group("box"));
  const h5::Group discs = root.open_group("discs");
  info.radius = discs.read<double>("radius");
  info.mass = discs.read<double>("mass");
  info.inertia = discs.read<double>("inertia");
  info.particle = discs.read<std::int32_t>("particle");
  if (discs.has("body_begin")) info.body_begin = discs.read<std::int32_t>("body_begin");
  return info;
}

Case read_stored_case(const h5::Group& root) {
  Case c;
  const h5::Object dataset = root.open_dataset("case");
  for_each_section(c, [&](const std::string& section, auto& values) {
    using Section = std::decay_t<decltype(values)>;
    for (const Field<Section>& field : fields<Section>()) {
      const std::string name = attribute_name(section, field);
      if (!dataset.has_attribute(name)) continue;  // a key that is younger than the file
      std::visit([&](auto member) {
        using Value = std::decay_t<decltype(values.*member)>;
        if constexpr (std::is_same_v<Value, std::string>) values.*member = dataset.text(name);
        else if constexpr (std::is_same_v<Value, double>) values.*member = dataset.number(name);
        else values.*member = static_cast<Value>(dataset.integer(name));
      }, field.member);
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

void append_frames(h5::Group& root, const std::vector<Frame>& frames, const Units& units, std::int64_t contacts) {
  if (frames.empty()) return;
  h5::Group group = root.has("frames") ? root.open_group("frames") : root.create_group("frames");
  const auto discs = static_cast<std::uint64_t>(frames[0].position.size());
  const auto scalar = [&]<class T>(T Frame::*member, const char* name, const std::string& unit) {
    append<T>(group, name, {}, unit,
              stacked<T>(frames, [&](const Frame& f) { return std::span<const T>(&(f.*member), 1); }));
  };
  const auto vectors = [&](std::vector<Vec2> Frame::*member, const char* name, const std::string& unit) {
    append<double>(group, name, {discs, 2}, unit,
                   stacked<double>(frames, [&](const Frame& f) { return flat(f.*member); }));
  };
  const auto numbers = [&](std::vector<double> Frame::*member, const char* name, const std::string& unit) {
    append<double>(group, name, {discs}, unit,
                   stacked<double>(frames, [&](const Frame& f) { return std::span<const double>(f.*member); }));
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
  append<std::uint8_t>(group, "mobility", {discs}, "0 free, 1 lower plate, 2 upper plate, 3 fixed",
                       stacked<std::uint8_t>(frames, [](const Frame& f) { return codes(f.mobility); }));
  append<double>(group, "length", {2}, unit_text(units, units.length, "m"),
                 stacked<double>(frames, [](const Frame& f) { return std::span<const double>(f.length.e); }));
  append_contacts(group, frames, units, contacts);
  if (!frames[0].body.empty())
    append_body_numbers(group.has("body") ? group.open_group("body") : group.create_group("body"), frames);
}

Frame read_frame(const h5::Group& frames, std::uint64_t k, std::int64_t contacts) {
  Frame frame;
  const auto number = [&](const char* name) { return frames.read_rows<double>(name, k, 1).at(0); };
  const auto numbers = [&](const char* name) { return frames.read_rows<double>(name, k, 1); };
  frame.step = frames.read_rows<std::int64_t>("step", k, 1).at(0);
  frame.time = number("time");
  frame.strain = number("strain");
  frame.strain_rate = number("strain_rate");
  frame.position = vectors_from<2>(numbers("position"));
  frame.velocity = vectors_from<2>(numbers("velocity"));
  frame.force = vectors_from<2>(numbers("force"));
  frame.angle = numbers("angle");
  frame.spin = numbers("spin");
  frame.torque = numbers("torque");
  frame.mobility = enums_from<Mobility>(frames.read_rows<std::uint8_t>("mobility", k, 1));

  if (frames.has("length")) frame.length = vectors_from<2>(numbers("length")).at(0);
  if (frames.has("body")) {
    const h5::Group body = frames.open_group("body");
    for (const std::string& name : body.names()) frame.body[name] = body.read_rows<double>(name, k, 1);
  }

  const auto begin = static_cast<std::uint64_t>(frames.read_rows<std::int64_t>("contact_begin", k, 1).at(0) - contacts);
  const auto count = static_cast<std::uint64_t>(frames.read_rows<std::int64_t>("contact_count", k, 1).at(0));
  const auto column = [&]<class T>(T, const char* name) { return frames.read_rows<T>(name, begin, count); };
  const auto first = column(std::int32_t{}, "contact_first"), second = column(std::int32_t{}, "contact_second");
  const auto state = enums_from<ContactState>(column(std::uint8_t{}, "contact_state"));
  const auto elongation = column(double{}, "contact_elongation"), back = column(double{}, "contact_elongation_back");
  const auto normal = column(double{}, "contact_normal_force"),
             tangential = column(double{}, "contact_tangential_force");
  for (std::size_t c = 0; c < count; ++c)
    frame.contacts.push_back({first[c], second[c], state[c], elongation[c], back[c], normal[c], tangential[c]});
  return frame;
}

}  // namespace supple
