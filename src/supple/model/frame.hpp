/// A system at one instant as files and pictures show it, and what stays the same in a run.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <numeric>
#include <string>
#include <variant>
#include <vector>

#include "supple/model/box.hpp"
#include "supple/model/pair_table.hpp"
#include "supple/model/state.hpp"
#include "supple/model/topology.hpp"
#include "supple/model/units.hpp"

namespace supple {

/// A contact as files and pictures show it, first < second. elongation_back is the elongation that `second`
/// keeps in the published package; elsewhere it equals elongation. Nothing is tangential in 3D as yet.
template <int Dim>
struct ContactRow {
  std::int32_t first, second;
  ContactState state;
  double elongation, elongation_back;
  double normal_force;              ///< elastic + viscous; positive: pushes apart
  double tangential_force;          ///< on `first` along t = (-n_y, n_x), n from first to second
  double elastic = 0, viscous = 0;  ///< parts of the normal force: of the repulsion or link, of the dashpot
  Vec<Dim> force{};                 ///< on `first`; its opposite acts on `second`
};

/// Numbers of bodies by name (numbers_in_frames): "pressure", "shape_parameter", ...; one for each body.
using BodyNumbers = std::map<std::string, std::vector<double>>;

/// Numbers of the whole system by name (numbers_in_frames): "pressure", "elastic_energy", ...
using SystemNumbers = std::map<std::string, double>;

/// The whole system at one instant, for trajectories and pictures, in the units of the run.
template <int Dim>
struct Frame {
  std::int64_t step = 0;
  double time = 0, strain = 0, strain_rate = 0;
  std::vector<Vec<Dim>> position, velocity, force;
  std::vector<double> angle;
  std::vector<Angular<Dim>> spin, torque;
  std::vector<Mobility> mobility;
  std::vector<ContactRow<Dim>> contacts;
  Vec<Dim> length{};      ///< of the cell at this instant; 0: that of the run
  BodyNumbers body;       ///< the same names in all frames of a run
  SystemNumbers numbers;  ///< these too
};

/// Whether two frames are of the same instant. Recorders keep each instant once, by the first frame of it.
template <int Dim>
bool same_instant(const Frame<Dim>& a, const Frame<Dim>& b) {
  return a.step == b.step && a.time == b.time && a.position == b.position;
}

/// What stays the same in a run, written before the first step: sizes and masses of sites stand here and not
/// in frames.
template <int Dim>
struct RunInfo {
  Units units;
  Box<Dim> box;
  std::vector<double> radius, mass, inertia;
  std::vector<std::int32_t>
      particle;  ///< of each site, 0-based: crosslinked particle of a disc, body of a vertex
  std::vector<std::int32_t> body_begin;  ///< Topology::begin; empty: microgel discs
  /// Sites of each triangle, seen counter-clockwise from outside. Empty in 2D, where an edge of a body is
  /// from each site of its boundary to the next.
  std::vector<std::array<std::int32_t, Dim>> facet;
  /// Sites of each body on its boundary, which come first in it. Empty: all, as no body has an inside.
  std::vector<std::int32_t> boundary_sites;
  std::vector<std::array<std::int32_t, 2>> bond;  ///< sites of each spring inside a body
};

/// Bodies and triangles of a run in 3D, without hinges.
inline Topology<3> topology_of(const RunInfo<3>& info) {
  Topology<3> t;
  t.begin = info.body_begin;
  t.facet = info.facet;
  t.facet_begin.assign(std::max<std::size_t>(t.begin.size(), 1), 0);
  for (const auto& facet : t.facet) ++t.facet_begin[info.particle[facet[0]] + 1];
  std::partial_sum(t.facet_begin.begin(), t.facet_begin.end(), t.facet_begin.begin());
  return t;
}

/// A frame, and what stays the same, of a run in two dimensions or three.
using AnyFrame = std::variant<Frame<2>, Frame<3>>;
using AnyRunInfo = std::variant<RunInfo<2>, RunInfo<3>>;

}  // namespace supple
