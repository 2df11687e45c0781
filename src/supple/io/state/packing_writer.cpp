#include "supple/io/state/packing_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

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

bool nearly_equal(const ShapeSpec& a, const ShapeSpec& b) {
  const auto near = [](double x, double y) { return std::abs(x - y) <= 1e-12 * std::abs(y); };
  return near(a.area, b.area) && near(a.length, b.length) && near(a.bending, b.bending) &&
         near(a.tension, b.tension);
}

bool is_rigid(const System<2>& system, int b) {
  return std::binary_search(system.rigid.body.begin(), system.rigid.body.end(), b);
}

/// The stiffness that all polygons share, rigid ones left out.
std::optional<ShapeSpec> common_spec(const System<2>& system, StiffnessKind kind) {
  std::optional<ShapeSpec> common;
  for (int b = 0; b < system.topology.body_count(system.state.size()); ++b) {
    if (system.topology.body_size(b) < 3 || is_rigid(system, b)) continue;
    const std::optional<ShapeSpec> own = spec_of(system, b, kind);
    if (!own || (common && !nearly_equal(*own, *common))) return std::nullopt;
    if (!common) common = own;
  }
  return common ? common : ShapeSpec{0, 0, 0, 0, kind};
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
  if (!system.terms.empty()) refuse("the layout has no " + system.terms.front().name + " of particles");
  std::optional<ShapeSpec> spec = common_spec(system, StiffnessKind::relative);
  if (!spec) spec = common_spec(system, StiffnessKind::absolute);
  if (!spec) refuse("its bodies have different stiffnesses");
  Json root;
  write_spec(*spec, root);
  root["k_c"] = packing.contact.stiffness;
  if (!packing.contact.relative) root["contact_stiffness"] = "absolute";
  write_cell(system.box, root);
  write_environment(packing.environment, root);
  if (const HeldKeys laws = laws_of(packing.keys); !laws.empty()) root[held_keys_name] = held_keys_json(laws);
  Json& particles = root["particles"] = Json::array();
  for (int b = 0; b < system.topology.body_count(system.state.size()); ++b)
    particles.push_back(particle_json(system, b));
  NewFile file(path, existing);
  file.write(root.dump(1));
  file.write("\n");
  file.commit();
}

}  // namespace supple
