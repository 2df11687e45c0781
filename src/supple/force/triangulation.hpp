/// Which triangles, hinges and sites of a closed surface meet, in the order in which vector instructions go
/// over them: what SurfaceShape works on.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "supple/model/topology.hpp"

namespace supple {

/// The surface of one body by numbers that begin at its first site, triangle and hinge. Bodies of the same
/// mesh share it.
///
/// Triangles and hinges go in blocks of eight; the last block is filled up with the last of them. The corner
/// k of triangle t stands at (3 (t / 8) + k) 8 + t % 8 in every list of corners, so that the same corner of
/// eight triangles is one register. Lists of places say where the numbers of something begin: those of a
/// point (of a site, of a triangle's normal, of the force on a corner) at 4 times its number.
class Triangulation {
 public:
  using Place = std::uint32_t;
  static constexpr int block = 8;
  static constexpr int corner_number(int t, int k) { return (3 * (t / block) + k) * block + t % block; }

  /// Of the body b. Input error where its hinges are not the edges of its triangles, each with the two
  /// triangles that have it, once in each direction.
  Triangulation(const Topology<3>& topology, int b);

  /// Whether the body b has this mesh.
  bool is_of(const Topology<3>& topology, int b) const;

  int sites, facets, hinges;
  int facet_blocks, hinge_blocks;

  std::vector<Place> corner_site;     ///< of each corner, the point of its site
  std::vector<Place> corner_hinge;    ///< of each corner, the number of the hinge at the edge opposite to it
  std::vector<Place> hinge_facet[2];  ///< points of the triangles that have its edge forwards, and backwards
  std::vector<Place> hinge_outer[2];  ///< points of their sites that are not on the edge
  std::vector<Place> hinge_corner;    ///< number of the corner opposite to the edge in the first of them
  std::vector<std::int32_t> site_begin;
  /// Points of the corners at site i: from site_begin[i] to site_begin[i + 1], an even number of them, so
  /// that sites with five and with six corners take the same time. The last may be no_corner().
  std::vector<Place> site_corner;
  Place no_corner() const { return static_cast<Place>(4 * corner_site.size()); }

  std::vector<std::array<std::int32_t, 3>> facet;  ///< sites of each triangle
  std::vector<std::array<std::int32_t, 4>> hinge;  ///< sites of each hinge, as in Topology

 private:
  void list_corners();
  void join_hinges(int b);
  bool join(int hinge);
};

/// The triangulation of the body b. Each thread keeps the last sixteen meshes that it met and looks whether
/// the body has one of them, so that this takes about a nanosecond a vertex where bodies have few meshes. The
/// reference is good until the thread's next call. Input error as of Triangulation.
const Triangulation& triangulation_of(const Topology<3>& topology, int b);

}  // namespace supple
