#include "supple/io/export/vtp.hpp"

#include <bit>
#include <cmath>
#include <cstring>
#include <numeric>

#include "supple/core/error.hpp"
#include "supple/io/export/in_space.hpp"
#include "supple/io/text/number_text.hpp"

namespace supple {

namespace {

static_assert(sizeof(Vec3) == 3 * sizeof(double), "arrays of vectors are written as they are");
static_assert(std::endian::native == std::endian::little, "the files are little-endian");

void append_base64(std::string& text, std::string_view bytes) {
  static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    const auto byte = [&](std::size_t i) -> std::uint32_t {
      return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0;
    };
    const std::uint32_t three = byte(k) << 16 | byte(k + 1) << 8 | byte(k + 2);
    text += digits[three >> 18];
    text += digits[three >> 12 & 63];
    text += k + 1 < bytes.size() ? digits[three >> 6 & 63] : '=';
    text += k + 2 < bytes.size() ? digits[three & 63] : '=';
  }
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&') out += "&amp;";
    else if (c == '<') out += "&lt;";
    else if (c == '>') out += "&gt;";
    else if (c == '"') out += "&quot;";
    else out += c;
  }
  return out;
}

template <class T>
constexpr const char* vtk_type = "Float64";
template <>
constexpr const char* vtk_type<std::int32_t> = "Int32";
template <>
constexpr const char* vtk_type<std::int64_t> = "Int64";

/// The size in bytes, then the values, encoded as one: what VTK calls uncompressed inline binary.
template <class T>
void append_array(std::string& xml, const std::string& name, const std::vector<T>& values,
                  const std::string& attributes = "") {
  const std::uint64_t size = values.size() * sizeof(T);
  std::string block(sizeof size, '\0');
  std::memcpy(block.data(), &size, sizeof size);
  block.append(reinterpret_cast<const char*>(values.data()), size);
  xml += "<DataArray type=\"" + std::string(vtk_type<T>) + "\" Name=\"" + escaped(name) +
         "\" NumberOfComponents=\"" + (std::is_same_v<T, Vec3> ? "3" : "1") + "\"" + attributes +
         " format=\"binary\">";
  append_base64(xml, block);
  xml += "</DataArray>\n";
}
void append_array(std::string& xml, const std::string& name, const std::vector<Vec2>& values) {
  std::vector<Vec3> padded;
  for (const Vec2& v : values) padded.push_back(in_space(v));
  append_array(xml, name, padded);
}

void check_names(const std::vector<SceneArray>& arrays, std::initializer_list<std::string_view> taken,
                 const std::string& path) {
  for (const SceneArray& array : arrays)
    for (const std::string_view name : taken)
      if (array.name == name)
        throw input_error("cannot write '" + path + "'", "the name '" + array.name + "' is taken",
                          "rename the array");
}

template <int Dim>
void append_point_data(std::string& xml, const BodyScene<Dim>& scene, const std::vector<std::int32_t>& site) {
  const auto append = [&](const std::string& name, const auto& of_sites) {
    std::remove_cvref_t<decltype(of_sites)> values;
    for (const std::int32_t i : site) values.push_back(of_sites[i]);
    append_array(xml, name, values);
  };
  xml += "<PointData>\n";
  append_array(xml, "site", site);
  append("radius", scene.radius);
  for (const SceneArray& array : scene.of_sites)
    std::visit([&](const auto& values) { append(array.name, values); }, array.values);
  xml += "</PointData>\n";
}

template <int Dim>
void append_cell_data(std::string& xml, const BodyScene<Dim>& scene, const std::vector<std::int32_t>& body) {
  std::vector<std::int32_t> sites;
  std::vector<double> radius;
  for (const std::int32_t b : body) {
    const auto [first, last] = scene.body(b);
    sites.push_back(last - first);
    radius.push_back(scene.radius[first]);
  }
  xml += "<CellData>\n";
  append_array(xml, "id", body);
  append_array(xml, "sites", sites);
  append_array(xml, "radius", radius);
  const auto append = [&](const std::string& name, const auto& of_bodies) {
    std::remove_cvref_t<decltype(of_bodies)> values;
    for (const std::int32_t b : body) values.push_back(of_bodies[b]);
    append_array(xml, name, values);
  };
  for (const SceneArray& array : scene.of_bodies)
    std::visit([&](const auto& values) { append(array.name, values); }, array.values);
  xml += "</CellData>\n";
}

/// ParaView takes the time from here where there is no collection.
template <int Dim>
void append_field_data(std::string& xml, const BodyScene<Dim>& scene) {
  const auto append = [&](const std::string& name, const auto& values) {
    append_array(xml, name, values, " NumberOfTuples=\"" + std::to_string(values.size()) + "\"");
  };
  const SpaceCell cell = space_cell(scene);
  xml += "<FieldData>\n";
  append("TimeValue", std::vector<double>{scene.time});
  append("cell", std::vector<Vec3>(cell.edge.begin(), cell.edge.end()));
  append("cell_origin", std::vector<Vec3>{cell.origin});
  for (const auto& [name, value] : scene.numbers) append(name, std::vector<double>{value});
  xml += "</FieldData>\n";
}

void append_cells(std::string& xml, const std::string& kind, const std::vector<std::int64_t>& connectivity,
                  const std::vector<std::int64_t>& offset) {
  xml += "<" + kind + ">\n";
  append_array(xml, "connectivity", connectivity);
  append_array(xml, "offsets", offset);
  xml += "</" + kind + ">\n";
}

template <int Dim>
void append_geometry(std::string& xml, const VtkCells<Dim>& cells) {
  xml += "<Points>\n";
  append_array(xml, "Points", cells.point);
  xml += "</Points>\n";
  if (!cells.vertex.empty()) {
    std::vector<std::int64_t> offset(cells.vertex.size());
    std::iota(offset.begin(), offset.end(), 1);
    append_cells(xml, "Verts", cells.vertex, offset);
  }
  append_cells(xml, "Polys", cells.connectivity, cells.offset);
}

void write_new(const std::string& path, const std::string& text, Existing existing) {
  NewFile file(path, existing);
  file.write(text);
  file.commit();
}

}  // namespace

template <int Dim>
void write_vtp(const std::string& path, const BodyScene<Dim>& scene, Existing existing, Placement placement,
               Cells kind) {
  check_bodies(scene, path);
  check_names(scene.of_sites, {"site", "radius"}, path);
  check_names(scene.of_bodies, {"id", "sites", "radius"}, path);
  const VtkCells<Dim> cells = vtk_cells(scene, placement_shifts(scene, placement), kind);
  std::string xml =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<PolyData>\n";
  append_field_data(xml, scene);
  xml += "<Piece NumberOfPoints=\"" + std::to_string(cells.point.size()) + "\" NumberOfVerts=\"" +
         std::to_string(cells.vertex.size()) +
         "\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
         std::to_string(cells.offset.size()) + "\">\n";
  append_point_data(xml, scene, cells.site);
  append_cell_data(xml, scene, cells.body);
  append_geometry(xml, cells);
  xml += "</Piece>\n</PolyData>\n</VTKFile>\n";
  write_new(path, xml, existing);
}

void write_pvd(const std::string& path, const std::vector<PvdEntry>& frames, Existing existing) {
  std::string xml =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n<Collection>\n";
  for (std::size_t k = 0; k < frames.size(); ++k) {
    if (!std::isfinite(frames[k].first) || (k > 0 && !(frames[k].first > frames[k - 1].first)))
      throw input_error("cannot write '" + path + "'", "the times of its frames do not ascend",
                        "number the frames where the run has no time");
    xml += "<DataSet timestep=\"";
    append_shortest(xml, frames[k].first);
    xml += "\" group=\"\" part=\"0\" file=\"" + escaped(frames[k].second) + "\"/>\n";
  }
  xml += "</Collection>\n</VTKFile>\n";
  write_new(path, xml, existing);
}

template void write_vtp(const std::string&, const BodyScene<2>&, Existing, Placement, Cells);
template void write_vtp(const std::string&, const BodyScene<3>&, Existing, Placement, Cells);

}  // namespace supple
