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
/// Notes may stand in "name", "comment", "convention", "phi_reported" and "expected"; every other key is an
/// error. The whole layout with examples: docs/packing_json.md.
#pragma once
#include <string>

#include "supple/contact/laws/harmonic.hpp"
#include "supple/core/new_file.hpp"
#include "supple/experiment/initial_state.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// Particles, the law of their contacts, and what else acts on them.
struct StoredPacking {
  System<2> system;
  Harmonic contact{1, true};
  HeldKeys keys;
  Environment environment;
};
/// A packing as a state to start from, and a state of deformable particles as a packing.
InitialState as_initial(StoredPacking packing);
StoredPacking as_packing(const InitialState& state);

/// Reads a packing. Throws a file error that names the file, the particle (counted from 0) and what is wrong.
StoredPacking read_packing_json(const std::string& path);

/// Writes positions, velocities, shapes, stiffnesses, laws and the cell; positions and preferred shapes to
/// the last bit, relative stiffnesses and rigid bodies to rounding. Throws an input error where the layout
/// cannot say what there is, such as links.
void write_packing_json(const StoredPacking& packing, const std::string& path,
                        Existing existing = Existing::refuse);

}  // namespace supple
