#include "supple/io/export/vtp.hpp"

#include <bit>
#include <cmath>
#include <cstring>
#include <numbers>

#include "supple/core/error.hpp"
#include "supple/draw/scene/polygon_outline.hpp"
#include "supple/io/text/number_text.hpp"

namespace supple {

namespace {

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
  std::vector<double> padded;
  std::string_view bytes(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
  if constexpr (std::is_same_v<T, Vec2>) {
    for (const Vec2& v : values) padded.insert(padded.end(), {v[0], v[1], 0});
    bytes = {reinterpret_cast<const char*>(padded.data()), padded.size() * sizeof(double)};
  }
  const std::uint64_t size = bytes.size();
  std::string block(sizeof size, '\0');
  std::memcpy(block.data(), &size, sizeof size);
  block += bytes;
  xml += "<DataArray type=\"" + std::string(vtk_type<T>) + "\" Name=\"" + escaped(name) +
         "\" NumberOfComponents=\"" + (std::is_same_v<T, Vec2> ? "3" : "1") + "\"" + attributes +
         " format=\"binary\">";
  append_base64(xml, block);
  xml += "</DataArray>\n";
}

/// The cells: points, the site that each stands for, and the body of each cell.
struct Polygons {
  std::vector<Vec2> point;
  std::vector<std::int32_t> site;
  std::vector<std::int64_t> offset;  ///< one after the last point of each
  std::vector<std::int32_t> body;    ///< of each

  Polygons(const Scene& scene, const std::vector<Vec2>& shift, Cells cells) {
    for (std::int32_t b = 0; b < scene.bodies(); ++b) {
      const auto [first, last] = scene.body(b);
      std::vector<Vec2> ring;
      std::vector<double> radius;
      for (std::int32_t i = first; i < last; ++i) {
        ring.push_back(scene.position[i] + shift[b]);
        radius.push_back(scene.radius[i]);
      }
      if (cells == Cells::polygons && ring.size() > 1) {
        for (std::int32_t i = first; i < last; ++i) add(i, ring[i - first]);
        close(b);
        continue;
      }
      const std::vector<Vec2> outline =
          ring.size() == 1 ? circle(ring[0], radius[0]) : outer_ring(ring, radius);
      const auto add_point = [&, first = first](const Vec2& x) { add(first + nearest(ring, x), x); };
      if (cells != Cells::triangles) {
        for (const Vec2& x : outline) add_point(x);
        close(b);
        continue;
      }
      for (const auto& triangle : triangulate(outline)) {
        for (const std::size_t k : triangle) add_point(outline[k]);
        close(b);
      }
    }
  }

 private:
  void add(std::int32_t i, const Vec2& x) {
    point.push_back(x);
    site.push_back(i);
  }
  void close(std::int32_t b) {
    offset.push_back(static_cast<std::int64_t>(point.size()));
    body.push_back(b);
  }
  static std::vector<Vec2> circle(const Vec2& centre, double radius) {
    std::vector<Vec2> out;
    for (int k = 0; k < disc_corners; ++k) {
      const double angle = 2 * std::numbers::pi * k / disc_corners;
      out.push_back(centre + radius * Vec2{std::cos(angle), std::sin(angle)});
    }
    return out;
  }
  static std::int32_t nearest(const std::vector<Vec2>& ring, const Vec2& x) {
    std::size_t best = 0;
    for (std::size_t k = 1; k < ring.size(); ++k)
      if (norm(ring[k] - x) < norm(ring[best] - x)) best = k;
    return static_cast<std::int32_t>(best);
  }
};

void check_names(const std::vector<SceneArray>& arrays, std::initializer_list<std::string_view> taken,
                 const std::string& path) {
  for (const SceneArray& array : arrays)
    for (const std::string_view name : taken)
      if (array.name == name)
        throw input_error("cannot write '" + path + "'", "the name '" + array.name + "' is taken",
                          "rename the array");
}

void append_point_data(std::string& xml, const Scene& scene, const std::vector<std::int32_t>& site) {
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

void append_cell_data(std::string& xml, const Scene& scene, const std::vector<std::int32_t>& body) {
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
void append_time(std::string& xml, const Scene& scene) {
  const std::string one = " NumberOfTuples=\"1\"";
  xml += "<FieldData>\n";
  append_array(xml, "TimeValue", std::vector<double>{scene.time}, one);
  for (const auto& [name, value] : scene.numbers) append_array(xml, name, std::vector<double>{value}, one);
  xml += "</FieldData>\n";
}

void append_polygons(std::string& xml, const Polygons& polygons) {
  std::vector<std::int64_t> connectivity(polygons.point.size());
  for (std::size_t k = 0; k < connectivity.size(); ++k) connectivity[k] = static_cast<std::int64_t>(k);
  xml += "<Points>\n";
  append_array(xml, "Points", polygons.point);
  xml += "</Points>\n<Polys>\n";
  append_array(xml, "connectivity", connectivity);
  append_array(xml, "offsets", polygons.offset);
  xml += "</Polys>\n";
}

void write_new(const std::string& path, const std::string& text, Existing existing) {
  NewFile file(path, existing);
  file.write(text);
  file.commit();
}

}  // namespace

void write_vtp(const std::string& path, const Scene& scene, Existing existing, Placement placement,
               Cells cells) {
  check_scene(scene, path);
  check_names(scene.of_sites, {"site", "radius"}, path);
  check_names(scene.of_bodies, {"id", "sites", "radius"}, path);
  const Polygons polygons(scene, placement_shifts(scene, placement), cells);
  std::string xml =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<PolyData>\n";
  append_time(xml, scene);
  xml += "<Piece NumberOfPoints=\"" + std::to_string(polygons.point.size()) +
         "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
         std::to_string(polygons.body.size()) + "\">\n";
  append_point_data(xml, scene, polygons.site);
  append_cell_data(xml, scene, polygons.body);
  append_polygons(xml, polygons);
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

}  // namespace supple
