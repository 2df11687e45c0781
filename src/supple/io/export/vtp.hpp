/// Polygons for ParaView, OVITO and other programs that read VTK files.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "supple/core/new_file.hpp"
#include "supple/draw/scene/scene.hpp"

namespace supple {

/// What the cells of a file are. ParaView and VTK draw and measure a cell as a fan of triangles from its
/// first point, which is wrong for one that is not convex: right areas of such bodies need `triangles`.
enum class Cells {
  polygons,   ///< one for each body: its vertices
  outlines,   ///< one for each body: the outline with the discs on its vertices, holes filled
  triangles,  ///< the outlines in triangles, each with the numbers of its body
};

/// Writes one instant as VTK XML PolyData (.vtp): bodies as `cells`, z = 0, binary64 throughout.
///
/// * Points: the vertices, or points of outlines with the numbers of the nearest vertex. A disc is drawn as a
///   regular polygon of `disc_corners` corners on its circle.
/// * Data of points: `site`, `radius`, then `of_sites` of the scene by their names. Vectors have three
///   components.
/// * Data of cells: `id` (body, 0-based), `sites` (1: a disc), `radius` (of the disc or the first vertex),
///   and `of_bodies` of the scene by their names.
/// * Data of the field: `TimeValue` and the numbers of the whole system.
///
/// The periodic cell has no place in this format: bodies are whole, moved as `placement` says. The time
/// stands in the collection (write_pvd) too. The encoding (inline base64, uncompressed) is one that ParaView
/// and OVITO both read. Throws an input error where the arrays do not fit together or have one of these
/// names, and file errors.
void write_vtp(const std::string& path, const Scene& scene, Existing existing = Existing::refuse,
               Placement placement = Placement::in_cell, Cells cells = Cells::polygons);

/// Corners of the polygon as which a disc is drawn.
inline constexpr int disc_corners = 32;

/// A frame of a collection: its time and its file, relative to the folder of the collection.
using PvdEntry = std::pair<double, std::string>;

/// Writes a ParaView collection (.pvd): the frames of a run in the order of time. Programs show one frame for
/// each time, so throws an input error where times do not ascend; and file errors.
void write_pvd(const std::string& path, const std::vector<PvdEntry>& frames,
               Existing existing = Existing::refuse);

}  // namespace supple
