#include "supple/io/export/xyz.hpp"

#include <algorithm>
#include <cctype>
#include <set>

#include "supple/core/error.hpp"
#include "supple/io/export/in_space.hpp"
#include "supple/io/text/number_text.hpp"

namespace supple {

namespace {

/// Programs know velocities by this name.
std::string column_name(const SceneArray& array) { return array.name == "velocity" ? "velo" : array.name; }

template <int Dim>
void check_names(const BodyScene<Dim>& scene, const std::string& path) {
  std::set<std::string> names{"type", "pos", "radius", "id", "molecule"};
  const auto is_plain = [](unsigned char c) { return std::isalnum(c) || c == '_'; };
  for (const auto* arrays : {&scene.of_sites, &scene.of_bodies})
    for (const SceneArray& array : *arrays) {
      const std::string what = "cannot write '" + path + "'";
      if (!std::all_of(array.name.begin(), array.name.end(), is_plain))
        throw input_error(what, "array '" + array.name + "'", "a name is made of letters, digits and _");
      if (!names.insert(column_name(array)).second)
        throw input_error(what, "the name '" + array.name + "' is taken", "rename the array");
    }
}

void append_values(std::string& text, double x) {
  text += ' ';
  append_shortest(text, x);
}
void append_values(std::string& text, std::int32_t x) {
  text += ' ';
  append_integer(text, x);
}
void append_values(std::string& text, const Vec3& x) {
  for (int d = 0; d < 3; ++d) append_values(text, x[d]);
}
void append_values(std::string& text, const Vec2& x) { append_values(text, in_space(x)); }

const char* column_type(const SceneArray& array) {
  if (array.about_normal) return ":R:3";
  static constexpr const char* types[] = {":R:1", ":R:3", ":I:1", ":R:3"};  // in the order of the variant
  return types[array.values.index()];
}

/// disc1, polygon2, ... or sphere1, surface2, ...: bodies of equal radius and number of sites are of one
/// type.
template <int Dim>
std::vector<std::string> types_of_bodies(const BodyScene<Dim>& scene) {
  const std::string one = Dim == 2 ? "disc" : "sphere", many = Dim == 2 ? "polygon" : "surface";
  std::vector<std::pair<std::int32_t, double>> sizes;
  std::vector<std::string> names;
  for (std::int32_t b = 0; b < scene.bodies(); ++b) {
    const auto [first, last] = scene.body(b);
    const std::pair size(last - first, scene.radius[first]);
    const auto at = std::find(sizes.begin(), sizes.end(), size) - sizes.begin();
    if (at == static_cast<std::ptrdiff_t>(sizes.size())) sizes.push_back(size);
    names.push_back((last - first == 1 ? one : many) + std::to_string(at + 1));
  }
  return names;
}

/// " a b c" without the first blank.
std::string joined(std::initializer_list<Vec3> vectors) {
  std::string text;
  for (const Vec3& x : vectors) append_values(text, x);
  return text.substr(1);
}

template <int Dim>
std::string header(const BodyScene<Dim>& scene) {
  const SpaceCell cell = space_cell(scene);
  std::string text = std::to_string(scene.sites()) + "\nLattice=\"" +
                     joined({cell.edge[0], cell.edge[1], cell.edge[2]}) + "\" Origin=\"" +
                     joined({cell.origin}) + "\" pbc=\"";
  for (int d = 0; d < 3; ++d) text += std::string(d > 0 ? " " : "") + (cell.periodic[d] ? "T" : "F");
  text += "\" Time=";
  append_shortest(text, scene.time);
  for (const auto& [name, value] : scene.numbers) {
    text += " " + name + "=";
    append_shortest(text, value);
  }
  text += " Properties=type:S:1:pos:R:3:radius:R:1:id:I:1:molecule:I:1";
  for (const auto* arrays : {&scene.of_sites, &scene.of_bodies})
    for (const SceneArray& array : *arrays) text += ":" + column_name(array) + column_type(array);
  return text + "\n";
}

}  // namespace

XyzFile::XyzFile(const std::string& path, Existing existing, Placement placement)
    : path_(path), file_(path, existing), placement_(placement) {}

template <int Dim>
void XyzFile::append(const BodyScene<Dim>& scene) {
  check_bodies(scene, path_);
  check_names(scene, path_);
  const std::vector<std::string> types = types_of_bodies(scene);
  const std::vector<Vec<Dim>> shift = placement_shifts(scene, placement_);
  const std::vector<std::int32_t> body = body_of_sites(scene);
  std::string text = header(scene);
  for (std::int32_t i = 0; i < scene.sites(); ++i) {
    const std::int32_t b = body[i];
    text += types[b];
    append_values(text, scene.position[i] + shift[b]);
    append_values(text, scene.radius[i]);
    append_values(text, i);
    append_values(text, b);
    const auto append_value = [&](const SceneArray& array, std::int32_t at) {
      if (array.about_normal) text += " 0 0";
      std::visit([&](const auto& values) { append_values(text, values[at]); }, array.values);
    };
    for (const SceneArray& array : scene.of_sites) append_value(array, i);
    for (const SceneArray& array : scene.of_bodies) append_value(array, b);
    text += '\n';
  }
  file_.write(text);
}

void XyzFile::commit() { file_.commit(); }

template void XyzFile::append(const BodyScene<2>&);
template void XyzFile::append(const BodyScene<3>&);

}  // namespace supple
