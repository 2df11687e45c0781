#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "supple/build/surfaces.hpp"
#include "supple/energy/perimeter.hpp"
#include "supple/geometry/mesh_fault.hpp"
#include "supple/geometry/polygon.hpp"
#include "supple/geometry/self_crossing.hpp"
#include "supple/io/state/packing_layout.hpp"
#include "supple/model/rigid.hpp"

namespace supple {

namespace {

/// The stiffness of a particle: that of all, but for what the particle says itself.
template <int Dim>
ShapeSpec spec_of_particle(const JsonNode& particle, const ShapeSpec& common, bool soft) {
  ShapeSpec spec = common;
  for_each_stiffness<Dim>(spec, [&](const char* key, double& of_spec) {
    if (!particle.has(key)) return;
    if (!soft) throw particle.at(key).fault("of a particle that does not deform");
    of_spec = read_stiffness(particle.at(key));
  });
  return spec;
}

template <int Dim>
std::vector<Vec<Dim>> read_points(const JsonNode& list) {
  std::vector<Vec<Dim>> points;
  for (std::size_t k = 0; k < list.size(); ++k) points.push_back(read_vector<Dim>(list[k]));
  return points;
}

/// Whether an edge of a particle is longer than half a period of its cell.
template <int Dim>
bool is_wrapped(const Vec<Dim>& edge, const Box<Dim>& cell) {
  for (int d = 0; d < Dim; ++d)
    if (cell.periodic[d] && std::abs(edge[d]) > 0.5 * cell.length[d]) return true;
  return false;
}

/// One number for all, or a list of n of them, each of one of `what`.
std::vector<double> read_numbers(const JsonNode& node, std::size_t n, const char* what) {
  if (!node.is_list()) return std::vector<double>(n, node.number());
  if (node.size() != n) throw node.fault(fmt::format("has {} numbers for {} {}", node.size(), n, what));
  std::vector<double> out;
  for (std::size_t k = 0; k < n; ++k) out.push_back(node[k].number());
  return out;
}

/// The same of numbers that must be positive.
std::vector<double> read_positive(const JsonNode& node, std::size_t n, const char* what) {
  std::vector<double> out = read_numbers(node, n, what);
  if (*std::min_element(out.begin(), out.end()) <= 0) throw node.fault("is not positive");
  return out;
}

// Polygons and discs.

std::vector<Vec2> read_ring(const JsonNode& x, const Box<2>& cell) {
  std::vector<Vec2> vertices = read_points<2>(x);
  const std::size_t n = vertices.size();
  if (n == 1) return vertices;
  if (n < 3) throw x.fault(fmt::format("has {} vertices, not 3 or more, or 1 for a disc", n));
  for (std::size_t k = 0; k < n; ++k)
    if (is_wrapped(vertices[(k + 1) % n] - vertices[k], cell))
      throw x[k].fault("is more than half a cell from the next: vertices must be unwrapped");
  if (const auto crossing = find_self_crossing(vertices))
    throw x.fault(
        fmt::format("crosses itself: the edges after vertices {} and {}", crossing->first, crossing->second));
  if (!(polygon_area(vertices) > 0)) throw x.fault("does not run counter-clockwise");
  return vertices;
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
  p.lengths = read_positive(l0, n, "vertices");
  if (kind == StiffnessKind::relative && l0.is_list())
    throw l0.fault("is a list: relative stiffnesses need one length for all edges");
  p.angles = read_numbers(particle.at("theta0"), n, "vertices");
  return p;
}

bool is_rigid(const JsonNode& particle) { return particle.has("rigid") && particle.at("rigid").truth(); }

void add_particle(const JsonNode& particle, const CommonOfParticles& common, System<2>& system) {
  const double radius = 0.5 * particle.at("sigma").positive();
  const std::vector<Vec2> vertices = read_ring(particle.at("x"), system.box);
  const std::size_t n = vertices.size();
  if (n == 1 && is_rigid(particle)) throw particle.at("rigid").fault("of a disc, which is rigid anyway");
  const bool rigid = is_rigid(particle), soft = n > 1 && !rigid;
  const ShapeSpec spec = spec_of_particle<2>(particle, common.spec, soft);
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
  const double rest = particle.at("p0").positive(), of_file = read_stiffness(particle.at("k_perimeter"));
  set_body_term(system.terms, Perimeter::name, body,
                std::array{spec.kind == StiffnessKind::relative ? of_file / (rest * rest) : of_file, rest});
}

// Surfaces and spheres.

using Edge = std::array<std::int32_t, 2>;

/// A list of so many vertices by their numbers.
template <std::size_t Count>
std::array<std::int32_t, Count> read_corners(const JsonNode& node, const char* meaning) {
  if (node.size() != Count) throw node.fault(fmt::format("is not {}", meaning));
  std::array<std::int32_t, Count> corners;
  for (std::size_t k = 0; k < Count; ++k) corners[k] = node[k].index();
  return corners;
}

/// A closed surface that looks outward and does not meet itself.
TriangleMesh read_surface(const JsonNode& particle, const Box<3>& cell) {
  const JsonNode vertices = particle.at("vertices"), faces = particle.at("faces");
  TriangleMesh mesh{read_points<3>(vertices), {}};
  for (std::size_t k = 0; k < faces.size(); ++k)
    mesh.face.push_back(read_corners<3>(faces[k], "the numbers of three vertices"));
  for (const auto& face : mesh.face)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto from = static_cast<std::size_t>(face[k]), to = static_cast<std::size_t>(face[(k + 1) % 3]);
      if (std::max(from, to) < mesh.vertex.size() && is_wrapped(mesh.vertex[to] - mesh.vertex[from], cell))
        throw vertices[from].fault(
            fmt::format("is more than half a cell from vertex {}: vertices must be unwrapped", to));
    }
  if (const auto fault = find_fault(mesh))
    throw particle.fault("is no closed surface: " + fault->what, fault->to_do, fault->why);
  return mesh;
}

Edge without_direction(std::int32_t a, std::int32_t b) { return {std::min(a, b), std::max(a, b)}; }

/// The preferred angle of each hinge of a surface, of which the file has one for each of its own edges.
std::vector<double> read_angles(const JsonNode& particle,
                                const std::vector<std::array<std::int32_t, 4>>& hinges) {
  const JsonNode theta0 = particle.at("theta0");
  if (!theta0.is_list()) return read_numbers(theta0, hinges.size(), "edges");
  if (!particle.has("edges"))
    throw theta0.fault("is a list, but the particle has no \"edges\", whose angles it has",
                       "give the two vertices of each edge, or one angle for all");
  const JsonNode edges = particle.at("edges");
  if (edges.size() != hinges.size())
    throw edges.fault(fmt::format("has {} edges, but the triangles have {}", edges.size(), hinges.size()));
  const std::vector<double> angle = read_numbers(theta0, hinges.size(), "edges");
  std::vector<std::pair<Edge, std::size_t>> of_file;
  for (std::size_t e = 0; e < angle.size(); ++e) {
    const auto [a, b] = read_corners<2>(edges[e], "the numbers of two vertices");
    of_file.emplace_back(without_direction(a, b), e);
  }
  std::sort(of_file.begin(), of_file.end());
  for (std::size_t e = 1; e < of_file.size(); ++e)
    if (of_file[e].first == of_file[e - 1].first)
      throw edges[of_file[e].second].fault(fmt::format("is edges[{}] again", of_file[e - 1].second));
  std::vector<double> angles;
  for (const auto& hinge : hinges) {
    const Edge edge = without_direction(hinge[0], hinge[1]);
    const auto at = std::lower_bound(of_file.begin(), of_file.end(), std::pair{edge, std::size_t{0}});
    if (at == of_file.end() || at->first != edge)
      throw edges.fault(
          fmt::format("lacks the edge of the triangles between vertices {} and {}", edge[0], edge[1]));
    angles.push_back(angle[at->second]);
  }
  return angles;
}

void add_sphere(const JsonNode& particle, System<3>& system) {
  const JsonNode x = particle.at("x");
  const std::vector<Vec3> centre = read_points<3>(x);
  if (centre.size() != 1)
    throw x.fault(fmt::format("has {} points, not the centre of a sphere alone", centre.size()),
                  "a surface has \"vertices\" and \"faces\"");
  for (const char* key : {"v0", "a0", "theta0", "edges"})
    if (particle.has(key)) throw particle.at(key).fault("of a particle that does not deform");
  add_sphere_body(system, centre[0], 0.5 * particle.at("sigma").positive());
}

void add_particle(const JsonNode& particle, const CommonOfParticles& common, System<3>& system) {
  const bool soft = particle.has("vertices") || particle.has("faces");
  if (soft && particle.has("x"))
    throw particle.at("x").fault("stands beside the points of a surface",
                                 "leave it away, or \"vertices\" and \"faces\" for a sphere");
  const ShapeSpec spec = spec_of_particle<3>(particle, common.spec, soft);
  if (!soft) return add_sphere(particle, system);
  const TriangleMesh mesh = read_surface(particle, system.box);
  const double v0 = particle.at("v0").positive();
  const std::vector<double> a0 = read_positive(particle.at("a0"), mesh.face.size(), "triangles");
  const double sigma =
      common.alone && !particle.has("sigma") ? mean_edge(mesh) : particle.at("sigma").positive();
  add_surface(system, mesh, 0.5 * sigma, absolute_stiffness(spec, v0, a0), v0, a0,
              read_angles(particle, hinges_of(mesh)));
}

// Both.

/// Keeps the species of the particle that was read last, if the file has any.
template <int Dim>
void read_species_of(const JsonNode& particle, const std::vector<std::string>& names, System<Dim>& system) {
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

/// Where sites stick to the floor, as a list of the sites of a particle has it.
void read_sticking(const JsonNode& sticks, std::span<double> at) {
  for (std::size_t k = 0; k < at.size(); ++k)
    if (const JsonNode place = sticks[k]; !place.json().is_null()) at[k] = place.number();
}

}  // namespace

template <int Dim>
void read_particle(const JsonNode& particle, const CommonOfParticles& common, System<Dim>& system) {
  const auto first = static_cast<std::size_t>(system.state.size());
  add_particle(particle, common, system);
  const std::size_t n = static_cast<std::size_t>(system.state.size()) - first;
  const auto list = [&](const char* key) {
    const JsonNode values = particle.at(key);
    if (values.size() != n)
      throw values.fault(fmt::format("has {} entries for {} vertices", values.size(), n));
    return values;
  };
  if (particle.has("v")) {
    const JsonNode v = list("v");
    for (std::size_t k = 0; k < n; ++k) system.state.velocity[first + k] = read_vector<Dim>(v[k]);
  }
  if constexpr (Dim == 2) {
    system.floor_contact.resize(first + n, std::numeric_limits<double>::quiet_NaN());
    if (particle.has("sticks")) read_sticking(list("sticks"), std::span(system.floor_contact).subspan(first));
    if (is_rigid(particle)) make_rigid(system, system.topology.body_count(system.state.size()) - 1);
  }
  read_species_of(particle, common.species, system);
}

template void read_particle(const JsonNode&, const CommonOfParticles&, System<2>&);
template void read_particle(const JsonNode&, const CommonOfParticles&, System<3>&);

}  // namespace supple
