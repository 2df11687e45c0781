/// Bodies at one instant, as exports and pictures take them: plain arrays, independent of the run that they
/// come from.
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "supple/model/box.hpp"
#include "supple/model/pair_table.hpp"
#include "supple/model/state.hpp"
#include "supple/model/units.hpp"

namespace supple {

/// Named values, one for each site or one for each body.
struct SceneArray {
  std::string name;
  std::variant<std::vector<double>, std::vector<Vec2>, std::vector<std::int32_t>> values;
  bool about_normal = false;  ///< numbers about the normal of the plane, as spins: in space (0, 0, value)
};

/// Site `first` touches another body: its site `second` or, where `along` > 0, the point at this share of the
/// edge from `second` to the next site of its ring.
struct SceneContact {
  std::int32_t first, second;
  double force;      ///< size of the force, >= 0
  double along = 0;  ///< in [0, 1)
  ContactState state = ContactState::slip;
  bool tension = false;  ///< of a link that is stretched
  Vec2 towards{};        ///< from `first` to its image of `second`, any length; (0, 0): to the nearest image
};

/// What a polygon covers beside itself: the discs on its vertices (rough), or everything within their radius
/// (smooth).
enum class Boundary { rough, smooth };

/// Sides of the cell that are solid.
struct Walls {
  bool left = false, right = false, bottom = false, top = false;
};

/// Sites [begin[b], begin[b+1]) form body b, as in Topology. One site is a disc; three or more are the
/// vertices of a polygon, anticlockwise, one connected copy of it that may stick out of the cell.
struct Scene {
  Units units = reduced_units();
  Box<2> box;  ///< at its strain
  double time = 0;
  std::vector<std::int32_t> begin;  ///< empty: every site is a disc
  std::vector<Vec2> position;       ///< of each site
  std::vector<double> radius;       ///< of each site: of the disc, or half the diameter of a vertex
  std::vector<SceneArray> of_sites, of_bodies;
  std::vector<SceneContact> contacts = {};
  std::map<std::string, double> numbers = {};  ///< of all: "pressure", ...
  std::vector<std::int32_t> particle = {};     ///< of each body: what crosslinks join; empty: each its own
  std::vector<Mobility> mobility = {};         ///< of each site; empty: all free
  Boundary boundary = Boundary::rough;         ///< of polygons
  std::optional<Walls> walls = std::nullopt;   ///< empty: every side that is not periodic

  std::int32_t sites() const { return static_cast<std::int32_t>(position.size()); }
  std::int32_t bodies() const {
    return begin.empty() ? sites() : static_cast<std::int32_t>(begin.size()) - 1;
  }
  /// First site of body b and the one after its last.
  std::pair<std::int32_t, std::int32_t> body(std::int32_t b) const {
    return begin.empty() ? std::pair(b, b + 1) : std::pair(begin[b], begin[b + 1]);
  }
  std::span<const Vec2> positions_of(std::int32_t b) const { return of_body(position, b); }
  std::span<const double> radii_of(std::int32_t b) const { return of_body(radius, b); }
  /// Mean of the sites of body b.
  Vec2 centre_of(std::int32_t b) const;
  bool is_disc(std::int32_t b) const { return body(b).second - body(b).first == 1; }
  std::int32_t particle_of(std::int32_t b) const { return particle.empty() ? b : particle[b]; }
  /// Whether all sites of body b are held, by a plate or otherwise.
  bool is_held(std::int32_t b) const;

 private:
  template <class T>
  std::span<const T> of_body(const std::vector<T>& values, std::int32_t b) const {
    const auto [first, last] = body(b);
    return {values.begin() + first, values.begin() + last};
  }
};

/// Throws an input error ("cannot write 'PATH'") where the arrays do not fit together, a body has two sites
/// or none, or two arrays share a name.
void check_scene(const Scene& scene, const std::string& path);

/// Body of each site.
std::vector<std::int32_t> body_of_sites(const Scene& scene);

/// Whether each body is a disc that crosslinks could join to others and do not.
std::vector<bool> single_discs(const Scene& scene);

/// Where bodies are put. in_cell: each is moved as a whole by lattice vectors until the mean of its sites
/// lies in the leaning cell (drawn_cell.hpp). unwrapped: where they are in the run, so that displacements
/// between frames can be computed.
enum class Placement { in_cell, unwrapped };

/// The vector to add to the positions of each body.
std::vector<Vec2> placement_shifts(const Scene& scene, Placement placement);

/// The 99th percentile of the forces of contacts, in SI where the run has such units; 0 without contacts.
double strongest_force(const Scene& scene);

}  // namespace supple
