/// A small made-up run of three bodies, for tests of pictures and exports.
#pragma once
#include <cmath>
#include <string>
#include <vector>

#include "supple/io/run/file_recorder.hpp"
#include "supple/io/run/run_file.hpp"

namespace supple::testing {

/// A square, a disc and a triangle that touches both.
inline RunInfo<2> body_info() {
  RunInfo<2> info;
  info.units = reduced_units();
  info.box.length = {10, 10};
  info.body_begin = {0, 4, 5, 8};
  info.radius = {0.4, 0.4, 0.4, 0.4, 0.9, 0.4, 0.4, 0.4};
  info.mass.assign(8, 1);
  info.inertia.assign(8, 0);
  info.particle.assign(8, 0);
  return info;
}

/// Frame k: everything is k/10 further to the right, in a cell lower by k/4.
inline Frame<2> body_frame(int k) {
  Frame<2> frame;
  frame.step = k;
  frame.time = 0.25 * k;
  frame.length = {10, 10 - 0.25 * k};
  for (const Vec2& x : {Vec2{3, 3}, Vec2{5, 3}, Vec2{5, 5}, Vec2{3, 5}, Vec2{8, 4}, Vec2{5.7, 3},
                        Vec2{6.8, 4}, Vec2{5.7, 5}}) {
    frame.position.push_back(x + Vec2{0.1 * k, 0});
    frame.velocity.push_back({0.4, 0.1 * k});
    frame.force.push_back({0.01, 0.02 * k});
  }
  frame.angle.assign(8, 0);
  frame.spin.assign(8, 0);
  frame.torque.assign(8, 0);
  frame.mobility.assign(8, Mobility::free);
  frame.contacts = {{1, 5, ContactState::stick, 0, 0, 0.2, 0}, {4, 6, ContactState::stick, 0, 0, 0.3, 0.4}};
  frame.body["area"] = {10, 5, 5};
  frame.body["pressure"] = {1e-3 * k, 2e-3, 3e-3};
  frame.body["contacts"] = {1, 1, 2};
  return frame;
}

/// Starts a run of `experiment` at `path` with `frames` frames; tables and finish() are the caller's.
inline void record_bodies(FileRecorder& recorder, int frames) {
  recorder.begin(body_info());
  for (int k = 0; k < frames; ++k) recorder.frame(body_frame(k));
}

inline Case body_case(const std::string& experiment) {
  Case c;
  c.general.experiment = experiment;
  c.general.physics = "deformable";
  c.time.steps = 2;
  return c;
}

}  // namespace supple::testing
