#include "supple/io/state/packing_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <span>
#include <vector>

#include "supple/build/surfaces.hpp"
#include "supple/energy/perimeter.hpp"
#include "supple/io/state/held_keys_json.hpp"
#include "supple/io/state/packing_layout.hpp"

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

/// A product of squares and their inverses, back at the short number that it was made of.
double shortened(double k) {
  const double round = std::stod(fmt::format("{:.12g}", k));
  return std::abs(round - k) <= 1e-15 * std::abs(k) ? round : k;
}

bool same(const ShapeStiffness& a, const ShapeStiffness& b) {
  return a.volume == b.volume && a.facet == b.facet && a.hinge == b.hinge && a.tension == b.tension;
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
/// The same of a surface; the kind says only what a reader would get back to the last bit.
std::optional<ShapeSpec> spec_of(const System<3>& system, int b, StiffnessKind kind) {
  const ShapeStiffness& k = system.shape.stiffness[b];
  ShapeSpec spec{k.volume, k.facet, k.hinge, k.tension, kind};
  if (kind == StiffnessKind::absolute) return spec;
  const std::span<const double> areas = rests_of(system.shape.rest_facet, system.topology.facet_begin, b);
  const double v0 = system.shape.rest_volume[b], s0 = std::accumulate(areas.begin(), areas.end(), 0.0),
               mean = s0 / static_cast<double>(areas.size());
  spec.area = shortened(spec.area * (v0 * v0));
  spec.length = shortened(spec.length * (mean * mean));
  spec.tension = shortened(spec.tension * s0);
  if (!same(absolute_stiffness(spec, v0, {areas.begin(), areas.end()}), k)) return std::nullopt;
  return spec;
}

/// Whether a particle need not say its own stiffness where that of all is y.
template <int Dim>
bool is_said(double x, double y) {
  return Dim == 2 ? std::abs(x - y) <= 1e-12 * std::abs(y) : x == y;
}
/// A stiffness as it is written.
template <int Dim>
double written(double k) {
  return Dim == 2 ? shortened(k) : k;
}

template <int Dim>
bool is_rigid(const System<Dim>& system, int b) {
  return std::binary_search(system.rigid.body.begin(), system.rigid.body.end(), b);
}

/// The stiffness of each body that is soft, in this kind; nothing where the kind cannot say one of them.
template <int Dim>
std::optional<std::map<int, ShapeSpec>> specs_of(const System<Dim>& system, StiffnessKind kind) {
  std::map<int, ShapeSpec> all;
  for (int b = 0; b < system.topology.body_count(system.state.size()); ++b) {
    if (system.topology.body_size(b) < 3 || is_rigid(system, b)) continue;
    const std::optional<ShapeSpec> own = spec_of(system, b, kind);
    if (!own) return std::nullopt;
    all.emplace(b, *own);
  }
  return all;
}

Json number_or_list(std::span<const double> values) {
  if (all_equal(values)) return values[0];
  return std::vector<double>(values.begin(), values.end());
}

template <int Dim>
Json vector_json(const Vec<Dim>& v) {
  Json list = Json::array();
  for (int d = 0; d < Dim; ++d) list.push_back(v[d]);
  return list;
}

/// The preferred shape of body b.
void write_shape(const System<2>& system, int b, Json& particle) {
  particle["a0"] = system.shape.rest_volume[b];
  particle["l0"] = number_or_list(rests_of(system.shape.rest_facet, system.topology.facet_begin, b));
  particle["theta0"] = number_or_list(rests_of(system.shape.rest_hinge, system.topology.hinge_begin, b));
}
/// The same, and its triangles.
void write_shape(const System<3>& system, int b, Json& particle) {
  const Topology<3>& t = system.topology;
  particle["v0"] = system.shape.rest_volume[b];
  particle["a0"] = number_or_list(rests_of(system.shape.rest_facet, t.facet_begin, b));
  particle["theta0"] = number_or_list(rests_of(system.shape.rest_hinge, t.hinge_begin, b));
  particle["faces"] = mesh_of(system, b).face;
  if (!particle["theta0"].is_array()) return;
  const std::int32_t first = t.body_begin(b);
  for (std::int32_t h = t.hinge_begin[b]; h < t.hinge_begin[b + 1]; ++h)
    particle["edges"].push_back({t.hinge[h][0] - first, t.hinge[h][1] - first});
}

template <int Dim>
Json particle_json(const System<Dim>& system, int b) {
  if (system.solid.fills(b)) refuse("the layout has no solids; go on from the run itself, by initial.state");
  const int begin = system.topology.body_begin(b), end = system.topology.body_end(b);
  for (int i = begin + 1; i < end; ++i)
    if (system.state.radius[i] != system.state.radius[begin])
      refuse("a body has vertices of different sizes");
  const bool round = end - begin == 1;
  Json particle{{"sigma", 2 * system.state.radius[begin]}};
  Json& x = particle[Dim == 2 || round ? "x" : "vertices"] = Json::array();
  for (int i = begin; i < end; ++i) x.push_back(vector_json(system.state.position[i]));
  const auto sites = [&](const auto& values) { return std::span(values).subspan(begin, end - begin); };
  const auto moves = sites(system.state.velocity);
  if (std::any_of(moves.begin(), moves.end(), [](const Vec<Dim>& v) { return v != Vec<Dim>{}; }))
    for (const Vec<Dim>& v : moves) particle["v"].push_back(vector_json(v));
  if (!system.floor_contact.empty())
    if (const auto stuck = sites(system.floor_contact);
        !std::all_of(stuck.begin(), stuck.end(), [](double at) { return std::isnan(at); }))
      for (const double at : stuck) particle["sticks"].push_back(std::isnan(at) ? Json() : Json(at));
  if (round) return particle;
  if (is_rigid(system, b)) particle["rigid"] = true;
  write_shape(system, b, particle);
  return particle;
}

/// The stiffnesses in which a particle differs from what the file says of all.
template <int Dim>
void write_own_spec(const ShapeSpec& own, const ShapeSpec& common, Json& particle) {
  Json of_all;
  for_each_stiffness<Dim>(common, [&](const char* key, double k) { of_all[key] = k; });
  for_each_stiffness<Dim>(own, [&](const char* key, double k) {
    if (!is_said<Dim>(k, of_all[key])) particle[key] = written<Dim>(k);
  });
}

/// The terms of a particle beside its shape energy.
template <int Dim>
void write_terms(const System<Dim>& system, int b, StiffnessKind kind, Json& particle) {
  for (const BodyTermData& term : system.terms) {
    if (static_cast<std::size_t>(b) >= term.bodies()) continue;
    const double* numbers = &term.number[static_cast<std::size_t>(b) * term.width];
    if (std::all_of(numbers, numbers + term.width, [](double x) { return x == 0; })) continue;
    if (Dim == 3 || term.name != Perimeter::name)
      refuse(fmt::format("the layout has no {} of {}", term.name, Dim == 2 ? "particles" : "surfaces"));
    const double rest = numbers[1];
    particle["k_perimeter"] = shortened(numbers[0] * (kind == StiffnessKind::relative ? rest * rest : 1));
    particle["p0"] = rest;
  }
}

/// By what the sections [contact.A.B] call the species.
template <int Dim>
std::vector<std::string> names_of_species(const StoredPackingOf<Dim>& packing) {
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

template <int Dim>
void write_spec(const ShapeSpec& spec, Json& root) {
  for_each_stiffness<Dim>(spec, [&](const std::string& key, double k) {
    if (key != "gamma" || k != 0) root[key] = key == "k_b" ? k : written<Dim>(k);
  });
  if (spec.kind == StiffnessKind::absolute) root["stiffness"] = "absolute";
}

template <int Dim>
void write_cell(const Box<Dim>& cell, Json& root) {
  const Vec<Dim>& length = cell.length;
  bool is_cube = true;
  for (int d = 1; d < Dim; ++d) is_cube = is_cube && length[d] == length[0];
  root["box"] = is_cube ? Json(length[0]) : vector_json(length);
  if (cell.strain != 0) root["strain"] = cell.strain;
  if (cell.periodic != Box<Dim>{}.periodic)
    for (const bool periodic : cell.periodic) root["periodic"].push_back(periodic);
}

template <int Dim>
void write_environment(const Environment& e, Json& root) {
  if (e.gravity[gradient] != 0) root["gravity"] = -e.gravity[gradient];
  if (e.is_closed()) return;
  Json& walls = root["walls"] = Json::array();
  for_each_wall<Dim>(e, [&](const char* name, bool stands) {
    if (stands) walls.push_back(name);
  });
}

template <int Dim>
Json packing_json(const StoredPackingOf<Dim>& packing) {
  const System<Dim>& system = packing.system;
  if (system.shape.empty()) refuse("its bodies have no preferred shapes");
  if (!system.links.empty()) refuse("its particles are crosslinked, and the layout has no links");
  if (Dim == 3 && !system.rigid.empty()) refuse("the layout has no rigid surfaces");
  StiffnessKind kind = StiffnessKind::relative;
  std::optional<std::map<int, ShapeSpec>> specs = specs_of(system, kind);
  if (!specs) specs = specs_of(system, kind = StiffnessKind::absolute);
  const ShapeSpec common =
      specs->empty() ? ShapeSpec{0, 0, 0, 0, StiffnessKind::relative} : specs->begin()->second;
  Json root;
  write_spec<Dim>(common, root);
  root["k_c"] = packing.contact.stiffness;
  if (!packing.contact.relative) root["contact_stiffness"] = "absolute";
  write_cell(system.box, root);
  write_environment<Dim>(packing.environment, root);
  if (const HeldKeys laws = laws_of(packing.keys); !laws.empty()) root[held_keys_name] = held_keys_json(laws);
  Json& particles = root["particles"] = Json::array();
  const std::vector<std::string> names = names_of_species(packing);
  if (!names.empty()) root["species"] = names;
  for (int b = 0; b < system.topology.body_count(system.state.size()); ++b) {
    Json& particle = particles.emplace_back(particle_json(system, b));
    if (!names.empty()) particle["species"] = names[static_cast<std::size_t>(system.species_of(b))];
    if (const auto own = specs->find(b); own != specs->end())
      write_own_spec<Dim>(own->second, common, particle);
    write_terms(system, b, kind, particle);
  }
  return root;
}

}  // namespace

void write_packing_json(const AnyPacking& packing, const std::string& path, Existing existing) {
  const Json root = std::visit([](const auto& of) { return packing_json(of); }, packing);
  NewFile file(path, existing);
  file.write(root.dump(1));
  file.write("\n");
  file.commit();
}

}  // namespace supple
