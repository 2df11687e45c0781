/// Packings of polygons as JSON: preferred shapes, vertices, stiffnesses, and the cell.
///
///     {"k_a": 1, "k_l": 1, "k_b": 0.01, "k_c": 1, "box": 7.98,
///      "particles": [{"a0": 1.45, "sigma": 0.43, "l0": 0.43, "theta0": 0.63, "x": [[0.70, 1.85], ...]},
///      ...]}
///
/// A particle has the energy (k_a/2)(a/a0-1)^2 + sum (k_l/2)(l/l0-1)^2 + sum (k_b/2)(theta-theta0)^2, a
/// contact (k_c/2)(1-r/sigma)^2 with sigma the mean diameter of the two vertices. "x": the vertices,
/// counter-clockwise and unwrapped. A particle with one vertex is a disc and needs "sigma" and "x" alone.
/// Optional keys:
///
/// * "gamma": line tension, energy gamma p/p0;
/// * "stiffness": "absolute" for (k_a/2)(a-a0)^2 + sum (k_l/2)(l-l0)^2 + ... + gamma p;
/// * "contact_stiffness": "absolute" for (k_c/2)(sigma-r)^2;
/// * "box": [width, height]; "periodic": [true, false]; "strain" of the cell;
/// * "l0" (if absolute), "theta0": lists, one number for the edge from each vertex to the next and for each
///   vertex;
/// * "rigid": true for a particle of many vertices that is rigid as it stands; it needs no a0, l0 and theta0;
/// * "v": velocities of the vertices;
/// * "k_a", "k_l", "k_b", "gamma" of a particle, where they differ from those of all; "k_perimeter" and "p0":
///   energy (k/2)(p/p0-1)^2 of its perimeter, or (k/2)(p-p0)^2 if absolute;
/// * "species": list of names in the file, and one of them in each particle, for keys "contact.A.B.k_c";
/// * "walls": those that stand where the cell is not periodic, of ["left", "right", "floor", "lid"]; all
///   unless given;
/// * "gravity": acceleration downward; "sticks": where vertices stick to the floor, or null;
/// * "case": laws by the keys of a case ({"contact.kind": "smooth"}), which hold unless the case gives them.
///
/// Packings of triangulated surfaces and spheres are in the same layout, where
///
///     {"k_v": 1, "k_a": 1, "k_b": 0.01, "k_c": 1, "box": [4, 4, 4],
///      "particles": [{"v0": 1, "a0": 0.05, "theta0": 0.3, "sigma": 0.3, "vertices": [[0.1, 0.2, 0.3], ...],
///                     "faces": [[0, 1, 2], ...]}, ...]}
///
/// has the energy (k_v/2)(v/v0-1)^2 + sum (k_a/2)((a-a0)/<a0>)^2 + sum (k_b/2)(theta-theta0)^2 of a particle:
/// its volume, its triangles, counter-clockwise as seen from outside, and its edges. "theta0" may be a list,
/// one for each of "edges": [[0, 1], ...]. A sphere has "sigma" and "x": [[0.1, 0.2, 0.3]]. Further keys:
///
/// * "stiffness": {"k_v": 1, "k_a": 1, "k_b": 0.01, "gamma": 0, "k_c": 1}: all of them, absolute;
/// * "contact": "rough", "smooth";
/// * "box": [[width, s, 0], [0, height, 0], [0, 0, depth]]: the columns are the periods, the strain s/height;
/// * "walls": "back", "front" too.
///
/// A surface alone may stand in the file itself, without "particles", "box" and "sigma". The points of the
/// first particle say which dimension a file is of; all else must be of the same.
///
/// Notes may stand in "name", "comment", "convention", "phi_reported" and "expected"; every other key is an
/// error. The whole layout with examples: docs/packing_json.md.
#pragma once
#include <string>
#include <variant>

#include "supple/contact/laws/harmonic.hpp"
#include "supple/core/new_file.hpp"
#include "supple/experiment/initial_state.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// Particles, the law of their contacts, and what else acts on them.
template <int Dim>
struct StoredPackingOf {
  System<Dim> system;
  Harmonic contact{1, true};
  HeldKeys keys;
  Environment environment;
};
using StoredPacking = StoredPackingOf<2>;
using AnyPacking = std::variant<StoredPackingOf<2>, StoredPackingOf<3>>;

/// A packing as a state to start from, and a state of deformable particles as a packing.
InitialState as_initial(AnyPacking packing);
AnyPacking as_packing(const InitialState& state);

/// Reads a packing. Throws a file error that names the file, the particle (counted from 0) and what is wrong.
AnyPacking read_any_packing_json(const std::string& path);
/// The same of a packing in this dimension. Input error where the file holds one in the other.
template <int Dim = 2>
StoredPackingOf<Dim> read_packing_json(const std::string& path);

/// Writes positions, velocities, shapes, stiffnesses, laws and the cell; positions and preferred shapes to
/// the last bit. Stiffnesses of polygons and rigid bodies to rounding; those of surfaces to the last bit:
/// relative where this says them exactly, and absolute otherwise. Throws an input error where the layout
/// cannot say what there is, such as links.
void write_packing_json(const AnyPacking& packing, const std::string& path,
                        Existing existing = Existing::refuse);

}  // namespace supple
