#include "supple/io/state/state_file.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <tuple>

#include "supple/core/error.hpp"
#include "supple/core/path_kind.hpp"
#include "supple/experiment/energy_table.hpp"
#include "supple/io/hdf5/hdf5.hpp"
#include "supple/io/run/run_file.hpp"
#include "supple/io/state/held_keys_json.hpp"
#include "supple/model/convert.hpp"

namespace supple {
namespace {

using Node = JsonNode;

constexpr const char* protocol_numbers[] = {
    "dt", "cool_factor", "steps", "f", "amplitude", "pre", "periods", "post", "removed_stress"};

// Reading.

/// Plates take the discs that touch them, as in the published package: free are those with r < y < Ly - r.
Mobility mobility_at(double y, double radius, double height) {
  if (radius < y && y < height - radius) return Mobility::free;
  return y > 0.5 * height ? Mobility::upper_plate : Mobility::lower_plate;
}

/// Where one sphere has accelerations, all have.
void read_accelerations(const Node& spheres, Acceleration<2>& out) {
  if (spheres.size() == 0 || !spheres[0].has("ax")) return;
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    out.site.push_back({spheres[i].at("ax").number(), spheres[i].at("ay").number()});
    out.spin.push_back(spheres[i].at("alpha").number());
  }
}

void read_spheres(const Node& spheres, InitialState& out) {
  State<2>& state = system_of<2>(out).state;
  const auto n = static_cast<int>(spheres.size());
  if (n == 0) throw spheres.fault("is empty");
  state.resize(n);
  Evaluation<2> forces;
  forces.force.resize(static_cast<std::size_t>(n));
  forces.torque.resize(static_cast<std::size_t>(n));
  bool any_force = false;
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const Node s = spheres[i];
    state.position[i] = {s.at("x").number(), s.at("y").number()};
    state.velocity[i] = {s.at("vx").number(), s.at("vy").number()};
    state.angle[i] = s.at("phi").number();
    state.spin[i] = s.at("omega").number();
    state.radius[i] = s.at("r").positive();
    state.mass[i] = s.at("m").positive();
    state.inertia[i] = s.at("inertia").positive();
    if (!s.has("fx")) continue;
    any_force = true;
    forces.force[i] = {s.at("fx").number(), s.at("fy").number()};
    forces.torque[i] = s.at("torque").number();
  }
  if (any_force) out.evaluation = std::move(forces);
  read_accelerations(spheres, system_of<2>(out).acceleration);
}

ContactState contact_state(const Node& type) {
  const std::string name = type.text();
  if (name == "stick") return ContactState::stick;
  if (name == "slip") return ContactState::slip;
  if (name == "permanent") return ContactState::permanent;
  throw type.fault("is \"" + name + "\", not stick, slip or permanent");
}

/// One entry of a neighbour list: what `from` says of `to`.
struct Neighbor {
  int from, to;
  ContactState state;
  double elongation;
  std::string where;
  RowImage image;  ///< as `from` sees it; not in states of the package
};

RowImage read_image(const Node& image) {
  if (image.size() != 2) throw image.fault("is not a pair of cells");
  RowImage out;
  out.kept = true;
  for (std::size_t d = 0; d < 2; ++d) {
    const double cells = image[d].number();
    if (cells != std::floor(cells) || std::abs(cells) > 1e9) throw image[d].fault("is not a number of cells");
    out.cells[d] = static_cast<std::int32_t>(cells);
  }
  return out;
}

Neighbor read_neighbor(const Node& entry, int from, const State<2>& state) {
  const Node j = entry.at("j");
  const double to = j.number();
  if (to != std::floor(to) || to < 0 || to >= state.size() || to == from)
    throw j.fault("is not the number of another sphere");
  const Neighbor out{from,
                     static_cast<int>(to),
                     contact_state(entry.at("type")),
                     entry.at("fp").number(),
                     "neighbors[" + std::to_string(from) + "]",
                     entry.has("image") ? read_image(entry.at("image")) : RowImage{}};
  const double rest =
      state.radius[static_cast<std::size_t>(from)] + state.radius[static_cast<std::size_t>(out.to)];
  if (const Node eq = entry.at("eq");
      out.state == ContactState::permanent && std::abs(eq.number() - rest) > 1e-9 * rest)
    throw eq.fault("is not the sum of the radii (" + std::to_string(rest) + ")");
  return out;
}

/// Both spheres of a pair list each other; the lists become rows first < second.
void read_neighbors(const Node& lists, System<2>& system) {
  const int n = system.state.size();
  if (static_cast<int>(lists.size()) != n) throw lists.fault("has not one list for each sphere");
  std::vector<Neighbor> entries;
  for (std::size_t i = 0; i < lists.size(); ++i)
    for (std::size_t k = 0; k < lists[i].size(); ++k)
      entries.push_back(read_neighbor(lists[i][k], static_cast<int>(i), system.state));
  const auto key = [](const Neighbor& e) {
    return std::tuple(std::min(e.from, e.to), std::max(e.from, e.to), e.from > e.to);
  };
  std::sort(entries.begin(), entries.end(),
            [&](const Neighbor& a, const Neighbor& b) { return key(a) < key(b); });

  PairTable& pairs = system.pairs;
  pairs.width = 2;
  pairs.begin.assign(static_cast<std::size_t>(n) + 1, 0);
  for (std::size_t e = 0; e < entries.size(); e += 2) {
    const Neighbor& own = entries[e];
    const auto pair_name = std::to_string(own.from) + " and " + std::to_string(own.to);
    if (e + 1 == entries.size() || entries[e + 1].from != own.to || entries[e + 1].to != own.from)
      throw lists.fault("is inconsistent: spheres " + pair_name + " do not list each other exactly once");
    if (entries[e + 1].state != own.state)
      throw lists.fault("is inconsistent: spheres " + pair_name + " give different types");
    pairs.first.push_back(own.from);
    pairs.second.push_back(own.to);
    pairs.state.push_back(own.state);
    pairs.image.push_back(own.image);
    pairs.history.insert(pairs.history.end(), {own.elongation, entries[e + 1].elongation});
    ++pairs.begin[static_cast<std::size_t>(own.from) + 1];
  }
  for (std::size_t i = 1; i < pairs.begin.size(); ++i) pairs.begin[i] += pairs.begin[i - 1];
  if (std::find_if(pairs.image.begin(), pairs.image.end(), [](const RowImage& i) { return i.kept; }) ==
      pairs.image.end())
    pairs.image.clear();
}

bool holds(const HeldKeys& keys, const std::string& key, const KeyValue& value) {
  const auto at = keys.find(key);
  return at != keys.end() && at->second == value;
}

/// Laws and sample by name: those of the file, and what the layout of the package says in its own way.
HeldKeys read_keys(const Node& root, const Node& params) {
  HeldKeys keys = read_held_keys(root);
  if (params.has("applyingShear"))
    keys.emplace("box.plates", params.at("applyingShear").truth() ? "capture" : "none");
  return keys;
}

InitialState read_json(const std::string& path) {
  const Json json = parse_json(path, "a state");
  const Node root(json, path);
  if (root.has("particles") && !root.has("initial"))
    throw root.fault(
        "is a packing of deformable particles: start from it by initial.packing, not initial.state;");
  InitialState out;
  out.units = particleshear_units();

  const Node params = root.at("params");
  System<2>& system = system_of<2>(out);
  system.box.length = {params.at("size_x").positive(), params.at("size_y").positive()};
  for_each_constant(out.material, [&]<class T>(const char* name, std::optional<T>& constant) {
    if (!params.has(name)) return;
    if constexpr (std::is_same_v<T, bool>) constant = params.at(name).truth();
    else constant = params.at(name).number();
  });
  out.keys = read_keys(root, params);
  if (root.has("reset_force_each_step")) out.reset_force_each_step = root.at("reset_force_each_step").truth();
  for (const char* name : protocol_numbers)
    if (root.has(name)) out.protocol[name] = root.at(name).number();
  for (const std::string& name : account_numbers())
    if (root.has(name)) out.protocol[name] = root.at(name).number();

  const Node initial = root.at("initial");
  system.time = initial.at("t").number();
  if (initial.has("lag")) system.lag = initial.at("lag").number();
  system.box.strain = initial.at("shear").number();
  system.box.strain_rate = initial.at("shear_rate").number();
  read_spheres(initial.at("spheres"), out);
  read_neighbors(initial.at("neighbors"), system);
  State<2>& state = system.state;
  if (holds(out.keys, "box.boundary", "fixed")) system.box.periodic = {false, false};
  else if (holds(out.keys, "box.plates", "capture") && !holds(out.keys, "box.boundary", "periodic"))
    for (std::size_t i = 0; i < state.radius.size(); ++i)
      state.mobility[i] =
          mobility_at(state.position[i][gradient], state.radius[i], system.box.length[gradient]);
  return out;
}

template <int Dim>
void take_final_state(const RunFile& run, InitialState& out) {
  out.units = run.info<Dim>().units;
  auto [system, evaluation] = run.final_state<Dim>();
  out.system = std::move(system);
  out.evaluation = std::move(evaluation);
}

InitialState read_run(const std::string& path) {
  const RunFile run(path);
  InitialState out;
  if (run.dimensions() == 2) take_final_state<2>(run, out);
  else take_final_state<3>(run, out);
  for_each_constant(out.material, [&]<class T>(const char* name, std::optional<T>& constant) {
    if (const auto value = run.find_value(material_group, name)) constant = static_cast<T>(*value);
  });
  if (const auto stiffness = run.find_value(material_group, contact_stiffness))
    out.contact = Harmonic{*stiffness, run.value(material_group, contact_is_relative) != 0};
  out.keys = held_keys(run.resolved_case());
  for_each_wall<3>(out.environment, [&](const char* name, bool& stands) {
    if (const auto value = run.find_value(environment_group, name)) stands = *value != 0;
  });
  if (const auto g = run.find_value(environment_group, "gravity")) out.environment.gravity[gradient] = -*g;
  for (const RunValue& v : run.values(protocol_group)) {
    if (v.name.name == "applying_shear") {  // as older versions wrote it
      if (v.value == 0) out.keys["box.plates"] = "none";
    } else if (v.name.name == "reset_force_each_step") out.reset_force_each_step = v.value != 0;
    else out.protocol[v.name.name] = v.value;
  }
  return out;
}

// Writing.

const char* type_name(ContactState state) {
  return state == ContactState::permanent ? "permanent" : state == ContactState::slip ? "slip" : "stick";
}

Json sphere_json(const State<2>& s, std::size_t i) {
  return {{"x", s.position[i][0]},  {"y", s.position[i][1]}, {"vx", s.velocity[i][0]},
          {"vy", s.velocity[i][1]}, {"phi", s.angle[i]},     {"omega", s.spin[i]},
          {"r", s.radius[i]},       {"m", s.mass[i]},        {"inertia", s.inertia[i]}};
}

void add_forces(Json& sphere, const Evaluation<2>& e, std::size_t i, const Units& units) {
  const Units to = particleshear_units();
  sphere["fx"] = e.force[i][0] * (units.force() / to.force());
  sphere["fy"] = e.force[i][1] * (units.force() / to.force());
  sphere["torque"] = e.torque[i] * (units.torque() / to.torque());
}

Json neighbors_json(const System<2>& system) {
  std::vector<Json> lists(system.state.radius.size(), Json::array());
  const PairTable& pairs = system.pairs;
  for (std::size_t r = 0; r < pairs.first.size(); ++r) {
    if (pairs.state[r] == ContactState::open) continue;
    const auto i = static_cast<std::size_t>(pairs.first[r]), j = static_cast<std::size_t>(pairs.second[r]);
    const auto width = static_cast<std::size_t>(pairs.width);
    const double rest =
        pairs.state[r] == ContactState::permanent ? system.state.radius[i] + system.state.radius[j] : 0;
    const auto entry = [&](std::size_t other, double elongation, int side) {
      Json e{{"j", other}, {"type", type_name(pairs.state[r])}, {"fp", elongation}, {"eq", rest}};
      if (!pairs.image.empty() && pairs.image[r].kept)
        e["image"] = {side * pairs.image[r].cells[0], side * pairs.image[r].cells[1]};
      return e;
    };
    lists[i].push_back(entry(j, pairs.history[width * r], 1));
    lists[j].push_back(entry(i, pairs.history[width * r + width - 1], -1));
  }
  return lists;
}

/// Springs are force/length and viscosities force/speed, per depth; the rest are numbers.
MaterialConstants converted(MaterialConstants m, const Units& from, const Units& to) {
  for (auto* spring : {&m.k, &m.k_t})
    if (*spring) **spring *= from.stiffness() / to.stiffness();
  for (auto* viscosity : {&m.nu, &m.nu_t})
    if (*viscosity) **viscosity *= from.viscosity() / to.viscosity();
  return m;
}

}  // namespace

InitialState read_state(const std::string& path) {
  const PathKind kind = path_kind(path);
  const bool hdf5_or_no_file =
      kind == PathKind::folder || kind == PathKind::nothing ||
      (kind == PathKind::file && std::ifstream(path, std::ios::binary).peek() == 0x89);
  return hdf5_or_no_file ? read_run(path) : read_json(path);
}

void write_state_json(const InitialState& state, const std::string& path, Existing existing) {
  System<2> system = system_of<2>(state);
  convert(system, state.units, particleshear_units());
  Json params{{"size_x", system.box.length[0]}, {"size_y", system.box.length[1]}};
  const MaterialConstants material = converted(state.material, state.units, particleshear_units());
  for_each_constant(material, [&](const char* name, const auto& constant) {
    if (constant) params[name] = *constant;
  });
  if (state.keys.count("box.plates") > 0)
    params["applyingShear"] = holds(state.keys, "box.plates", "capture");

  Json spheres = Json::array();
  for (std::size_t i = 0; i < system.state.radius.size(); ++i) {
    spheres.push_back(sphere_json(system.state, i));
    if (system.knows_acceleration()) {
      spheres.back()["ax"] = system.acceleration.site[i][0];
      spheres.back()["ay"] = system.acceleration.site[i][1];
      spheres.back()["alpha"] = system.acceleration.spin[i];
    }
    if (const auto* forces = evaluation_of<2>(state)) add_forces(spheres.back(), *forces, i, state.units);
  }
  Json root{{"params", params},
            {"reset_force_each_step", state.reset_force_each_step},
            {"initial",
             {{"t", system.time},
              {"lag", system.lag},
              {"shear", system.box.strain},
              {"shear_rate", system.box.strain_rate},
              {"spheres", spheres},
              {"neighbors", neighbors_json(system)}}}};
  if (!state.keys.empty()) root[held_keys_name] = held_keys_json(state.keys);
  for (const auto& [name, value] : state.protocol) root[name] = value;
  NewFile file(path, existing);
  file.write(root.dump(1));
  file.write("\n");
  file.commit();
}

}  // namespace supple
