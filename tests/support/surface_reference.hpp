/// Systems of triangulated surfaces that an independent program computed: tests/data/surfaces/.
#pragma once
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "supple/build/surfaces.hpp"
#include "supple/io/state/packing_file.hpp"
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

/// tests/data/surfaces/NAME.json.
inline std::string reference_path(const std::string& name) {
  return std::string(SUPPLE_TEST_DATA) + "/surfaces/" + name + ".json";
}

/// Reads tests/data/surfaces/NAME.json. A particle alone is in a cell that is not periodic.
inline SurfaceReference read_surfaces(const std::string& name) {
  const std::string path = reference_path(name);
  return {read_packing_json<3>(path).system, nlohmann::json::parse(std::ifstream(path))};
}

}  // namespace supple::testing
