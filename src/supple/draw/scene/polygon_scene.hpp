/// Bodies at one instant, as exports and pictures take them: plain arrays, without the run they come from.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "supple/model/box.hpp"
#include "supple/model/pair_table.hpp"

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
};

/// Sites [begin[b], begin[b+1]) form body b, as in Topology: one site is a disc; three or more are the
/// vertices of a polygon, anticlockwise, its ring one connected copy that may stick out of the cell.
struct PolygonScene {
  Box<2> box;  ///< at its strain
  double time = 0;
  std::vector<std::int32_t> begin;  ///< empty: every site is a disc
  std::vector<Vec2> position;       ///< of each site
  std::vector<double> radius;       ///< of each site: of the disc, or half the diameter of a vertex
  std::vector<SceneArray> of_sites, of_bodies;
  std::vector<SceneContact> contacts = {};
  std::map<std::string, double> numbers = {};  ///< of all: "pressure", ...

  std::int32_t sites() const { return static_cast<std::int32_t>(position.size()); }
  std::int32_t bodies() const {
    return begin.empty() ? sites() : static_cast<std::int32_t>(begin.size()) - 1;
  }
  /// First site of body b and the one after its last.
  std::pair<std::int32_t, std::int32_t> body(std::int32_t b) const {
    return begin.empty() ? std::pair(b, b + 1) : std::pair(begin[b], begin[b + 1]);
  }
};

/// Throws an input error ("cannot write 'PATH'") where the arrays do not fit together, a body has two sites
/// or none, or two arrays share a name.
void check_scene(const PolygonScene& scene, const std::string& path);

/// Body of each site.
std::vector<std::int32_t> body_of_sites(const PolygonScene& scene);

/// Where bodies are put: each whole, moved by lattice vectors until the mean of its sites lies in the leaning
/// cell (the cell as drawn); or with the positions of the run, from which displacements follow.
enum class Placement { in_cell, unwrapped };

/// What to add to the positions of each body.
std::vector<Vec2> placement_shifts(const PolygonScene& scene, Placement placement);

}  // namespace supple
