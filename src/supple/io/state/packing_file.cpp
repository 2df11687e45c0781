#include "supple/io/state/packing_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "supple/energy/perimeter.hpp"
#include "supple/geometry/polygon.hpp"
#include "supple/geometry/self_crossing.hpp"
#include "supple/io/state/held_keys_json.hpp"
#include "supple/model/polygons.hpp"
#include "supple/model/rigid.hpp"

namespace supple {

namespace {

bool is_relative(const JsonNode& root, const char* key) {
  if (!root.has(key)) return true;
  const JsonNode kind = root.at(key);
  const std::string name = kind.text();
  if (name != "relative" && name != "absolute")
    throw kind.fault("is \"" + name + "\", not relative or absolute");
  return name == "relative";
}

double stiffness(const JsonNode& node) {
  const double k = node.number();
  if (k < 0) throw node.fault("is negative");
  return k;
}

ShapeSpec read_spec(const JsonNode& root) {
  ShapeSpec spec;
  spec.area = stiffness(root.at("k_a"));
  spec.length = stiffness(root.at("k_l"));
  spec.bending = stiffness(root.at("k_b"));
  if (root.has("gamma")) spec.tension = stiffness(root.at("gamma"));
  spec.kind = is_relative(root, "stiffness") ? StiffnessKind::relative : StiffnessKind::absolute;
  return spec;
}

/// The stiffness of a particle: that of all, but for what the particle says itself.
ShapeSpec spec_of_particle(const JsonNode& particle, const ShapeSpec& common, bool soft) {
  ShapeSpec spec = common;
  const auto read = [&](const char* key, double& of_spec) {
    if (!particle.has(key)) return;
    if (!soft) throw particle.at(key).fault("of a particle that does not deform");
    of_spec = stiffness(particle.at(key));
  };
  read("k_a", spec.area);
  read("k_l", spec.length);
  read("k_b", spec.bending);
  read("gamma", spec.tension);
  return spec;
}

/// Names of species, which become keys of the packing.
std::vector<std::string> read_species(const JsonNode& root, HeldKeys& keys) {
  std::vector<std::string> names;
  if (!root.has("species")) return names;
  const JsonNode list = root.at("species");
  for (std::size_t k = 0; k < list.size(); ++k) {
    const std::string name = list[k].text();
    if (std::find(names.begin(), names.end(), name) != names.end())
      throw list[k].fault(fmt::format("is \"{}\" again", name));
    names.push_back(name);
    keys[species_section(k) + ".name"] = name == fmt::format("{}", k + 1) ? std::string() : name;
  }
  return names;
}

Vec2 read_vector(const JsonNode& node) {
  if (node.size() != 2) throw node.fault("is not two numbers");
  return {node[0].number(), node[1].number()};
}

Box<2> read_cell(const JsonNode& root) {
  Box<2> cell;
  const JsonNode box = root.at("box");
  cell.length = box.is_list() ? read_vector(box) : Vec2{box.positive(), box.positive()};
  if (!(cell.length[0] > 0 && cell.length[1] > 0)) throw box.fault("is not positive");
  if (root.has("strain")) cell.strain = root.at("strain").number();
  if (!root.has("periodic")) return cell;
  const JsonNode periodic = root.at("periodic");
  if (periodic.size() != 2) throw periodic.fault("is not two values");
  for (std::size_t d = 0; d < 2; ++d) cell.periodic[d] = periodic[d].truth();
  return cell;
}

std::vector<Vec2> read_vertices(const JsonNode& x, const Box<2>& cell) {
  std::vector<Vec2> vertices;
  for (std::size_t k = 0; k < x.size(); ++k) vertices.push_back(read_vector(x[k]));
  const std::size_t n = vertices.size();
  if (n == 1) return vertices;
  if (n < 3) throw x.fault(fmt::format("has {} vertices, not 3 or more, or 1 for a disc", n));
  for (std::size_t k = 0; k < n; ++k) {
    const Vec2 edge = vertices[(k + 1) % n] - vertices[k];
    for (int d = 0; d < 2; ++d)
      if (cell.periodic[d] && std::abs(edge[d]) > 0.5 * cell.length[d])
        throw x[k].fault("is more than half a cell from the next: vertices must be unwrapped");
  }
  if (const auto crossing = find_self_crossing(vertices))
    throw x.fault(
        fmt::format("crosses itself: the edges after vertices {} and {}", crossing->first, crossing->second));
  if (!(polygon_area(vertices) > 0)) throw x.fault("does not run counter-clockwise");
  return vertices;
}

/// One number for all, or a list of n.
std::vector<double> read_numbers(const JsonNode& node, std::size_t n) {
  if (!node.is_list()) return std::vector<double>(n, node.number());
  if (node.size() != n) throw node.fault(fmt::format("has {} numbers for {} vertices", node.size(), n));
  std::vector<double> out;
  for (std::size_t k = 0; k < n; ++k) out.push_back(node[k].number());
  return out;
}

/// Of vertices, or else what they are now, where the particle is rigid and prefers nothing.
struct Preferred {
  double area = 0;
  std::vector<double> lengths, angles;
};

Preferred preferred_as_it_is(const std::vector<Vec2>& vertices) {
  Preferred p;
  const std::size_t n = vertices.size();
  p.area = polygon_area(vertices);
  for (std::size_t k = 0; k < n; ++k) {
    const Vec2 in = vertices[k] - vertices[(k + n - 1) % n], out = vertices[(k + 1) % n] - vertices[k];
    p.lengths.push_back(norm(out));
    p.angles.push_back(std::atan2(cross(in, out), dot(in, out)));
  }
  return p;
}

Preferred read_preferred(const JsonNode& particle, std::size_t n, StiffnessKind kind) {
  Preferred p;
  p.area = particle.at("a0").positive();
  const JsonNode l0 = particle.at("l0");
  p.lengths = read_numbers(l0, n);
  if (*std::min_element(p.lengths.begin(), p.lengths.end()) <= 0) throw l0.fault("is not positive");
  if (kind == StiffnessKind::relative && l0.is_list())
    throw l0.fault("is a list: relative stiffnesses need one length for all edges");
  p.angles = read_numbers(particle.at("theta0"), n);
  return p;
}

bool is_rigid(const JsonNode& particle) { return particle.has("rigid") && particle.at("rigid").truth(); }

void add_particle(const JsonNode& particle, const ShapeSpec& common, System<2>& system) {
  const double radius = 0.5 * particle.at("sigma").positive();
  const std::vector<Vec2> vertices = read_vertices(particle.at("x"), system.box);
  const std::size_t n = vertices.size();
  if (n == 1 && is_rigid(particle)) throw particle.at("rigid").fault("of a disc, which is rigid anyway");
  const bool rigid = is_rigid(particle), soft = n > 1 && !rigid;
  const ShapeSpec spec = spec_of_particle(particle, common, soft);
  if (!soft && particle.has("k_perimeter"))
    throw particle.at("k_perimeter").fault("of a particle that does not deform");
  if (n == 1) return add_disc_body(system, vertices[0], radius);
  const bool given = !rigid || particle.has("a0") || particle.has("l0") || particle.has("theta0");
  const Preferred p = given ? read_preferred(particle, n, rigid ? StiffnessKind::absolute : spec.kind)
                            : preferred_as_it_is(vertices);
  const ShapeStiffness k =
      rigid ? ShapeStiffness{} : absolute_stiffness(spec, p.area, p.lengths[0], static_cast<int>(n));
  const int body = system.topology.body_count(system.state.size());
  add_ring(system, vertices, radius, k, p.area, p.lengths, p.angles);
  if (!particle.has("k_perimeter")) return;
  const double rest = particle.at("p0").positive(), of_file = stiffness(particle.at("k_perimeter"));
  set_body_term(system.terms, Perimeter::name, body,
                std::array{spec.kind == StiffnessKind::relative ? of_file / (rest * rest) : of_file, rest});
}

/// Keeps the species of the particle that was read last, if the file has any.
void read_species_of(const JsonNode& particle, const std::vector<std::string>& names, System<2>& system) {
  if (names.empty()) {
    if (particle.has("species")) throw particle.at("species").fault("but the file has no list \"species\"");
    return;
  }
  const JsonNode species = particle.at("species");
  const auto at = std::find(names.begin(), names.end(), species.text());
  if (at == names.end())
    throw species.fault(fmt::format("is \"{}\", not one of {}", species.text(), join_names(names)));
  system.species.push_back(static_cast<std::int32_t>(at - names.begin()));
}

void read_particle(const JsonNode& particle, const ShapeSpec& spec, StoredPacking& packing) {
  particle.expect_only({"sigma", "x", "a0", "l0", "theta0", "rigid", "v", "sticks", "species", "k_a", "k_l",
                        "k_b", "gamma", "k_perimeter", "p0"});
  System<2>& system = packing.system;
  const int first = system.state.size();
  add_particle(particle, spec, system);
  const auto n = static_cast<std::size_t>(system.state.size() - first);
  const auto list = [&](const char* key) {
    const JsonNode values = particle.at(key);
    if (values.size() != n)
      throw values.fault(fmt::format("has {} entries for {} vertices", values.size(), n));
    return values;
  };
  if (particle.has("v"))
    for (std::size_t k = 0; k < n; ++k) system.state.velocity[first + k] = read_vector(list("v")[k]);
  system.floor_contact.resize(first + n, std::numeric_limits<double>::quiet_NaN());
  if (particle.has("sticks"))
    for (std::size_t k = 0; k < n; ++k)
      if (const JsonNode at = list("sticks")[k]; !at.json().is_null())
        system.floor_contact[first + k] = at.number();
  if (is_rigid(particle)) make_rigid(system, system.topology.body_count(system.state.size()) - 1);
}

Environment read_environment(const JsonNode& root, const Box<2>& cell) {
  Environment e;
  if (root.has("walls")) {
    const JsonNode walls = root.at("walls");
    std::vector<std::string> names, standing;
    for_each_wall(e, [&](const char* name, bool) { names.emplace_back(name); });
    for (std::size_t k = 0; k < walls.size(); ++k) {
      standing.push_back(walls[k].text());
      if (std::find(names.begin(), names.end(), standing.back()) == names.end())
        throw walls[k].fault("is \"" + standing.back() + "\", not one of " + join_names(names));
    }
    for_each_wall(e, [&](const std::string& name, bool& stands) {
      stands = std::find(standing.begin(), standing.end(), name) != standing.end();
    });
  }
  if (!root.has("gravity")) return e;
  const JsonNode gravity = root.at("gravity");
  if (gravity.number() < 0) throw gravity.fault("is negative: it is the acceleration downward");
  if (gravity.number() > 0 && cell.periodic[gradient])
    throw gravity.fault("in a cell that is periodic along y");
  e.gravity[gradient] = -gravity.number();
  return e;
}

}  // namespace

InitialState as_initial(StoredPacking packing) {
  InitialState initial;
  initial.units = reduced_units();
  initial.system = std::move(packing.system);
  initial.contact = packing.contact;
  initial.keys = std::move(packing.keys);
  initial.environment = packing.environment;
  return initial;
}

StoredPacking as_packing(const InitialState& state) {
  return {system_of<2>(state), state.contact.value_or(Harmonic{}), state.keys, state.environment};
}

StoredPacking read_packing_json(const std::string& path) {
  const Json json = parse_json(path, "a packing");
  const JsonNode root(json, path);
  StoredPacking packing;
  if (root.has("params") && !root.has("particles"))
    throw root.fault(
        "is a state of discs of microgels: start from it by initial.state, not initial.packing;");
  root.expect_only(
      {"k_a",       "k_l",      "k_b",     "gamma",      "k_c",          "stiffness",    "contact_stiffness",
       "box",       "periodic", "strain",  "walls",      "gravity",      held_keys_name, "species",
       "particles", "name",     "comment", "convention", "phi_reported", "expected"});
  packing.system.box = read_cell(root);
  packing.keys = read_held_keys(root);
  const std::vector<std::string> species = read_species(root, packing.keys);
  packing.environment = read_environment(root, packing.system.box);
  packing.contact = {stiffness(root.at("k_c")), is_relative(root, "contact_stiffness")};
  const ShapeSpec spec = read_spec(root);
  const JsonNode particles = root.at("particles");
  if (particles.size() == 0) throw particles.fault("is empty");
  for (std::size_t b = 0; b < particles.size(); ++b) {
    read_particle(particles[b], spec, packing);
    read_species_of(particles[b], species, packing.system);
  }
  std::vector<double>& floor = packing.system.floor_contact;
  if (std::all_of(floor.begin(), floor.end(), [](double at) { return std::isnan(at); })) floor.clear();
  return packing;
}

}  // namespace supple
