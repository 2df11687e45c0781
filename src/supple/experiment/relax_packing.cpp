#include <fmt/format.h>

#include <cmath>

#include "supple/core/error.hpp"
#include "supple/experiment/packing.hpp"
#include "supple/experiment/sound_states.hpp"

namespace supple {

template <int Dim>
MinimiseReport relax(Packing<Dim>& packing, const MinimiseCallback& callback) {
  BodyObjective<Dim> objective(packing.system, *packing.field, packing.tolerance);
  std::vector<double> x = objective.coordinates();
  const MinimiseReport report = minimise(objective, x, packing.minimise, callback);
  require_going_on(packing, report);
  return report;
}

template <int Dim>
void remember(Packing<Dim>& packing, const MinimiseReport& report, const Soundness& soundness) {
  if (report.converged && !must_stop(packing, soundness)) packing.relaxed = packing.system;
}

namespace {

template <int Dim>
void go_back(Packing<Dim>& packing) {
  if (packing.relaxed) packing.system = *packing.relaxed;
  packing.field->invalidate();
}

}  // namespace

template <int Dim>
void require_going_on(Packing<Dim>& packing, const MinimiseReport& report) {
  if (report.ending != Ending::interrupted && report.ending != Ending::not_finite) return;
  go_back(packing);
  if (report.ending == Ending::interrupted)
    throw Error(ErrorKind::interrupted, "interrupted within a minimisation");
  throw numerics_error(fmt::format("a minimisation ended after {} evaluations", report.evaluations),
                       report.reason, "take smaller steps, or another seed");
}

template <int Dim>
void require_converged(Packing<Dim>& packing, const MinimiseReport& report, const std::string& where) {
  if (report.converged) return;
  go_back(packing);
  const bool exhausted = report.ending == Ending::exhausted;
  throw numerics_error(fmt::format("{} is not in equilibrium", where),
                       fmt::format("{}; the largest net force is {:.3g}, the tolerance {:.3g}", report.reason,
                                   report.residual, report.tolerance),
                       exhausted
                           ? "raise minimise.max_evaluations"
                           : "raise minimise.force_tolerance or minimise.least_force, or take another seed");
}

template <int Dim>
double least_energy(Packing<Dim>& packing, double pressure) {
  System<Dim>& system = packing.system;
  const ContactLaws& laws = packing.field->bodies()->laws();
  if (!laws.all([](const BodyLaw& law) { return law.is_harmonic(); })) return 0;
  double sum = 0;
  for (const ContactRecord<Dim>& r : packing.field->bodies()->records(system))
    sum += std::abs(r.multiplicity) * laws.of(r.species).spring(r.reach) * r.reach * r.reach;
  for (std::size_t b = 0; !packing.contact_pressure && b < system.shape.stiffness.size(); ++b) {
    const ShapeStiffness& k = system.shape.stiffness[b];
    if (k.tension != 0) return 0;
    sum += Dim * Dim * k.volume * system.shape.rest_volume[b] * system.shape.rest_volume[b];
    for (int f = system.topology.facet_begin[b]; f < system.topology.facet_begin[b + 1]; ++f)
      sum += (Dim - 1) * (Dim - 1) * k.facet * system.shape.rest_facet[f] * system.shape.rest_facet[f];
  }
  const Solid<Dim>& solid = system.solid;
  for (int b = 0; !packing.contact_pressure && b < solid.bodies(); ++b) {
    const SolidStiffness& k = solid.stiffness[b];
    if (k.lambda != 0 || k.mu != 0) return 0;  // no sum of springs
    for (std::int32_t n = solid.bond_begin[b]; n < solid.bond_begin[b + 1]; ++n)
      sum += k.bond * solid.rest_bond[n] * solid.rest_bond[n];
  }
  const double virial = Dim * pressure * packing.pressure_unit * system.box.volume();
  return sum > 0 ? virial * virial / (2 * sum) : 0;
}

template MinimiseReport relax(Packing<2>&, const MinimiseCallback&);
template void remember(Packing<2>&, const MinimiseReport&, const Soundness&);
template void require_going_on(Packing<2>&, const MinimiseReport&);
template void require_converged(Packing<2>&, const MinimiseReport&, const std::string&);
template double least_energy(Packing<2>&, double);
template MinimiseReport relax(Packing<3>&, const MinimiseCallback&);
template void remember(Packing<3>&, const MinimiseReport&, const Soundness&);
template void require_going_on(Packing<3>&, const MinimiseReport&);
template void require_converged(Packing<3>&, const MinimiseReport&, const std::string&);
template double least_energy(Packing<3>&, double);

}  // namespace supple
