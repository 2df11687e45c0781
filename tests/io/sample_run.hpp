/// A small made-up run whose every number is different, for tests of files.
#pragma once
#include <cmath>
#include <string>
#include <vector>

#include "supple/experiment/recorder.hpp"

namespace supple::testing {

inline RunInfo<2> sample_info(int discs) {
  RunInfo<2> info;
  info.units = particleshear_units();
  info.box.length = {500, 400};
  info.box.periodic = {true, false};
  info.box.strain = 0.1;
  for (int i = 0; i < discs; ++i) {
    info.radius.push_back(20 + i / 3.);
    info.mass.push_back(1 + i / 7.);
    info.inertia.push_back(200 + i / 9.);
    info.particle.push_back(i % 3);
  }
  info.body_begin = {0, 2, discs};
  return info;
}

inline Frame<2> sample_frame(int discs, int k) {
  Frame<2> frame;
  frame.step = 10 * k;
  frame.time = 0.1 * k;
  frame.strain = std::sin(k);
  frame.strain_rate = std::cos(k);
  for (int i = 0; i < discs; ++i) {
    const double x = i + 100. * k;
    frame.position.push_back({x / 3, x / 7});
    frame.velocity.push_back({x / 11, -x / 13});
    frame.force.push_back({x / 17, x / 19});
    frame.angle.push_back(x / 23);
    frame.spin.push_back(x / 29);
    frame.torque.push_back(x / 31);
    frame.mobility.push_back(static_cast<Mobility>((i + k) % 4));
  }
  frame.length = {500. - k, 400 - k / 3.};
  frame.body["pressure"] = {k / 37., -k / 41.};
  frame.body["zeal"] = {k / 43., k / 47.};
  frame.numbers["kinetic_energy"] = k / 53.;
  frame.numbers["pressure"] = -k / 59.;
  for (int c = 0; c < k % 4; ++c)
    frame.contacts.push_back({c,
                              c + 1,
                              static_cast<ContactState>(1 + c % 3),
                              k / 3.,
                              k / 7.,
                              c / 3.,
                              c / 7. + k,
                              c / 11. + k,
                              c / 13. - k,
                              {c / 17. + k, c / 19. - k}});
  return frame;
}

inline System<2> sample_system(int discs) {
  System<2> system;
  system.box.length = {500, 400};
  system.box.periodic = {true, false};
  system.box.strain = 1.1;
  system.box.strain_rate = 1 / 3.;
  system.time = 0.1 + 0.2;
  system.lag = 1 / 3.;
  system.step = (std::int64_t{1} << 40) + 1;
  system.state.resize(discs);
  for (int i = 0; i < discs; ++i) {
    const auto s = static_cast<std::size_t>(i);
    system.state.position[s] = {i / 3., -i / 7.};
    system.state.velocity[s] = {-0.0, i * 1e-310};
    system.state.mass[s] = 1 + i / 11.;
    system.state.radius[s] = 2 + i / 13.;
    system.state.angle[s] = std::sqrt(i);
    system.state.spin[s] = std::cbrt(i);
    system.state.inertia[s] = 3 + i / 17.;
    system.state.mobility[s] = static_cast<Mobility>(i % 4);
  }
  for (int i = 0; i < discs; ++i) {
    system.acceleration.site.push_back({i / 31., -i / 37.});
    system.acceleration.spin.push_back(std::cbrt(i) / 3);
  }
  system.topology.begin = {0, 2, discs};
  system.topology.facet_begin = {0, 2, 2};
  system.topology.hinge_begin = {0, 0, 1};
  system.topology.facet = {{0, 1}, {1, 0}};
  system.topology.hinge = {{2, 3, 4}};
  system.shape.stiffness = {{1 / 3., 2 / 3., 1 / 7., 2 / 7.}, {1e-310, -0.0, 5, 6}};
  system.shape.rest_volume = {3 / 7., 4 / 7.};
  system.shape.rest_facet = {5 / 7., 6 / 7.};
  system.shape.rest_hinge = {-1 / 7.};
  for (int i = 0; i < discs; ++i) system.floor_contact.push_back(i % 2 ? i / 29. : std::nan(""));
  PairTable& pairs = system.pairs;
  pairs.width = 2;
  pairs.begin.push_back(0);
  for (int i = 0; i + 1 < discs; ++i) {
    pairs.first.push_back(i);
    pairs.second.push_back(i + 1);
    pairs.state.push_back(static_cast<ContactState>(1 + i % 3));
    pairs.history.insert(pairs.history.end(), {i / 19., -i / 23.});
    pairs.begin.push_back(i + 1);
  }
  pairs.begin.push_back(pairs.size());
  return system;
}

inline Evaluation<2> sample_evaluation(int discs) {
  Evaluation<2> evaluation;
  for (int i = 0; i < discs; ++i) {
    evaluation.force.push_back({i / 3., i / 5.});
    evaluation.torque.push_back(i / 7.);
  }
  evaluation.energy.terms = 1 / 5.;
  evaluation.energy.elastic = 1 / 3.;
  evaluation.energy.tangential = 1 / 17.;
  evaluation.energy.wall = 1 / 11.;
  evaluation.energy.external = -1 / 13.;
  evaluation.energy.viscous_power = 1 / 19.;
  evaluation.energy.tangential_viscous_power = 1 / 23.;
  evaluation.energy.sliding_power = 1 / 7.;
  evaluation.virial = {{{1, 2}, {3, 4}}};
  return evaluation;
}

/// Hands the recorder a preparation, `steps` rows of stress with a frame each, some numbers and the final
/// state.
inline void record_sample(Recorder& recorder, int discs, int steps) {
  recorder.begin(sample_info(discs));
  recorder.declare("stress",
                   {{"t", "s", "time"}, {"zeta", "Pa", "later in the alphabet"}, {"alpha", "Pa", ""}});
  recorder.declare("empty", {{"t", "s", "time"}});
  recorder.value("constants", {"tau", "s", "characteristic time"}, 1e-5);
  for (int k = 0; k < steps; ++k) {
    recorder.append("stress", std::vector<double>{0.1 * k, k / 3., k / 7.});
    recorder.frame(sample_frame(discs, k));
    recorder.value("results", {"steps", "", "last step"}, k);
    if (k == 1) recorder.warning("the first warning");
  }
  recorder.value("results", {"storage_modulus", "Pa", "G'"}, 565, 17);
  recorder.warning("the last warning");
  recorder.final_state(FinalState<2>{sample_system(discs), sample_evaluation(discs)});
}

}  // namespace supple::testing
