/// Sites as spheres for OVITO and everything else that reads extended XYZ.
#pragma once
#include <string>

#include "supple/core/new_file.hpp"
#include "supple/draw/scene/scene.hpp"

namespace supple {

/// One file of extended XYZ with one frame for each append(); it has its name after commit().
///
/// * One line for each site: `type` (disc or polygon, numbered by size in the order of the bodies: disc1,
/// polygon2; a
///   `species` would have to be a chemical symbol), `pos` (z = 0), `radius`, `id` (site, 0-based), `molecule`
///   (body, 0-based), then `of_sites`, then `of_bodies`; velocities are named `velo`, spins and torques are
///   vectors along z. Numbers in as few digits as read back to the same double.
/// * `Lattice` is the leaning cell that pictures draw: its strain wrapped to the nearest of equal lattices
///   (drawn_strain), `Origin` at its lower left, so that it leans about mid-height. Its third vector, not
///   periodic, is as long as the thickest site; `Time` is the time; numbers of the whole follow by name.
/// * Bodies stay whole, so some stick out of the cell: `placement` says which image. To fill the cell
/// instead, apply
///   "Wrap at periodic boundaries" in OVITO.
class XyzFile {
 public:
  explicit XyzFile(const std::string& path, Existing existing = Existing::refuse,
                   Placement placement = Placement::in_cell);

  /// Throws an input error where the arrays do not fit together, take one of the names above or a name is not
  /// of letters, digits and _, and file errors.
  void append(const Scene& scene);
  void commit();

 private:
  std::string path_;
  NewFile file_;
  Placement placement_;
};

}  // namespace supple
