/// Bodies as the points and cells of VTK PolyData.
#pragma once
#include <cstdint>
#include <vector>

#include "supple/draw/scene/body_scene.hpp"

namespace supple {

/// What the cells of a file are. ParaView and VTK draw and measure a cell as a fan of triangles from its
/// first point, which is wrong for one that is not convex: right areas of such bodies need `triangles`.
///
/// In 3D `polygons` and `triangles` are the same, the triangles of the surfaces, and there are no `outlines`.
enum class Cells {
  polygons,   ///< one for each body: its vertices
  outlines,   ///< one for each body: the outline with the discs on its vertices, holes filled
  triangles,  ///< the outlines in triangles, each with the numbers of its body
};

/// Points, those that are cells of their own, and polygons.
template <int Dim>
struct VtkCells {
  std::vector<Vec<Dim>> point;       ///< [length]
  std::vector<std::int32_t> site;    ///< that each point stands for
  std::vector<std::int64_t> vertex;  ///< points that are cells: spheres
  std::vector<std::int64_t> connectivity;
  std::vector<std::int64_t> offset;  ///< in connectivity, one after the last point of each polygon
  std::vector<std::int32_t> body;    ///< of each cell: first the vertices, then the polygons
};

/// Throws an input error where there are no such cells in so many dimensions.
void check_cells(Cells cells, int dimensions);

/// The bodies moved by `shift`, one for each. In 2D each polygon has points of its own and a disc is drawn as
/// a regular polygon of `disc_corners` corners on its circle. In 3D point i is site i, a sphere is a vertex
/// and triangles are in the order and orientation of the scene. Throws what check_cells() does.
VtkCells<2> vtk_cells(const BodyScene<2>& scene, const std::vector<Vec2>& shift, Cells cells);
VtkCells<3> vtk_cells(const BodyScene<3>& scene, const std::vector<Vec3>& shift, Cells cells);

/// Corners of the polygon as which a disc is drawn.
inline constexpr int disc_corners = 32;

}  // namespace supple
