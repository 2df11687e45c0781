/// What Supple can run.
#include "supple/compat/particleshear/experiments.hpp"
#include "supple/experiment/experiments.hpp"

namespace supple {

const std::vector<Experiment>& experiments() {
  static const std::vector<Experiment> all{oscillatory_shear(),
                                           particleshear::oscillatory_shear(),
                                           body_shear(),
                                           preparation(),
                                           particleshear::preparation(),
                                           dynamics(),
                                           particleshear::dynamics(),
                                           body_dynamics(),
                                           jamming(),
                                           compression(),
                                           uniaxial_compression(),
                                           plate_compression(),
                                           slump(),
                                           friction()};
  return all;
}

}  // namespace supple
