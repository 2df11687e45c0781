/// A small run in three dimensions, for tests of exports.
#pragma once
#include <string>
#include <vector>

#include "supple/experiment/frame.hpp"
#include "supple/io/run/file_recorder.hpp"
#include "supple/io/run/run_file.hpp"
#include "tests/support/moving_surfaces.hpp"
#include "tests/support/random_surfaces.hpp"

namespace supple::testing {

/// A surface, a sphere that touches it, and a surface two cells down that touches the first across the
/// boundary, in a sheared periodic cell.
inline System<3> surfaces_and_sphere() {
  System<3> system;
  system.box.length = {4.2, 3.1, 3.3};
  system.box.strain = 0.9;
  RandomStream draw(3, Purpose::test);
  const ShapeSpec shape{.area = 1, .length = 1, .bending = 0.1};
  const Vec3 middle{1, 1.0 / 3, 1.2};
  add_shaken(system, geodesic_icosahedron(12), middle, shape, 0.04, draw);
  add_sphere_body(system, middle + Vec3{1.4, 0.2, 0.1}, 0.55);
  add_shaken(system, geodesic_icosahedron(42),
             middle + Vec3{0.1, 1.5, 0} + system.box.lattice().vector({1, -2, 1}), shape, 0.04, draw);
  heat(system, 0.3);
  return system;
}

/// The frame of the system with its forces, and numbers of bodies and of all that have no short decimals.
inline Frame<3> frame_of(System<3>& system) {
  ForceField<3> field = rough_surfaces();
  Evaluation<3> evaluation;
  field.evaluate(system, Detail::energies, evaluation);
  Frame<3> frame = make_frame(system, evaluation, field.bodies()->records(system), field.bodies()->laws());
  for (const char* name :
       {"pressure", "volume", "shape_parameter", "contacts", "rattler", "stress_xx", "stress_xz"}) {
    const double seed = static_cast<double>(std::string(name).size());
    frame.body[name] = {seed / 3, -seed / 7, seed / 11 + 1e-9 * system.time};
  }
  frame.numbers = {{"pressure", 1.0 / 7 + system.time}, {"packing_fraction", 0.3}};
  return frame;
}

/// Writes a run of two frames: the second is later, further sheared and in a lower cell.
inline RunFile record_surfaces(const std::string& path, const std::string& experiment = "jamming") {
  Case c;
  c.general.experiment = experiment;
  c.general.physics = "deformable";
  c.bodies.dimensions = 3;
  FileRecorder recorder(path, c, "", Existing::replace);
  System<3> system = surfaces_and_sphere();
  recorder.begin(make_run_info(system, reduced_units()));
  recorder.frame(frame_of(system));
  system.time = 0.25;
  system.step = 5;
  system.box.strain = 1;
  system.box.length[gradient] = 3;
  for (Vec3& x : system.state.position) x += Vec3{1.0 / 7, 1.0 / 9, -1.0 / 11};
  recorder.frame(frame_of(system));
  recorder.finish("complete");
  return RunFile(path);
}

}  // namespace supple::testing
