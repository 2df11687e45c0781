#include <cmath>

#include "supple/core/expression.hpp"
#include "supple/experiment/body_rheology.hpp"
#include "supple/experiment/sheared_bodies.hpp"
#include "supple/experiment/suspension.hpp"

namespace supple {

namespace {

std::vector<Derived> derived_dynamics(const Case& c, Packing<2>& packing, const BodyLaws& laws) {
  std::vector<Derived> all = derived_packing(packing);
  for (Derived& d : derived_laws(laws)) all.push_back(std::move(d));
  all.push_back({{"time_step", "", "time step"}, sheared_body_step(c, laws, packing)});
  all.push_back({{"steps", "", "steps"}, static_cast<double>(c.time.steps)});
  return all;
}

}  // namespace

std::vector<Derived> derive_sheared_dynamics(const Case& c, const InitialState* initial) {
  Packing<2> packing = make_packing(c, initial, c.jamming.packing_fraction, sheared(set_apart));
  const Expression rate(c.shear.rate, {"t"}, "[shear] rate");
  plates_of_bodies(c);
  return derived_dynamics(c, packing, body_laws(c, packing));
}

void run_sheared_dynamics(const Case& c, const InitialState* initial, Recorder& recorder) {
  Packing<2> packing = make_packing(c, initial, c.jamming.packing_fraction, sheared(at_random(recorder)));
  restore_sheared(packing, recorder);
  const Expression rate(c.shear.rate, {"t"}, "[shear] rate");
  const BodyLaws laws = body_laws(c, packing);
  double dt = sheared_body_step(c, laws, packing);
  start_clock(packing.system, c, recorder);
  double begin = packing.system.time;
  const Keep more = [&](Keeper& k) {
    k("dt", dt);
    k("begin", begin);
  };
  restore(recorder, more, sheared_part);
  add_rheology(laws, packing);
  begin_packing(packing, derived_dynamics(c, packing, laws), recorder);
  link_packing(c, packing, recorder);
  ShearedBodies bodies(c, initial, packing, recorder);
  bodies.move({"dynamics", c.time.steps, c.time.steps + 1, c.output.frames, dt,
               std::pow(c.shear.cool_factor, dt * c.shear.relative_frequency / laws.tau),
               [&](std::int64_t step, double) {
                 const double t = begin + static_cast<double>(step) * dt;
                 return ShearRates{rate(t), step < c.time.steps ? rate(t + 0.5 * dt) : rate(t)};
               }},
              more);
  bodies.finish();
}

}  // namespace supple
