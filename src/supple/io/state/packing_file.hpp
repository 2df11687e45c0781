/// Packings of polygons as JSON: what they prefer, where they are, and how stiff everything is.
///
///     {"k_a": 1, "k_l": 1, "k_b": 0.01, "k_c": 1, "box": 7.98,
///      "particles": [{"a0": 1.45, "sigma": 0.43, "l0": 0.43, "theta0": 0.63, "x": [[0.70, 1.85], ...]},
///      ...]}
///
/// Energies (k_a/2)(a/a0-1)^2 + (k_l/2)(l/l0-1)^2 + (k_b/2)(theta-theta0)^2 and contacts
/// (k_c/2)(1-r/sigma)^2, sigma the mean diameter of the two vertices; x the vertices, counter-clockwise and
/// unwrapped. Keys that may be there: "gamma", the energy gamma p/p0 of line tension; "stiffness" or
/// "contact_stiffness" "absolute" for (k_a/2)(a-a0)^2,
/// ... gamma p, or (k_c/2)(sigma-r)^2; "box" [width, height], "periodic" [true, false], "strain" of the cell;
/// "l0" and "theta0" as lists, one number for each edge from its vertex to the next and for each vertex. A
/// particle with one vertex is a disc and needs sigma and x alone; "rigid": true makes one of many vertices
/// rigid as it stands, and a0, l0 and theta0 may be left away. "v": velocities of the vertices. "walls":
/// those that stand where the cell is not periodic, of ["left", "right", "floor", "lid"], all unless given;
/// "gravity": acceleration downward; "sticks": where vertices stick to the floor, or null; "case": laws by
/// the keys of a case ({"contact.kind": "smooth"}), which hold unless the case gives them. Notes may stand in
/// "name", "comment", "convention", "phi_reported" and "expected"; every other key is an error. The whole
/// layout with examples: docs/packing_json.md.
#pragma once
#include <string>

#include "supple/contact/laws/harmonic.hpp"
#include "supple/core/new_file.hpp"
#include "supple/experiment/initial_state.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// Bodies, the law of their contacts, and what else acts on them.
struct StoredPacking {
  System<2> system;
  Harmonic contact{1, true};
  HeldKeys keys;
  Environment environment;
};
/// The same as a run starts from it, and of a state of deformable particles.
InitialState as_initial(StoredPacking packing);
StoredPacking as_packing(const InitialState& state);

/// Throws a file error that says where (the file, the number of the particle from 0) and what.
StoredPacking read_packing_json(const std::string& path);

/// Positions, velocities, shapes, stiffnesses, laws and the cell are kept; positions and preferred shapes to
/// the last bit, relative stiffnesses and rigid bodies to rounding. Input error where the layout cannot hold
/// the system: bodies of different stiffness.
void write_packing_json(const StoredPacking& packing, const std::string& path,
                        Existing existing = Existing::refuse);

}  // namespace supple
