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
  branches,  ///< the same of a compression and of the way back, with the lines that were fitted
  wall,      ///< force on the wall and contacts against strain
  motion     ///< energies against time, and the pressure or the reach of a heap
};
template <Figure figure>
Figure always(const Case&) {
  return figure;
}

/// An experiment on one kind of particles: a file, and a row of experiments(). Those of one name are the same
/// experiment on other particles.
struct Experiment {
  std::string name, meaning;
  const Matter* matter;
  UsedKeys keys;
  std::vector<Need> needs = {};  ///< of keys, besides those that every experiment has (used_keys.cpp)
  std::vector<Derived> (*derive)(const Case&, const InitialState*);
  void (*run)(const Case&, const InitialState*, Recorder&);
  Figure (*figure)(const Case&) = always<Figure::none>;
  std::set<std::string> first_keys;         ///< of a first case, shown set as everybody changes them
  void (*set_first)(Case&) = [](Case&) {};  ///< values of a first case that are not the defaults
  /// Values that follow from others unless they are given.
  void (*complete)(Case&) = [](Case&) {};
  /// What one key of its protocol cannot know of another.
  void (*check)(const Case&, Problems&) = [](const Case&, Problems&) {};
  void (*doubt)(const Case&, Doubts&) = [](const Case&, Doubts&) {};
  std::string_view next = {};  ///< the experiment that starts from what this one leaves: its keys do no harm
  bool keeps_step = false;     ///< goes on with the time step of the state that it starts from
};

const std::vector<Experiment>& experiments();
/// The names, each once.
std::vector<std::string> experiment_names();
/// The experiment of this name on these particles; null where there is none.
const Experiment* find_experiment(std::string_view name, const Matter& matter);
/// Of those with the name, that on the particles which the case asks for, or the first. Throws an input error
/// where there is none of the name.
const Experiment& experiment_of(const Case& c);

/// The same as check(c) for a case that starts from `initial`, or from what [initial] names.
void check(const Case& c, const InitialState* initial);

/// Derived numbers (time step, spring constant, frequency, steps, ...) of the case's experiment; `initial` is
/// the state that [initial] names, or null. Throws the input errors that run() would throw before its first
/// step.
std::vector<Derived> derive(const Case& c, const InitialState* initial);

/// Runs the case's experiment. Throws input errors before anything is computed; numerics errors and
/// `interrupted` after the recorder was given the state.
void run(const Case& c, const InitialState* initial, Recorder& recorder);

// The rows, each in the file of its name.
Experiment oscillatory_shear();
Experiment body_shear();
Experiment preparation();
Experiment dynamics();
Experiment body_dynamics();
Experiment jamming();
Experiment compression();
Experiment uniaxial_compression();
Experiment slump();

}  // namespace supple
