/// What the published package computed, as stored in tests/data/particleshear.
#pragma once
#include <nlohmann/json.hpp>

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "supple/compat/particleshear/law.hpp"
#include "supple/model/system.hpp"
#include "tests/paths.hpp"
#include "tests/support/gzip.hpp"

namespace supple::testing {

inline std::string reference_path(const std::string& file) {
  return SUPPLE_TEST_DATA "/particleshear/" + file;
}

inline nlohmann::json read_reference_json(const std::string& file) {
  std::ifstream in(reference_path(file));
  return nlohmann::json::parse(in);
}

/// A table with a header; cells stay text.
struct ReferenceTable {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
};

inline std::vector<std::string> split(const std::string& line, char separator) {
  std::vector<std::string> cells;
  std::stringstream stream(line);
  for (std::string cell; std::getline(stream, cell, separator);) cells.push_back(cell);
  if (!line.empty() && line.back() == separator) cells.emplace_back();
  return cells;
}

inline ReferenceTable read_reference_table(const std::string& file, char separator = ',') {
  std::stringstream text(read_gzip(reference_path(file)));
  std::string line;
  std::getline(text, line);
  ReferenceTable table{split(line, separator), {}};
  while (std::getline(text, line)) table.rows.push_back(split(line, separator));
  return table;
}

inline ParticleShearConstants reference_constants(const nlohmann::json& params) {
  ParticleShearConstants c;
  c.k = params["k"];
  c.nu = params["nu"];
  c.k_t = params["k_t"];
  c.nu_t = params["nu_t"];
  c.mu = params["mu"];
  c.central_repulsion_coefficient = params["central_repulsion_coefficient"];
  c.permanent_ratio_central = params["permanent_ratio_central"];
  c.permanent_ratio_tangential = params["permanent_ratio_tangential"];
  c.keep_viscosity_coefficients_constant = params["keep_viscosity_coefficients_constant"];
  return c;
}

inline ContactState reference_contact_state(const std::string& type) {
  return type == "permanent" ? ContactState::permanent
         : type == "slip"    ? ContactState::slip
                             : ContactState::stick;
}

inline System<2> reference_system(const nlohmann::json& params, const nlohmann::json& initial) {
  System<2> system;
  system.box.length = {params["size_x"], params["size_y"]};
  system.box.strain = initial["shear"];
  system.box.strain_rate = initial["shear_rate"];
  system.time = initial["t"];
  const auto& spheres = initial["spheres"];
  const int n = static_cast<int>(spheres.size());
  State<2>& s = system.state;
  s.resize(n);
  for (int i = 0; i < n; ++i) {
    const auto& sphere = spheres[i];
    s.position[i] = {sphere["x"], sphere["y"]};
    s.velocity[i] = {sphere["vx"], sphere["vy"]};
    s.angle[i] = sphere["phi"];
    s.spin[i] = sphere["omega"];
    s.radius[i] = sphere["r"];
    s.mass[i] = sphere["m"];
    s.inertia[i] = sphere["inertia"];
  }
  PairTable& pairs = system.pairs;
  pairs.width = 2;
  for (int i = 0; i < n; ++i)
    for (const auto& entry : initial["neighbors"][i]) {
      const int j = entry["j"];
      if (i < j) set_pair_state(pairs, n, i, j, reference_contact_state(entry["type"]));
      pairs.history[2 * pairs.find(std::min(i, j), std::max(i, j)) + (i < j ? 0 : 1)] = entry["fp"];
    }
  return system;
}

/// Strain rate of the oscillation in a reference trajectory, by its numbers at the first instant.
inline double reference_rate(const nlohmann::json& rate, double time) {
  const double two_pi_f = 2 * 3.141592653589793 * static_cast<double>(rate["frequency"]);
  return static_cast<double>(rate["amplitude"]) * std::cos(two_pi_f * time) * two_pi_f;
}

}  // namespace supple::testing
