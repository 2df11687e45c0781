/// Numbers that follow from a case.
#pragma once
#include <vector>

#include "supple/experiment/recorder.hpp"

namespace supple {

/// One number that follows from a case before anything is run; a run records it in the group "constants".
struct Derived {
  Column name;
  double value;
};

/// Constants of a disc law, per metre of depth, in the `units` given to name_constants().
struct LawConstants {
  double mean_mass, tau, friction;
  double k, k_t, eta, eta_t;                      ///< contacts
  double link_k, link_k_t, link_eta, link_eta_t;  ///< permanent links
};
std::vector<Derived> name_constants(const LawConstants& law, const Units& units);

}  // namespace supple
