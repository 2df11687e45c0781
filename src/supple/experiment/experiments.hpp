/// The experiments: what can be run, and how.
#pragma once
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "supple/experiment/case.hpp"
#include "supple/experiment/derived.hpp"
#include "supple/experiment/initial_state.hpp"
#include "supple/experiment/matter.hpp"
#include "supple/experiment/recorder.hpp"
#include "supple/experiment/used_keys.hpp"

namespace supple {

/// What the figure of a run shows.
enum class Figure {
  none,
  stress,    ///< strain and stress against time, and the loops where moduli were found
  search,    ///< pressure against packing fraction near the end of the search for the jammed state
  branches,  ///< the same along a compression and on the way back, with the fitted lines
  wall,      ///< force on the wall and contacts against strain
  plates,    ///< force of plates on a particle against their compression, on logarithmic axes
  motion,    ///< energies against time, and the pressure or the reach of a heap
  friction   ///< effective friction of two particles against their displacement, over pictures of them
};
template <Figure figure>
Figure always(const Case&) {
  return figure;
}

/// What is done in two dimensions and, where it can be, in three.
template <class Function>
struct ByDimension {
  Function* in_2d;
  Function* in_3d;
  ByDimension(Function* flat, Function* solid = nullptr) : in_2d(flat), in_3d(solid) {}
  Function* of(int dimensions) const { return dimensions == 2 ? in_2d : in_3d; }
};

/// An experiment on one kind of particles: a source file, and a row of experiments(). Rows of the same name
/// are the same experiment on other particles.
struct Experiment {
  std::string name, meaning;
  const Matter* matter;
  UsedKeys keys;
  std::vector<Need> needs = {};  ///< of its keys, besides the needs in every experiment (used_keys.cpp)
  ByDimension<std::vector<Derived>(const Case&, const InitialState*)> derive;
  ByDimension<void(const Case&, const InitialState*, Recorder&)> run;
  Figure (*figure)(const Case&) = always<Figure::none>;
  std::set<std::string> first_keys;         ///< keys that most users change: `supple init` sets them
  void (*set_first)(Case&) = [](Case&) {};  ///< values of `supple init` that are not the defaults
  /// Sets keys of a case that follow from others unless they are given.
  void (*complete)(Case&) = [](Case&) {};
  /// Adds problems and doubts about keys of the protocol that one key alone does not show.
  void (*check)(const Case&, Problems&) = [](const Case&, Problems&) {};
  void (*doubt)(const Case&, Doubts&) = [](const Case&, Doubts&) {};
  std::string_view next = {};  ///< the experiment that goes on from this one's state: its keys may be given
  bool keeps_step = false;     ///< goes on with the time step of the state that it starts from
};

/// All experiments (registry.cpp, which alone knows those outside of this folder).
const std::vector<Experiment>& experiments();
/// The names of the experiments, each once.
std::vector<std::string> experiment_names();
/// The values that the key `physics` may have.
std::vector<std::string> physics_names();
/// The experiment of this name on these particles; null where there is none.
const Experiment* find_experiment(std::string_view name, const Matter& matter);
/// The experiment that the case names, on the particles that the case asks for, or else the first of that
/// name. Throws an input error where there is none of that name.
const Experiment& experiment_of(const Case& c);

/// The dimensions in which its particles move: 2, or bodies.dim where its experiment uses that.
int dimensions_of(const Case& c);

/// The same as check(c), for a case that starts from `initial`; null: from what [initial] names, if anything.
void check(const Case& c, const InitialState* initial);

/// Derived numbers (time step, spring constant, frequency, steps, ...) of the case's experiment; `initial` is
/// the state that [initial] names, or null. Throws the input errors that run() would throw before its first
/// step.
std::vector<Derived> derive(const Case& c, const InitialState* initial);

/// Runs the case's experiment, on general.threads threads, the calling one among them. Throws input errors
/// before anything is computed; numerics errors and `interrupted` after the recorder was given the state.
void run(const Case& c, const InitialState* initial, Recorder& recorder);

// The rows of experiments(), each in the file of its name.
Experiment oscillatory_shear();
Experiment body_shear();
Experiment preparation();
Experiment dynamics();
Experiment body_dynamics();
Experiment jamming();
Experiment compression();
Experiment uniaxial_compression();
Experiment plate_compression();
Experiment slump();
Experiment friction();

}  // namespace supple
