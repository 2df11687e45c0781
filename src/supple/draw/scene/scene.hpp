/// Bodies in the plane at one instant, as pictures take them.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "supple/draw/scene/body_scene.hpp"
#include "supple/model/pair_table.hpp"
#include "supple/model/state.hpp"

namespace supple {

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

/// What a picture of bodies in the plane shows beside the bodies.
struct Scene : BodyScene<2> {
  std::vector<SceneContact> contacts = {};
  std::vector<std::int32_t> particle = {};    ///< of each body: what crosslinks join; empty: each its own
  std::vector<Mobility> mobility = {};        ///< of each site; empty: all free
  Boundary boundary = Boundary::rough;        ///< of polygons
  std::optional<Walls> walls = std::nullopt;  ///< empty: every side that is not periodic

  std::int32_t particle_of(std::int32_t b) const { return particle.empty() ? b : particle[b]; }
  /// Whether all sites of body b are held, by a plate or otherwise.
  bool is_held(std::int32_t b) const;
};

/// Throws an input error ("cannot write 'PATH'") where check_bodies() does, or what a picture shows beside
/// the bodies does not fit to them.
void check_scene(const Scene& scene, const std::string& path);

/// Whether each body is a disc that crosslinks could join to others and do not.
std::vector<bool> single_discs(const Scene& scene);

/// The 99th percentile of the forces of contacts, in SI where the run has such units; 0 without contacts.
double strongest_force(const Scene& scene);

}  // namespace supple
