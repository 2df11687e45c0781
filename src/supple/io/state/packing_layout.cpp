#include "supple/io/state/packing_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "supple/io/state/held_keys_json.hpp"

namespace supple {

namespace {

/// The cell of a matrix whose columns are its periods; that along the gradient leans along the flow [Lees &
/// Edwards 1972].
template <int Dim>
void read_matrix(const JsonNode& root, Box<Dim>& cell) {
  const JsonNode box = root.at("box");
  std::array<Vec<Dim>, Dim> m;
  for (int i = 0; i < Dim; ++i) m[i] = read_vector<Dim>(box[static_cast<std::size_t>(i)]);
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j) {
      const JsonNode entry = box[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
      if (i == j) cell.length[i] = entry.positive();
      else if (m[i][j] != 0 && !(i == flow && j == gradient))
        throw entry.fault(
            fmt::format(
                "is {:.6g}, not 0: the columns are the periods of the cell, and that along y alone may "
                "lean, along x: box[0][1]",
                m[i][j]),
            i > j ? "transpose the matrix if its rows are the periods, or turn the axes"
                  : "turn the axes until the shear is along x");
    }
  if (root.has("strain"))
    throw root.at("strain").fault("stands beside a matrix, which says it by box[0][1]", "leave one away");
  cell.strain = m[flow][gradient] / cell.length[gradient];
}

}  // namespace

template <>
std::vector<std::string> keys_of_packing<2>() {
  return {"k_a",     "k_l",       "k_b",      "gamma",   "k_c",        "stiffness",    "contact_stiffness",
          "contact", "box",       "periodic", "strain",  "walls",      "gravity",      held_keys_name,
          "species", "particles", "name",     "comment", "convention", "phi_reported", "expected"};
}
template <>
std::vector<std::string> keys_of_packing<3>() {
  std::vector<std::string> keys = keys_of_packing<2>();
  std::replace(keys.begin(), keys.end(), std::string("k_a"), std::string("k_v"));
  std::replace(keys.begin(), keys.end(), std::string("k_l"), std::string("k_a"));
  return keys;
}
template <>
std::vector<std::string> keys_of_particle<2>() {
  return {"sigma",   "x",   "a0",  "l0",  "theta0", "rigid",       "v", "sticks",
          "species", "k_a", "k_l", "k_b", "gamma",  "k_perimeter", "p0"};
}
template <>
std::vector<std::string> keys_of_particle<3>() {
  return {"sigma",  "x", "vertices", "faces", "edges", "v0",  "a0",
          "theta0", "v", "species",  "k_v",   "k_a",   "k_b", "gamma"};
}

template <int Dim>
void expect_keys(const JsonNode& node, const std::vector<std::string>& known,
                 const std::vector<std::string>& other) {
  const auto is_in = [](const std::vector<std::string>& list, const std::string& key) {
    return std::find(list.begin(), list.end(), key) != list.end();
  };
  for (const std::string& key : node.keys())
    if (!is_in(known, key) && is_in(other, key))
      throw node.fault(
          fmt::format("has the key \"{}\" of {}, but the points of the first particle have {} numbers", key,
                      shapes_of_packing<5 - Dim>, numbers_of_point<Dim>),
          "its keys are " + join_names(known));
  node.expect_only(known);
}

template <int Dim>
Vec<Dim> read_vector(const JsonNode& node) {
  if (node.size() != Dim)
    throw node.fault(fmt::format("is not {} numbers", numbers_of_point<Dim>),
                     node.size() == 5 - Dim
                         ? "a packing is in two dimensions or in three, as the points of its first particle"
                         : "");
  Vec<Dim> v;
  for (int d = 0; d < Dim; ++d) v[d] = node[static_cast<std::size_t>(d)].number();
  return v;
}

double read_stiffness(const JsonNode& node) {
  const double k = node.number();
  if (k < 0) throw node.fault("is negative");
  return k;
}

template <int Dim>
Box<Dim> read_cell(const JsonNode& root) {
  Box<Dim> cell;
  const JsonNode box = root.at("box");
  if (box.is_list() && box.size() == Dim && box[0].is_list()) {
    read_matrix(root, cell);
  } else if (box.is_list()) {
    cell.length = read_vector<Dim>(box);
    for (int d = 0; d < Dim; ++d)
      if (!(cell.length[d] > 0)) throw box.fault("is not positive");
  } else {
    const double length = box.positive();
    for (int d = 0; d < Dim; ++d) cell.length[d] = length;
  }
  if (root.has("strain")) cell.strain = root.at("strain").number();
  if (!root.has("periodic")) return cell;
  const JsonNode periodic = root.at("periodic");
  if (periodic.size() != Dim) throw periodic.fault(fmt::format("is not {} values", numbers_of_point<Dim>));
  for (std::size_t d = 0; d < Dim; ++d) cell.periodic[d] = periodic[d].truth();
  return cell;
}

template <int Dim>
Environment read_environment(const JsonNode& root, const Box<Dim>& cell) {
  Environment e;
  if (root.has("walls")) {
    const JsonNode walls = root.at("walls");
    std::vector<std::string> names, standing;
    for_each_wall<Dim>(e, [&](const char* name, bool) { names.emplace_back(name); });
    for (std::size_t k = 0; k < walls.size(); ++k) {
      standing.push_back(walls[k].text());
      if (std::find(names.begin(), names.end(), standing.back()) == names.end())
        throw walls[k].fault(fmt::format("is \"{}\", not one of {}", standing.back(), join_names(names)));
    }
    for_each_wall<Dim>(e, [&](const std::string& name, bool& stands) {
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

template void expect_keys<2>(const JsonNode&, const std::vector<std::string>&,
                             const std::vector<std::string>&);
template void expect_keys<3>(const JsonNode&, const std::vector<std::string>&,
                             const std::vector<std::string>&);
template Vec2 read_vector<2>(const JsonNode&);
template Vec3 read_vector<3>(const JsonNode&);
template Box<2> read_cell(const JsonNode&);
template Box<3> read_cell(const JsonNode&);
template Environment read_environment(const JsonNode&, const Box<2>&);
template Environment read_environment(const JsonNode&, const Box<3>&);

}  // namespace supple
