/// Sites as spheres for OVITO and everything else that reads extended XYZ.
#pragma once
#include <string>

#include "supple/core/new_file.hpp"
#include "supple/draw/scene/body_scene.hpp"

namespace supple {

/// A file of extended XYZ with one frame for each append(); it appears with commit().
///
/// * One line for each site: `type` (disc1, polygon2, ..., in 3D sphere1, surface2, ...: one type for bodies
/// of
///   equal radius and number of sites; a `species` would have to be a chemical symbol), `pos` (in 2D z = 0),
///   `radius`, `id` (site, 0-based), `molecule` (body, 0-based), then `of_sites`, then `of_bodies` of the
///   scene. Velocities are named `velo`; spins and torques in 2D are vectors along z. Numbers have as few
///   digits as read back to the same double.
/// * `Lattice` is the leaning cell that pictures draw, with the smallest of the strains that give the same
///   lattice (drawn_strain): nine numbers, vector after vector. `Origin` is its lower left corner, placed so
///   that it leans about mid-height. In 2D the third vector, not periodic, is as long as the thickest site.
///   `Time` is the time; the numbers of the whole system follow by name.
/// * Bodies stay whole, so some stick out of the cell; `placement` says which image is written. To fill the
///   cell instead, apply "Wrap at periodic boundaries" in OVITO.
class XyzFile {
 public:
  explicit XyzFile(const std::string& path, Existing existing = Existing::refuse,
                   Placement placement = Placement::in_cell);

  /// Adds a frame. Throws an input error where the arrays do not fit together, have one of the names above,
  /// or have a name of other characters than letters, digits and _; and file errors.
  template <int Dim>
  void append(const BodyScene<Dim>& scene);
  void commit();

 private:
  std::string path_;
  NewFile file_;
  Placement placement_;
};

}  // namespace supple
