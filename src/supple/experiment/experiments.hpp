/// The experiments: what can be run, and how.
#pragma once
#include <string>
#include <vector>

#include "supple/experiment/case.hpp"
#include "supple/experiment/derived.hpp"
#include "supple/experiment/initial_state.hpp"
#include "supple/experiment/recorder.hpp"

namespace supple {

struct Experiment {
  std::string name, meaning;
  std::vector<Derived> (*derive)(const Case&, const InitialState*);
  void (*run)(const Case&, const InitialState*, Recorder&);
};

const std::vector<Experiment>& experiments();

/// Derived numbers (time step, spring constant, frequency, steps, ...) of the case's experiment; `initial` is the state
/// that [initial] names, or null. Throws the input errors that run() would throw before its first step.
std::vector<Derived> derive(const Case& c, const InitialState* initial);

/// Runs the case's experiment. Throws input errors before anything is computed; numerics errors and `interrupted` after
/// the recorder was given the state.
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
/// `dynamics` of deformable particles.
std::vector<Derived> derive_body_dynamics(const Case& c, const InitialState* initial);
void run_body_dynamics(const Case& c, const InitialState* initial, Recorder& recorder);

}  // namespace supple
