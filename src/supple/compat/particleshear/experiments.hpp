/// Rows of the registry: the experiments on discs as the published package particleShear 1.0.2 computes them.
#pragma once
#include "supple/experiment/experiments.hpp"

namespace supple::particleshear {

Experiment oscillatory_shear();
Experiment preparation();
Experiment dynamics();

}  // namespace supple::particleshear
