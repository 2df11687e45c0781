#include "supple/experiment/body_stress_table.hpp"

#include <string>

#include "supple/model/body_flow.hpp"
#include "supple/model/rigid.hpp"
#include "supple/observe/body_stress.hpp"
#include "supple/observe/energy_balance.hpp"
#include "supple/observe/summary.hpp"

namespace supple {

BodyStressTable::BodyStressTable(const Packing<2>& packing, bool tensors, Recorder& recorder)
    : packing_(packing),
      tensors_(tensors),
      has_plates_(supple::has_plates(packing.system.state)),
      recorder_(recorder) {
  const std::string& unit = packing.pressure_symbol;
  std::vector<Column> columns{
      {"t", "", "time since the start of the protocol"},
      {"strain", "", "accumulated shear strain"},
      {"strain_rate", "", "shear rate"},
      {"shear_stress_virial", unit, "tau from the virial of shapes, contacts and links"},
      {"shear_stress_total", unit, "the same with the kinetic part, of velocities relative to the flow"},
      {"pressure", unit, "(xx + yy)/2 of that virial"}};
  if (has_plates_)
    columns.push_back({"shear_stress_plates", unit,
                       "tau from forces of plates, and of images beyond them, over the width of the cell"});
  if (tensors)
    for (const char* component : {"_00", "_01", "_10", "_11"})
      columns.push_back({std::string("virial") + component, unit, "component of the virial stress"});
  recorder.declare("stress", columns);
}

void BodyStressTable::append(const Evaluation<2>& evaluation, double strain_rate) {
  const System<2>& s = packing_.system;
  const Mat2 stress = (1 / (s.box.volume() * packing_.pressure_unit)) * evaluation.virial;
  const double kinetic = kinetic_moment(evaluation) / (s.box.volume() * packing_.pressure_unit);
  std::vector<double> row{
      s.time,          s.box.strain, strain_rate, shear_stress(stress), shear_stress(stress) - kinetic,
      pressure(stress)};
  if (has_plates_)
    row.push_back((plate_moment(s, evaluation) + image_moment(s, evaluation)) /
                  (s.box.volume() * packing_.pressure_unit));
  if (tensors_) row.insert(row.end(), {stress[0][0], stress[0][1], stress[1][0], stress[1][1]});
  recorder_.append("stress", row);
}

double BodyStressTable::kinetic_moment(const Evaluation<2>& evaluation) const {
  const System<2>& s = packing_.system;
  double sum = 0;
  const auto add = [&](double mass, const Vec2& at, const Vec2& velocity) {
    const Vec2 u = velocity - s.box.flow_velocity(at);
    sum += mass * u[flow] * u[gradient];
  };
  for_sites_apart(
      s, [&](int i) { add(s.state.mass[i], s.state.position[i], synchronised_velocity(s, evaluation, i)); });
  for (int r = 0; r < s.rigid.size(); ++r)
    add(s.rigid.mass[r], s.rigid.centre[r], synchronised_rigid(s, evaluation, r).velocity);
  return sum;
}

}  // namespace supple
