#include "supple/experiment/energy_table.hpp"

#include <cmath>
#include <string>
#include <string_view>

#include "supple/observe/summary.hpp"

namespace supple {

namespace {

struct FlowColumn {
  const char* name;
  double EnergyFlows::*flow;
  const char* meaning;
};

constexpr FlowColumn flow_columns[] = {
    {"work_plates", &EnergyFlows::plates, "done by plates, less what discs lose when a plate takes them"},
    {"work_images", &EnergyFlows::images, "done across the sheared boundary by contacts, discs that cross"},
    {"work_shear_rate", &EnergyFlows::shear_rate, "done by changes of the shear rate on velocities"},
    {"lost_viscous", &EnergyFlows::viscous, "lost in central dashpots"},
    {"lost_tangential", &EnergyFlows::tangential_viscous, "lost in tangential dashpots"},
    {"lost_sliding", &EnergyFlows::sliding, "lost by friction, and in springs of contacts that open"},
    {"lost_background", &EnergyFlows::background, "lost by damping relative to the flow, less its work"},
};

constexpr auto account_opening = "account_opening";

std::string kept_name(const FlowColumn& column) { return std::string("account_") + column.name; }

std::vector<Column> columns(bool of_bodies) {
  const char *unit = of_bodies ? "" : "J/m", *time = of_bodies ? "" : "s";
  std::vector<Column> out{{"t", time, "time since the start of the protocol"},
                          {"kinetic", unit, "of the velocities of free discs and vertices"},
                          {"spin", unit, "of all spins"},
                          {"elastic", unit, "stored in contacts and links"},
                          {"tangential", unit, "stored in tangential springs"},
                          {"wall", unit, "stored in repulsive plates"}};
  if (of_bodies) out.push_back({"shape", unit, "stored in shapes"});
  out.push_back({"total", unit, "sum of these"});
  for (const FlowColumn& c : flow_columns)
    out.push_back({c.name, unit, std::string(c.meaning) + ", since the first row"});
  out.push_back({"residual", unit, "change of total - work + lost, since the first row: error of the step"});
  return out;
}

}  // namespace

std::vector<std::string> account_numbers() {
  std::vector<std::string> names{account_opening};
  for (const FlowColumn& c : flow_columns) names.push_back(kept_name(c));
  return names;
}

EnergyTable::EnergyTable(Recorder& recorder, Stepper<2>& stepper, const System<2>& system, const Units& units,
                         const Case& c, const InitialState* initial)
    : recorder_(recorder),
      time_(units.time),
      energy_(units.torque()),
      has_shapes_(!system.topology.begin.empty()) {
  recorder_.declare("energy", columns(has_shapes_));
  stepper.set_account(&account_);
  if (!initial || !c.initial.keep_time || !initial->protocol.contains(account_opening)) return;
  const auto kept = [&](const std::string& name) {
    const auto at = initial->protocol.find(name);
    return at == initial->protocol.end() ? 0 : at->second / energy_;
  };
  EnergyFlows flows;
  for (const FlowColumn& column : flow_columns) flows.*column.flow = kept(kept_name(column));
  account_.resume(system, kept(account_opening), flows);
  is_open_ = true;
}

void EnergyTable::append(const System<2>& system, const Evaluation<2>& evaluation) {
  if (!is_open_) account_.open(system, evaluation);
  is_open_ = true;
  const KineticEnergy kinetic = kinetic_energy(system, evaluation);
  const EnergyState e = energy_state(system, evaluation);
  const EnergyFlows flows = account_.flows(system, evaluation);
  std::vector<double> row{kinetic.translation, kinetic.spin, e.elastic, e.tangential, e.wall};
  if (has_shapes_) row.push_back(e.terms);
  row.push_back(e.total());
  for (const FlowColumn& c : flow_columns) row.push_back(flows.*c.flow);
  row.push_back(account_.residual(system, evaluation));
  for (double& x : row) x *= energy_;
  row.insert(row.begin(), time_ * system.time);
  recorder_.append("energy", row);
}

std::vector<double> EnergyTable::lost() const {
  std::vector<double> sum;
  for (const FlowColumn& c : flow_columns) {
    if (!std::string_view(c.name).starts_with("lost_")) continue;
    const std::vector<double> part = recorder_.column("energy", c.name);
    sum.resize(part.size());
    for (std::size_t k = 0; k < part.size(); ++k) sum[k] += part[k];
  }
  return sum;
}

void EnergyTable::finish() {
  const auto keep = [&](const std::string& name, double value) {
    recorder_.value(protocol_group, {name, "J/m", "of the account of energy, for a continuation"},
                    energy_ * value);
  };
  keep(account_opening, account_.energy_at_opening());
  for (const FlowColumn& c : flow_columns) keep(kept_name(c), account_.booked().*c.flow);
}

double EnergyTable::relative_residual(const System<2>& system, const Evaluation<2>& evaluation) const {
  const double lost = account_.flows(system, evaluation).lost();
  return lost > 0 ? std::abs(account_.residual(system, evaluation)) / lost : 0;
}

}  // namespace supple
