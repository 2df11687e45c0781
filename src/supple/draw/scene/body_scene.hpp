/// Bodies at one instant in two dimensions or three, as exports take them: plain arrays, independent of the
/// run that they come from.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "supple/model/box.hpp"
#include "supple/model/units.hpp"

namespace supple {

/// Named values, one for each site or one for each body.
struct SceneArray {
  std::string name;
  std::variant<std::vector<double>, std::vector<Vec2>, std::vector<std::int32_t>, std::vector<Vec3>> values;
  bool about_normal = false;  ///< numbers about the normal of the plane, as spins: in space (0, 0, value)
};

/// Sites [begin[b], begin[b+1]) form body b, as in Topology. One site is a disc or sphere. In 2D, three or
/// more are the vertices of a polygon, anticlockwise; in 3D, they are the vertices of a closed surface, of
/// which `facet` holds the triangles. In a solid those inside follow. Each body is one connected copy that
/// may stick out of the cell.
template <int Dim>
struct BodyScene {
  Units units = reduced_units();
  Box<Dim> box;  ///< at its strain
  double time = 0;
  std::vector<std::int32_t> begin;  ///< empty: every site is a disc or sphere
  std::vector<Vec<Dim>> position;   ///< of each site [length]
  std::vector<double> radius;       ///< of each site: of the disc, or half the diameter of a vertex [length]
  /// Sites of each triangle, counter-clockwise as seen from outside. Empty in 2D.
  std::vector<std::array<std::int32_t, Dim>> facet = {};
  std::vector<std::int32_t> boundary_sites = {};       ///< of each body, its first ones; empty: all
  std::vector<std::array<std::int32_t, 2>> bond = {};  ///< sites of each spring inside a body
  std::vector<SceneArray> of_sites = {}, of_bodies = {};
  std::map<std::string, double> numbers = {};  ///< of all: "pressure", ...

  std::int32_t sites() const { return static_cast<std::int32_t>(position.size()); }
  std::int32_t bodies() const {
    return begin.empty() ? sites() : static_cast<std::int32_t>(begin.size()) - 1;
  }
  /// First site of body b and the one after its last.
  std::pair<std::int32_t, std::int32_t> body(std::int32_t b) const {
    return begin.empty() ? std::pair(b, b + 1) : std::pair(begin[b], begin[b + 1]);
  }
  /// The same of the sites on its boundary: the vertices of the polygon or surface.
  std::pair<std::int32_t, std::int32_t> boundary_of(std::int32_t b) const {
    const auto [first, last] = body(b);
    return {first, boundary_sites.empty() ? last : first + boundary_sites[b]};
  }
  std::span<const Vec<Dim>> positions_of(std::int32_t b) const { return of_boundary(position, b); }
  std::span<const double> radii_of(std::int32_t b) const { return of_boundary(radius, b); }
  /// Mean of the sites on the boundary of body b [length].
  Vec<Dim> centre_of(std::int32_t b) const;
  /// Whether body b is one site: a disc or a sphere.
  bool is_disc(std::int32_t b) const { return body(b).second - body(b).first == 1; }

 protected:
  template <class T>
  std::span<const T> of_body(const std::vector<T>& values, std::int32_t b) const {
    const auto [first, last] = body(b);
    return {values.begin() + first, values.begin() + last};
  }
  template <class T>
  std::span<const T> of_boundary(const std::vector<T>& values, std::int32_t b) const {
    const auto [first, last] = boundary_of(b);
    return {values.begin() + first, values.begin() + last};
  }
};

/// Throws an input error ("cannot write 'PATH'") where the arrays do not fit together, a body has a number of
/// sites that no body has, a triangle names a site that is not there or two arrays share a name.
template <int Dim>
void check_bodies(const BodyScene<Dim>& scene, const std::string& path);

/// Body of each site.
template <int Dim>
std::vector<std::int32_t> body_of_sites(const BodyScene<Dim>& scene);

/// Where bodies are put. in_cell: each is moved as a whole by lattice vectors until the mean of its sites
/// lies in the leaning cell (drawn_cell.hpp). unwrapped: where they are in the run, so that displacements
/// between frames can be computed.
enum class Placement { in_cell, unwrapped };

/// The vector to add to the positions of each body [length].
template <int Dim>
std::vector<Vec<Dim>> placement_shifts(const BodyScene<Dim>& scene, Placement placement);

}  // namespace supple
