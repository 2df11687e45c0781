/// Numbers that follow from a case.
#pragma once
#include <vector>

#include "supple/experiment/recorder.hpp"

namespace supple {

/// One of them, in SI, known before anything is run; it goes to the group "constants".
struct Derived {
  Column name;
  double value;
};

/// Constants of a disc law, the same names in both fidelities. Stiffness and viscosity in `units` [per metre
/// of depth].
struct LawConstants {
  double mean_mass, tau, friction;
  double k, k_t, eta, eta_t;                      ///< contacts
  double link_k, link_k_t, link_eta, link_eta_t;  ///< permanent links
};
std::vector<Derived> name_constants(const LawConstants& law, const Units& units);

}  // namespace supple
