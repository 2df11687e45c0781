#include "supple/io/packing_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "supple/geometry/polygon.hpp"
#include "supple/io/json_node.hpp"
#include "supple/model/polygons.hpp"

namespace supple {

namespace {

// ---- reading
// ---------------------------------------------------------------------------------------------------------

bool is_relative(const JsonNode& root, const char* key) {
  if (!root.has(key)) return true;
  const JsonNode kind = root.at(key);
  const std::string name = kind.text();
  if (name != "relative" && name != "absolute") throw kind.fault("is \"" + name + "\", not relative or absolute");
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

void read_particle(const JsonNode& particle, const ShapeSpec& spec, System<2>& system) {
  const double radius = 0.5 * particle.at("sigma").positive();
  const std::vector<Vec2> vertices = read_vertices(particle.at("x"), system.box);
  if (vertices.size() == 1) return add_disc_body(system, vertices[0], radius);
  const double a0 = particle.at("a0").positive();
  const JsonNode l0 = particle.at("l0");
  const std::vector<double> lengths = read_numbers(l0, vertices.size());
  if (*std::min_element(lengths.begin(), lengths.end()) <= 0) throw l0.fault("is not positive");
  if (spec.kind == StiffnessKind::relative && l0.is_list())
    throw l0.fault("is a list: relative stiffnesses need one length for all edges");
  const std::vector<double> angles = read_numbers(particle.at("theta0"), vertices.size());
  const ShapeStiffness k = absolute_stiffness(spec, a0, lengths[0], static_cast<int>(vertices.size()));
  add_ring(system, vertices, radius, k, a0, lengths, angles);
}

// ---- writing
// ---------------------------------------------------------------------------------------------------------

[[noreturn]] void refuse(const std::string& why) { throw input_error("cannot write this packing as JSON", why); }

std::span<const double> rests_of(const std::vector<double>& rest, const std::vector<std::int32_t>& begin, int b) {
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
  return near(a.area, b.area) && near(a.length, b.length) && near(a.bending, b.bending) && near(a.tension, b.tension);
}

/// The stiffness that all polygons share.
std::optional<ShapeSpec> common_spec(const System<2>& system, StiffnessKind kind) {
  std::optional<ShapeSpec> common;
  for (int b = 0; b < system.topology.body_count(system.state.size()); ++b) {
    if (system.topology.body_size(b) < 3) continue;
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
    if (system.state.radius[i] != system.state.radius[begin]) refuse("a body has vertices of different sizes");
  Json particle{{"sigma", 2 * system.state.radius[begin]}};
  Json& x = particle["x"] = Json::array();
  for (int i = begin; i < end; ++i) x.push_back({system.state.position[i][0], system.state.position[i][1]});
  if (end - begin == 1) return particle;
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

}  // namespace

StoredPacking read_packing_json(const std::string& path) {
  const Json json = parse_json(path, "a packing");
  const JsonNode root(json, path);
  StoredPacking packing;
  packing.system.box = read_cell(root);
  packing.contact = {stiffness(root.at("k_c")), is_relative(root, "contact_stiffness")};
  const ShapeSpec spec = read_spec(root);
  const JsonNode particles = root.at("particles");
  if (particles.size() == 0) throw particles.fault("is empty");
  for (std::size_t b = 0; b < particles.size(); ++b) read_particle(particles[b], spec, packing.system);
  return packing;
}

void write_packing_json(const StoredPacking& packing, const std::string& path, Existing existing) {
  const System<2>& system = packing.system;
  if (system.shape.empty()) refuse("its bodies have no preferred shapes");
  if (!system.rigid.empty()) refuse("it has rigid bodies");
  std::optional<ShapeSpec> spec = common_spec(system, StiffnessKind::relative);
  if (!spec) spec = common_spec(system, StiffnessKind::absolute);
  if (!spec) refuse("its bodies have different stiffnesses");
  Json root;
  write_spec(*spec, root);
  root["k_c"] = packing.contact.stiffness;
  if (!packing.contact.relative) root["contact_stiffness"] = "absolute";
  write_cell(system.box, root);
  Json& particles = root["particles"] = Json::array();
  for (int b = 0; b < system.topology.body_count(system.state.size()); ++b)
    particles.push_back(particle_json(system, b));
  NewFile file(path, existing);
  file.write(root.dump(1));
  file.write("\n");
  file.commit();
}

}  // namespace supple
