/// Polygons for ParaView, OVITO and everything that reads VTK files.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "supple/core/new_file.hpp"
#include "supple/draw/scene/scene.hpp"

namespace supple {

/// What the cells of a file are. ParaView and VTK draw and measure a cell that is not convex as a fan from
/// its first point: right areas of such bodies need triangles.
enum class Cells {
  polygons,   ///< one of each body: its vertices
  outlines,   ///< one of each body: the outline with the discs on its vertices, holes filled
  triangles,  ///< the outlines in triangles, each with the numbers of its body
};

/// Writes one instant as VTK XML PolyData (.vtp): bodies as `cells`, z = 0, binary64 throughout.
///
/// * Points: the vertices, or points of outlines, with the numbers of the nearest vertex. A disc is drawn as
/// a regular
///   polygon of `disc_corners` corners on its circle. Data of the field: `TimeValue` and the numbers of all.
/// * Data of cells: `id` (body, 0-based), `sites` (1: a disc), `radius` (of the disc, or of the first
/// vertex), then
///   `of_bodies` by their names. Data of points: `site`, `radius`, then `of_sites`. Vectors have three
///   components.
///
/// The cell has no place in this format: bodies are whole, put by `placement`; the time stands in the
/// collection (write_pvd) too. The encoding (inline base64, uncompressed) is the one that both programs read.
/// Throws an input error where the arrays do not fit together or take one of these names, and file errors.
void write_vtp(const std::string& path, const Scene& scene, Existing existing = Existing::refuse,
               Placement placement = Placement::in_cell, Cells cells = Cells::polygons);

inline constexpr int disc_corners = 32;

/// A frame of a collection: its time and its file, relative to the folder of the collection.
using PvdEntry = std::pair<double, std::string>;

/// Writes a ParaView collection (.pvd): the frames of a run in the order of time. Programs show one frame for
/// each time, so the times must ascend: throws an input error where they do not. Throws file errors.
void write_pvd(const std::string& path, const std::vector<PvdEntry>& frames,
               Existing existing = Existing::refuse);

}  // namespace supple
