/// Systems of triangulated surfaces that an independent program computed: tests/data/surfaces/.
#pragma once
#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "supple/build/surfaces.hpp"
#include "supple/core/error.hpp"
#include "tests/paths.hpp"

namespace supple::testing {

/// A file of the folder: its system, and all that the file says. `file["expected"]` has what the other
/// program found, `file["convention"]` says what that means.
struct SurfaceReference {
  System<3> system;
  nlohmann::json file;

  const nlohmann::json& expected() const { return file.at("expected"); }
  double stiffness(const char* name) const { return file.at("stiffness").at(name); }
};

/// The numbers of a list of three numbers each, such as positions and forces.
inline std::vector<Vec3> vectors_of(const nlohmann::json& list) {
  std::vector<Vec3> all;
  for (const auto& x : list) all.push_back({x.at(0), x.at(1), x.at(2)});
  return all;
}

/// Rest angles in the order of hinges_of(mesh), of which the file has one for each of its own edges.
inline std::vector<double> rest_angles_of(const nlohmann::json& particle, const TriangleMesh& mesh) {
  const auto undirected = [](std::int32_t a, std::int32_t b) {
    return std::array{std::min(a, b), std::max(a, b)};
  };
  std::map<std::array<std::int32_t, 2>, double> of_edge;
  for (std::size_t e = 0; e < particle.at("edges").size(); ++e)
    of_edge[undirected(particle["edges"][e].at(0), particle["edges"][e].at(1))] = particle.at("theta0").at(e);
  std::vector<double> angles;
  for (const auto& hinge : hinges_of(mesh)) angles.push_back(of_edge.at(undirected(hinge[0], hinge[1])));
  return angles;
}

/// Adds a particle of a file, with the radius sigma/2; one that has no sigma gets half the mean edge.
inline void add_particle(System<3>& system, const nlohmann::json& particle, const ShapeStiffness& stiffness) {
  TriangleMesh mesh{vectors_of(particle.at("vertices")), {}};
  for (const auto& f : particle.at("faces")) mesh.face.push_back({f.at(0), f.at(1), f.at(2)});
  const double sigma = particle.value("sigma", mean_edge(mesh));
  add_surface(system, mesh, 0.5 * sigma, stiffness, particle.at("v0"),
              particle.at("a0").get<std::vector<double>>(), rest_angles_of(particle, mesh));
}

/// Reads tests/data/surfaces/NAME.json. A particle alone is in a cell that is not periodic.
inline SurfaceReference read_surfaces(const std::string& name) {
  const std::string path = std::string(SUPPLE_TEST_DATA) + "/surfaces/" + name + ".json";
  std::ifstream stream(path);
  if (!stream) throw input_error("cannot read " + path, "there is no such file");
  SurfaceReference reference{{}, nlohmann::json::parse(stream)};
  const nlohmann::json& file = reference.file;
  System<3>& system = reference.system;
  const ShapeStiffness stiffness{reference.stiffness("k_v"), reference.stiffness("k_a"),
                                 reference.stiffness("k_b"), reference.stiffness("gamma")};
  if (file.contains("box")) {
    const std::vector<Vec3> rows = vectors_of(file["box"]);
    system.box.length = {rows[0][0], rows[1][1], rows[2][2]};
    system.box.strain = rows[0][1] / rows[1][1];
    for (const auto& particle : file.at("particles")) add_particle(system, particle, stiffness);
  } else {
    system.box.length = {100, 100, 100};
    system.box.periodic = {false, false, false};
    add_particle(system, file, stiffness);
  }
  return reference;
}

}  // namespace supple::testing
