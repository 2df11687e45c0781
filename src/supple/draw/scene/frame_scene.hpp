/// Frames of runs as exports and pictures take them.
#pragma once
#include "supple/draw/scene/scene.hpp"
#include "supple/experiment/recorder.hpp"

namespace supple {

/// Bodies of the run at one instant, with what the frame knows of them: velocity, force, angle, spin, torque
/// and, for discs, the crosslinked particle of each site; the frame's numbers of each body; contacts that
/// bear a force. Lengths and all else in the run's units. Boundary and walls are the caller's: frames do not
/// tell them.
Scene scene_of(const RunInfo& info, const Frame& frame);

/// The numbers of bodies with this name; null where there are none.
const std::vector<double>* numbers_of_bodies(const Scene& scene, const std::string& name);

/// Share of the cell that the bodies cover, and the pressure in it, where the frame has what they follow
/// from: areas and pressures of bodies that add up to those of the cell; else not finite.
struct CellNumbers {
  double packing_fraction, pressure;
};
CellNumbers cell_numbers(const Scene& scene);

}  // namespace supple
