/// Runs of two particles of which one slides over the other, for tests.
#pragma once
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "supple/core/error.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/io/text/case_file.hpp"

namespace supple::testing_pairs {

/// The elastic shells of the chapter: k_l/k_c = 100, k_b/(k_c sigma^2) = 171, k_a a0^2/(k_c sigma^2) = 14.
/// With relative stiffness k_c sigma^2 is 1 and k_l of the case is k_l l0^2, so 100 (l0/sigma)^2 there.
inline const std::string shells =
    "experiment = \"friction\"\n[bodies]\nvertices = 8\nk_l = 100\nk_b = 171\nk_a = 14\n";
/// C = R/sigma = 0.71, R = l0/(2 sin(pi/8)).
inline const double wide = 1 / (2 * std::sin(std::numbers::pi / 8)) / 0.71;

inline Case case_of(const std::string& text, const std::vector<std::string>& more = {}) {
  Case c = read_case_text(text, "case.toml", more);
  resolve_family(c);
  experiment_of(c).complete(c);
  check(c);
  return c;
}

inline std::vector<std::string> wider(std::vector<std::string> more) {
  more.push_back("bodies.diameter_ratio=" + std::to_string(wide));
  more.push_back("bodies.k_l=" + std::to_string(100 / (wide * wide)));
  return more;
}

inline MemoryRecorder slide(const Case& c) {
  MemoryRecorder recorder;
  run(c, nullptr, recorder);
  return recorder;
}
inline MemoryRecorder slide_shells(const std::vector<std::string>& more) {
  return slide(case_of(shells, more));
}

inline std::string error_of(const Case& c, MemoryRecorder& recorder) {
  try {
    run(c, nullptr, recorder);
  } catch (const Error& e) {
    return e.what();
  }
  return "";
}
inline std::string refusal(const std::vector<std::string>& more, const std::string& text = shells) {
  try {
    case_of(text, more);
  } catch (const Error& e) {
    return e.what();
  }
  return "";
}

inline double maximum(const MemoryRecorder& r) { return r.get("results", "friction_max"); }

}  // namespace supple::testing_pairs
