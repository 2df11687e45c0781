/// Moved to model/evaluation.hpp.
#pragma once
#include "supple/model/evaluation.hpp"
