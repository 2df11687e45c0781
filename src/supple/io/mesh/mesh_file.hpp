/// Files of closed triangle meshes: OBJ, STL, PLY and OFF.
///
/// Reading is strict: a file is read as it stands or refused, never repaired.
///
/// * OBJ: `v` (three coordinates; a weight of 1 or a colour may follow) and `f` (corners from 1 on, or from
///   -1 backwards, of vertices that stand before). Normals, texture coordinates, groups, objects, materials,
///   lines (`l`) and points (`p`) are ignored; curves and free-form surfaces are refused.
/// * STL, as text and binary: a facet has corners of its own. Those whose coordinates are equal, bit for bit
///   but for the sign of 0, become one vertex; vertices are numbered by their first use. Coordinates that
///   differ in the last digit stay two vertices, and the surface is refused. The order of corners says where
///   outside is, the stated normal does not; a facet whose normal points the other way than its corners is
///   refused. Solids of one file are read as one surface. A binary file is known by its size, 84 + 50 n,
///   whatever its header begins with.
/// * PLY, as text and binary of either byte order: `x`, `y`, `z` of `vertex` of any type, and the list
///   `vertex_indices` or `vertex_index` of `face`; other properties and elements are ignored. Digits are read
///   as doubles, also where the header calls them float.
/// * OFF, and with colours, normals or texture coordinates (COFF, NOFF, STOFF), which are ignored; one vertex
///   or face on a line. The number of edges may be missing and is not compared.
///
/// Lines end with any of \n, \r\n and \r. Length is whatever the file means: none of the formats has units.
#pragma once
#include <string>

#include "supple/core/new_file.hpp"
#include "supple/model/triangle_mesh.hpp"

namespace supple {

/// The surface [length of the file], vertices and triangles in the order of the file, every coordinate the
/// double nearest to its digits. The format is recognised by the content, else by the ending. A file is one
/// surface in one piece: which of several pieces is which particle is not for a reader to say. Throws
///
/// * a file error with the line, or the byte in a binary file, where the file cannot be read, is damaged or
///   cut off, has faces of other than three corners, or is longer than 2^28 bytes (several million
///   triangles);
/// * an input error where what it holds is no sound surface (find_fault), with the lines or bytes of the
///   triangles and vertices that the error names.
TriangleMesh read_mesh(const std::string& path);

/// Writes a surface in the format that the ending says: .obj, .off (text of as few digits as read back to the
/// same doubles), .ply (binary doubles) or .stl. read_mesh gives the same bits and order, but for STL: it is
/// binary and holds floats of 7 digits, and its vertices come back in the order of their first use. Throws an
/// input error where the ending is another one or the mesh is no sound surface (find_fault), in STL after
/// rounding; a file error where the file cannot be written. Then no file is left.
void write_mesh(const std::string& path, const TriangleMesh& mesh, Existing existing = Existing::refuse);

}  // namespace supple
