#include "supple/experiment/stress_table.hpp"

#include <string>
#include <string_view>
#include <utility>

#include "supple/model/body_flow.hpp"

namespace supple {

namespace {

using NamedTensor = std::pair<std::string_view, Mat2 StressTensors::*>;

/// Tensors by the names of files; Table S2-3, and the two that do not depend on where the cell is cut.
constexpr NamedTensor tensor_columns[] = {
    {"love_weber", &StressTensors::love_weber},
    {"external", &StressTensors::external},
    {"linear_acceleration", &StressTensors::linear_acceleration},
    {"otsuki", &StressTensors::otsuki},
    {"tangential_torque", &StressTensors::tangential_torque},
    {"internal_torque", &StressTensors::internal_torque},
    {"centrifugal", &StressTensors::centrifugal},
    {"overall", &StressTensors::overall},
    {"love_weber_periodic", &StressTensors::love_weber_periodic},
    {"virial", &StressTensors::virial},
};

std::vector<Column> columns(bool tensors, bool plates) {
  std::vector<Column> out{
      {"t", "s", "time since the start of the protocol"},
      {"strain", "", "accumulated shear strain"},
      {"strain_rate", "1/s", "shear rate"},
      {"shear_stress_external", "Pa", "tau from external forces (S1-16, S1-25)"},
      {"shear_stress_internal", "Pa", "tau from the overall tensor (S1-24, S1-25)"},
      {"shear_stress_external_corrected", "Pa", "tau from external forces, without the jumps of the cut"},
      {"shear_stress_periodic", "Pa", "tau from Love-Weber with contacts across x internal"},
      {"shear_stress_virial", "Pa", "tau from the virial of all contacts"},
      {"pair_register", "", "elementary internal forces, as the published package counts them"},
      {"external_register", "", "elementary external forces, as the published package counts them"},
  };
  if (plates)
    out.push_back(
        {"shear_stress_plates", "Pa", "tau from the force of the plates over the width of the cell"});
  if (!tensors) return out;
  for (const auto& [name, tensor] : tensor_columns)
    for (const char* component : {"_00", "_01", "_10", "_11"})
      out.push_back(
          {std::string(name) + component, "Pa", "component of the stress tensor, compression positive"});
  return out;
}

constexpr auto removed_stress = "removed_stress";

double removed_before(const InitialState* initial) {
  if (!initial) return 0;
  const auto at = initial->protocol.find(removed_stress);
  return at == initial->protocol.end() ? 0 : at->second;
}

}  // namespace

StressTable::StressTable(Recorder& recorder, const Units& units, bool tensors, const System<2>& system,
                         const InitialState* initial)
    : recorder_(recorder),
      units_(units),
      tensors_(tensors),
      has_plates_(supple::has_plates(system.state)),
      jumps_(removed_before(initial)) {
  recorder_.declare("stress", columns(tensors, has_plates_));
}

void StressTable::append(const System<2>& system, const Evaluation<2>& evaluation, double strain_rate) {
  const StressTensors s = stress_tensors(system, evaluation, units_.stress());
  const double corrected = jumps_.corrected(system, evaluation, s, units_.stress());
  const double t = system.time * units_.time;
  row_ = {t,
          system.box.strain,
          strain_rate / units_.time,
          s.shear_external(),
          s.shear_internal(),
          corrected,
          s.shear_periodic(),
          s.shear_virial(),
          static_cast<double>(s.pair_register),
          static_cast<double>(s.external_register)};
  if (has_plates_) row_.push_back(s.plates);
  if (tensors_)
    for (const auto& [name, tensor] : tensor_columns) {
      const Mat2& m = s.*tensor;
      row_.insert(row_.end(), {m[0][0], m[0][1], m[1][0], m[1][1]});
    }
  recorder_.append("stress", row_);
  pressure_sum_ += s.pressure();
  ++rows_;
}

void StressTable::finish(const System<2>& system, const Evaluation<2>& evaluation) {
  jumps_.corrected(system, evaluation, stress_tensors(system, evaluation, units_.stress()), units_.stress());
  recorder_.value(protocol_group,
                  {removed_stress, "Pa", "jumps of the cut that were taken from the external stress so far"},
                  jumps_.removed());
  recorder_.final_state(FinalState<2>{system, evaluation});
}

}  // namespace supple
