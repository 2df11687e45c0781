/// Polygons, triangles and spheres for ParaView, OVITO and other programs that read VTK files.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "supple/core/new_file.hpp"
#include "supple/draw/scene/body_scene.hpp"
#include "supple/io/export/vtk_cells.hpp"

namespace supple {

/// Writes one instant as VTK XML PolyData (.vtp): bodies as `cells` (vtk_cells), binary64 throughout.
///
/// * Points: in 2D the vertices, or points of outlines with the numbers of the nearest vertex, z = 0; in 3D
/// the
///   sites, each once and in their order.
/// * Data of points: `site`, `radius`, then `of_sites` of the scene by their names. Vectors have three
///   components.
/// * Cells: polygons or triangles; in 3D, before them, vertices, one for each sphere.
/// * Data of cells: `id` (body, 0-based), `sites` (1: a disc or sphere), `radius` (of the disc, sphere or
/// first
///   vertex), and `of_bodies` of the scene by their names.
/// * Data of the field: `TimeValue`, the edges of the leaning cell as rows of `cell` and the corner where
/// they
///   begin as `cell_origin` (space_cell), and the numbers of the whole system.
///
/// Programs know no periodic cell in this format: bodies are whole, moved as `placement` says. The time
/// stands in the collection (write_pvd) too. The encoding (inline base64, uncompressed) is one that ParaView
/// and OVITO both read; OVITO shows no vertices, and where there are any it leaves out the data of cells.
/// Throws an input error where the arrays do not fit together or have one of these names, where there are no
/// such cells in so many dimensions, and file errors.
template <int Dim>
void write_vtp(const std::string& path, const BodyScene<Dim>& scene, Existing existing = Existing::refuse,
               Placement placement = Placement::in_cell, Cells cells = Cells::polygons);

/// A frame of a collection: its time and its file, relative to the folder of the collection.
using PvdEntry = std::pair<double, std::string>;

/// Writes a ParaView collection (.pvd): the frames of a run in the order of time. Programs show one frame for
/// each time, so throws an input error where times do not ascend; and file errors.
void write_pvd(const std::string& path, const std::vector<PvdEntry>& frames,
               Existing existing = Existing::refuse);

}  // namespace supple
