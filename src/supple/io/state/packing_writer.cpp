#include "supple/io/state/packing_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "supple/energy/perimeter.hpp"
#include "supple/io/state/held_keys_json.hpp"
#include "supple/model/polygons.hpp"

namespace supple {

namespace {

[[noreturn]] void refuse(const std::string& why) {
  throw input_error("cannot write this packing as JSON", why);
}

std::span<const double> rests_of(const std::vector<double>& rest, const std::vector<std::int32_t>& begin,
                                 int b) {
  return {&rest[begin[b]], static_cast<std::size_t>(begin[b + 1] - begin[b])};
}

bool all_equal(std::span<const double> values) {
  return std::all_of(values.begin(), values.end(), [&](double v) { return v == values[0]; });
}

/// The stiffness of body b as a file of this kind has it; nothing where the kind cannot say it.
std::optional<ShapeSpec> spec_of(const System<2>& system, int b, StiffnessKind kind) {
  const ShapeStiffness& k = system.shape.stiffness[b];
  ShapeSpec spec{k.volume, k.facet, k.hinge, k.tension, kind};
  if (kind == StiffnessKind::absolute) return spec;
  const std::span<const double> lengths = rests_of(system.shape.rest_facet, system.topology.facet_begin, b);
  if (!all_equal(lengths)) return std::nullopt;
  const double a0 = system.shape.rest_volume[b], l0 = lengths[0];
  spec.area *= a0 * a0;
  spec.length *= l0 * l0;
  spec.tension *= static_cast<double>(lengths.size()) * l0;
  return spec;
}

bool nearly(double x, double y) { return std::abs(x - y) <= 1e-12 * std::abs(y); }

bool is_rigid(const System<2>& system, int b) {
  return std::binary_search(system.rigid.body.begin(), system.rigid.body.end(), b);
}

bool is_soft(const System<2>& system, int b) {
  return system.topology.body_size(b) >= 3 && !is_rigid(system, b);
}

/// The stiffness of each body that is soft, in this kind; nothing where the kind cannot say one of them.
std::optional<std::map<int, ShapeSpec>> specs_of(const System<2>& system, StiffnessKind kind) {
  std::map<int, ShapeSpec> all;
  for (int b = 0; b < system.topology.body_count(system.state.size()); ++b) {
    if (!is_soft(system, b)) continue;
    const std::optional<ShapeSpec> own = spec_of(system, b, kind);
    if (!own) return std::nullopt;
    all.emplace(b, *own);
  }
  return all;
}

/// A product of squares and their inverses, back at the short number that it was made of.
double shortened(double k) {
  const double round = std::stod(fmt::format("{:.12g}", k));
  return std::abs(round - k) <= 1e-15 * std::abs(k) ? round : k;
}

Json number_or_list(std::span<const double> values) {
  if (all_equal(values)) return values[0];
  return std::vector<double>(values.begin(), values.end());
}

Json particle_json(const System<2>& system, int b) {
  const int begin = system.topology.body_begin(b), end = system.topology.body_end(b);
  for (int i = begin + 1; i < end; ++i)
    if (system.state.radius[i] != system.state.radius[begin])
      refuse("a body has vertices of different sizes");
  Json particle{{"sigma", 2 * system.state.radius[begin]}};
  Json& x = particle["x"] = Json::array();
  for (int i = begin; i < end; ++i) x.push_back({system.state.position[i][0], system.state.position[i][1]});
  const auto sites = [&](const auto& values) { return std::span(values).subspan(begin, end - begin); };
  const auto moves = sites(system.state.velocity);
  if (std::any_of(moves.begin(), moves.end(), [](const Vec2& v) { return v != Vec2{}; }))
    for (const Vec2& v : moves) particle["v"].push_back({v[0], v[1]});
  if (!system.floor_contact.empty())
    if (const auto stuck = sites(system.floor_contact);
        !std::all_of(stuck.begin(), stuck.end(), [](double at) { return std::isnan(at); }))
      for (const double at : stuck) particle["sticks"].push_back(std::isnan(at) ? Json() : Json(at));
  if (end - begin == 1) return particle;
  if (is_rigid(system, b)) particle["rigid"] = true;
  particle["a0"] = system.shape.rest_volume[b];
  particle["l0"] = number_or_list(rests_of(system.shape.rest_facet, system.topology.facet_begin, b));
  particle["theta0"] = number_or_list(rests_of(system.shape.rest_hinge, system.topology.hinge_begin, b));
  return particle;
}

/// The stiffnesses in which a particle differs from what the file says of all.
void write_own_spec(const ShapeSpec& own, const ShapeSpec& common, Json& particle) {
  const auto write = [&](const char* key, double k, double of_all) {
    if (!nearly(k, of_all)) particle[key] = shortened(k);
  };
  write("k_a", own.area, common.area);
  write("k_l", own.length, common.length);
  write("k_b", own.bending, common.bending);
  write("gamma", own.tension, common.tension);
}

/// The terms of a particle beside its shape energy.
void write_terms(const System<2>& system, int b, StiffnessKind kind, Json& particle) {
  for (const BodyTermData& term : system.terms) {
    if (static_cast<std::size_t>(b) >= term.bodies()) continue;
    const double* numbers = &term.number[static_cast<std::size_t>(b) * term.width];
    if (std::all_of(numbers, numbers + term.width, [](double x) { return x == 0; })) continue;
    if (term.name != Perimeter::name) refuse("the layout has no " + term.name + " of particles");
    const double rest = numbers[1];
    particle["k_perimeter"] = shortened(numbers[0] * (kind == StiffnessKind::relative ? rest * rest : 1));
    particle["p0"] = rest;
  }
}

/// By what the sections [contact.A.B] call the species.
std::vector<std::string> names_of_species(const StoredPacking& packing) {
  const std::vector<std::int32_t>& species = packing.system.species;
  if (species.empty()) return {};
  const std::int32_t count = *std::max_element(species.begin(), species.end()) + 1;
  std::vector<std::string> names;
  for (std::int32_t k = 0; k < count; ++k) {
    const auto name = packing.keys.find(species_section(static_cast<std::size_t>(k)) + ".name");
    const auto* text = name == packing.keys.end() ? nullptr : std::get_if<std::string>(&name->second);
    names.push_back(text && !text->empty() ? *text : fmt::format("{}", k + 1));
  }
  return names;
}

void write_spec(const ShapeSpec& spec, Json& root) {
  root["k_a"] = shortened(spec.area);
  root["k_l"] = shortened(spec.length);
  root["k_b"] = spec.bending;
  if (spec.tension != 0) root["gamma"] = shortened(spec.tension);
  if (spec.kind == StiffnessKind::absolute) root["stiffness"] = "absolute";
}

void write_cell(const Box<2>& cell, Json& root) {
  if (cell.length[0] == cell.length[1]) root["box"] = cell.length[0];
  else root["box"] = {cell.length[0], cell.length[1]};
  if (cell.strain != 0) root["strain"] = cell.strain;
  if (!cell.periodic[0] || !cell.periodic[1]) root["periodic"] = {cell.periodic[0], cell.periodic[1]};
}

void write_environment(const Environment& e, Json& root) {
  if (e.gravity[gradient] != 0) root["gravity"] = -e.gravity[gradient];
  if (e.is_closed()) return;
  Json& walls = root["walls"] = Json::array();
  for_each_wall(e, [&](const char* name, bool stands) {
    if (stands) walls.push_back(name);
  });
}

}  // namespace

void write_packing_json(const StoredPacking& packing, const std::string& path, Existing existing) {
  const System<2>& system = packing.system;
  if (system.shape.empty()) refuse("its bodies have no preferred shapes");
  if (!system.links.empty()) refuse("its particles are crosslinked, and the layout has no links");
  StiffnessKind kind = StiffnessKind::relative;
  std::optional<std::map<int, ShapeSpec>> specs = specs_of(system, kind);
  if (!specs) specs = specs_of(system, kind = StiffnessKind::absolute);
  const ShapeSpec common =
      specs->empty() ? ShapeSpec{0, 0, 0, 0, StiffnessKind::relative} : specs->begin()->second;
  Json root;
  write_spec(common, root);
  root["k_c"] = packing.contact.stiffness;
  if (!packing.contact.relative) root["contact_stiffness"] = "absolute";
  write_cell(system.box, root);
  write_environment(packing.environment, root);
  if (const HeldKeys laws = laws_of(packing.keys); !laws.empty()) root[held_keys_name] = held_keys_json(laws);
  Json& particles = root["particles"] = Json::array();
  const std::vector<std::string> names = names_of_species(packing);
  if (!names.empty()) root["species"] = names;
  for (int b = 0; b < system.topology.body_count(system.state.size()); ++b) {
    Json& particle = particles.emplace_back(particle_json(system, b));
    if (!names.empty()) particle["species"] = names[static_cast<std::size_t>(system.species_of(b))];
    if (const auto own = specs->find(b); own != specs->end()) write_own_spec(own->second, common, particle);
    write_terms(system, b, kind, particle);
  }
  NewFile file(path, existing);
  file.write(root.dump(1));
  file.write("\n");
  file.commit();
}

}  // namespace supple
