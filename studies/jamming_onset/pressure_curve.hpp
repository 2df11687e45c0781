/// One packing of the study: where it jams, and its pressure from there upward.
#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "supple/core/error.hpp"
#include "supple/experiment/jam.hpp"
#include "supple/model/bodies.hpp"

namespace supple {

/// Which packing fraction counts: the sum of all areas, as is usual for discs, or what is covered.
enum class Area { sum, covered };

/// How a packing is made. search: that of `supple run`, to 1 < P/P_t < 1.01. steps: by jamming.step, and
/// back and by a quarter where P exceeds P_t, until a step below 1e-3 does; a packing that comes apart within
/// 0.01 of there is sought anew. Rough particles hold by their corners: many packings have no state of low
/// pressure, but break on the way down to it.
enum class Protocol { search, steps };

/// One packing from its onset upward.
struct PressureCurve {
  double first = 0;  ///< packing fraction at which it jammed for the first time
  double onset = 0;  ///< packing fraction from which it stayed jammed
  std::vector<double> phi, pressure;
  long unconverged = 0;
  std::string failure;

  /// Pressure at a packing fraction: 0 below the onset, straight between two measured points.
  double at(double x) const {
    const auto above = std::upper_bound(phi.begin(), phi.end(), x);
    if (above == phi.begin()) return 0;
    if (above == phi.end()) return NAN;
    const auto k = static_cast<std::size_t>(above - phi.begin());
    const double share = (x - phi[k - 1]) / (phi[k] - phi[k - 1]);
    return pressure[k - 1] + share * (pressure[k] - pressure[k - 1]);
  }
};

/// Makes a curve.
class Measurement {
 public:
  Measurement(Case c, int seed, Area area, Protocol protocol)
      : c_(std::move(c)), area_(area), protocol_(protocol) {
    c_.general.seed = seed;
  }

  /// To packing fractions of `highest` above the onset; 0: the onset alone.
  PressureCurve run(double highest) {
    try {
      Packing<2> packing = make_packing(c_, nullptr, c_.jamming.packing_fraction);
      protocol_ == Protocol::search ? start_by_search(packing) : start_by_steps(packing);
      curve_.first = curve_.onset;
      const std::vector<double> list = excesses(highest);
      for (std::size_t k = 0; k < list.size(); ++k) {
        const double excess = list[k];
        scale_to(packing, base_ + excess);
        curve_.unconverged += !relax(packing).converged;
        if (protocol_ == Protocol::steps && excess < 0.0101 &&
            observe(packing).pressure < c_.jamming.pressure) {
          start_by_steps(packing);
          k = SIZE_MAX;  // from the lowest again
        } else {
          add_point(packing);
        }
      }
    } catch (const Error& error) {
      curve_.failure = error.what();
    }
    return curve_;
  }

 private:
  /// Packing fractions above the onset, by steps that the packing follows.
  std::vector<double> excesses(double highest) const {
    std::vector<double> list;
    if (protocol_ == Protocol::search) {
      for (int k = 0; k < 5; ++k) list.push_back(1e-4 * std::pow(10, k / 4.0));
      for (double x = 2e-3; x < highest + 1e-6; x += 2e-3) list.push_back(x);
    } else {
      if (highest > 0.01) list = {2e-4, 4e-4, 7e-4};  // for the exponent
      list.insert(list.end(), {1e-3, 2e-3, 3.5e-3, 5e-3, 7.5e-3, 1e-2, 1.25e-2, 1.5e-2, 2e-2, 2.5e-2, 3e-2});
    }
    std::erase_if(list, [&](double x) { return x > highest + 1e-6; });
    return list;
  }

  void start_by_search(Packing<2>& packing) {
    curve_.unconverged = jam(packing, jam_spec(c_)).unconverged;
    start_curve(packing);
  }

  void start_by_steps(Packing<2>& packing) {
    const ForceTolerance exact = packing.tolerance;
    packing.tolerance.relative = std::max(exact.relative, 1e-3);
    System<2> low = packing.system;
    for (double step = base_ > 0 ? 1e-3 : c_.jamming.step; step > 2e-4;) {
      packing.system = low;
      scale_cell(packing.system, {std::exp(-0.5 * step), std::exp(-0.5 * step)});
      if (resists(packing)) step /= 4;
      else low = packing.system;
    }
    packing.tolerance = exact;
    packing.field->invalidate();
    curve_.unconverged += !relax(packing).converged;
    start_curve(packing);
  }

  /// Whether the packing has the pressure P_t. Of one that loses its energy no more is asked.
  bool resists(Packing<2>& packing) const {
    constexpr double modulus =
        0.2;  // dP/d(phi), roughly; a tenth of the energy of P_t has a third of its pressure
    const double p = c_.jamming.pressure;
    const double little = 0.1 * p * p / (2 * modulus) * packing.system.box.volume() * packing.pressure_unit;
    packing.field->invalidate();
    const MinimiseReport report = relax(packing, [&](const MinimiseReport& r) { return r.energy > little; });
    return report.energy > little && observe(packing).pressure > p;
  }

  void start_curve(Packing<2>& packing) {
    curve_.phi.clear();
    curve_.pressure.clear();
    base_ = observe(packing).packing_fraction;
    add_point(packing);
    curve_.onset = curve_.phi[0];
  }

  void add_point(Packing<2>& packing) {
    curve_.phi.push_back(area_ == Area::sum ? packing.covered_area / packing.system.box.volume()
                                            : covered_fraction(packing));
    curve_.pressure.push_back(observe(packing).pressure);
  }

  static void scale_to(Packing<2>& packing, double packing_fraction) {
    const double factor = std::sqrt(observe(packing).packing_fraction / packing_fraction);
    scale_cell(packing.system, {factor, factor});
    packing.field->invalidate();
  }

  Case c_;
  Area area_;
  Protocol protocol_;
  PressureCurve curve_;
  double base_ = 0;  ///< onset by the area that was covered at first
};

/// Curves in files, so that a study that was interrupted goes on.
class Store {
 public:
  enum class Missing { make, leave_out };
  /// Nothing is kept where there is no folder.
  Store(std::string folder, Missing missing) : folder_(std::move(folder)), missing_(missing) {
    if (!folder_.empty()) std::filesystem::create_directories(folder_);
  }
  PressureCurve get(const std::string& name, const Case& c, int seed, double highest, Area area,
                    Protocol protocol) const {
    const std::string path = fmt::format("{}/{}-{}.txt", folder_, name, seed);
    if (std::ifstream in(path); !folder_.empty() && in) return read(in);
    if (missing_ == Missing::leave_out)
      return {0, 0, {}, {}, 0, fmt::format("packing {} was not made", seed)};
    const PressureCurve curve = Measurement(c, seed, area, protocol).run(highest);
    if (folder_.empty() || !curve.failure.empty()) return curve;
    std::string text = fmt::format("{} {}\n", curve.unconverged, curve.first);
    for (std::size_t k = 0; k < curve.phi.size(); ++k)
      text += fmt::format("{} {}\n", curve.phi[k], curve.pressure[k]);
    std::ofstream(path) << text;
    return curve;
  }

 private:
  static PressureCurve read(std::istream& in) {
    PressureCurve curve;
    in >> curve.unconverged >> curve.first;
    for (double phi, pressure; in >> phi >> pressure;) {
      curve.phi.push_back(phi);
      curve.pressure.push_back(pressure);
    }
    curve.onset = curve.phi.at(0);
    return curve;
  }

  std::string folder_;
  Missing missing_;
};

}  // namespace supple
