/// Frames of runs as exports and pictures take them.
#pragma once
#include "supple/draw/scene/scene.hpp"
#include "supple/experiment/recorder.hpp"

namespace supple {

/// The bodies of a run at one instant, in the units of the run, with what the frame knows of them: velocity,
/// force and, for discs, angle, spin, torque and the crosslinked particle of each site; the numbers of each
/// body and of all.
template <int Dim>
BodyScene<Dim> body_scene_of(const RunInfo<Dim>& info, const Frame<Dim>& frame);

/// The same with contacts that bear a force. The caller must set boundary and walls, which frames do not
/// know.
Scene scene_of(const RunInfo<2>& info, const Frame<2>& frame);

/// The array of numbers of bodies with this name; null where there is none.
const std::vector<double>* numbers_of_bodies(const Scene& scene, const std::string& name);

/// Share of the cell that bodies cover, and the pressure in the cell. They follow from areas and pressures of
/// bodies that add up to those of the cell; not finite where the frame has none.
struct CellNumbers {
  double packing_fraction, pressure;
};
CellNumbers cell_numbers(const Scene& scene);

}  // namespace supple
