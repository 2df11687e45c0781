/// The experiments: what can be run, and how.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "supple/experiment/case.hpp"
#include "supple/experiment/derived.hpp"
#include "supple/experiment/initial_state.hpp"
#include "supple/experiment/recorder.hpp"

namespace supple {

/// "section.*", "section.key", and "-section.key" to take one out again.
using UsedKeys = std::vector<std::string_view>;

struct Experiment {
  std::string name, meaning;
  UsedKeys discs,
      bodies;  ///< keys it uses of microgel discs, and of deformable particles; empty: not about these
  std::vector<Derived> (*derive)(const Case&, const InitialState*);
  void (*run)(const Case&, const InitialState*, Recorder&);
  std::string_view next =
      {};  ///< the experiment that starts from what this one leaves: its keys do no harm here
};

const std::vector<Experiment>& experiments();
/// Throws an input error where the case names none of them.
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

std::vector<Derived> derive_oscillatory_shear(const Case& c, const InitialState* initial);
void run_oscillatory_shear(const Case& c, const InitialState* initial, Recorder& recorder);
std::vector<Derived> derive_preparation(const Case& c, const InitialState* initial);
void run_preparation(const Case& c, const InitialState* initial, Recorder& recorder);
std::vector<Derived> derive_dynamics(const Case& c, const InitialState* initial);
void run_dynamics(const Case& c, const InitialState* initial, Recorder& recorder);
std::vector<Derived> derive_jamming(const Case& c, const InitialState* initial);
void run_jamming(const Case& c, const InitialState* initial, Recorder& recorder);
std::vector<Derived> derive_compression(const Case& c, const InitialState* initial);
void run_compression(const Case& c, const InitialState* initial, Recorder& recorder);
std::vector<Derived> derive_uniaxial_compression(const Case& c, const InitialState* initial);
void run_uniaxial_compression(const Case& c, const InitialState* initial, Recorder& recorder);
std::vector<Derived> derive_slump(const Case& c, const InitialState* initial);
void run_slump(const Case& c, const InitialState* initial, Recorder& recorder);
/// `oscillatory_shear` of deformable particles.
std::vector<Derived> derive_body_shear(const Case& c, const InitialState* initial);
void run_body_shear(const Case& c, const InitialState* initial, Recorder& recorder);
/// `dynamics` of deformable particles; the second pair with a shear rate.
std::vector<Derived> derive_body_dynamics(const Case& c, const InitialState* initial);
void run_body_dynamics(const Case& c, const InitialState* initial, Recorder& recorder);
std::vector<Derived> derive_sheared_dynamics(const Case& c, const InitialState* initial);
void run_sheared_dynamics(const Case& c, const InitialState* initial, Recorder& recorder);

}  // namespace supple
