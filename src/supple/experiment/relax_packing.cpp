#include <fmt/format.h>

#include <cmath>

#include "supple/core/error.hpp"
#include "supple/experiment/packing.hpp"
#include "supple/experiment/sound_states.hpp"

namespace supple {

MinimiseReport relax(Packing& packing, const MinimiseCallback& callback) {
  BodyObjective<2> objective(packing.system, *packing.field, packing.tolerance);
  std::vector<double> x = objective.coordinates();
  const MinimiseReport report = minimise(objective, x, packing.minimise, callback);
  require_going_on(packing, report);
  return report;
}

void remember(Packing& packing, const MinimiseReport& report, const Soundness& soundness) {
  if (report.converged && !must_stop(packing, soundness)) packing.relaxed = packing.system;
}

namespace {

void go_back(Packing& packing) {
  if (packing.relaxed) packing.system = *packing.relaxed;
  packing.field->invalidate();
}

}  // namespace

void require_going_on(Packing& packing, const MinimiseReport& report) {
  if (report.ending != Ending::interrupted && report.ending != Ending::not_finite) return;
  go_back(packing);
  if (report.ending == Ending::interrupted)
    throw Error(ErrorKind::interrupted, "interrupted within a minimisation");
  throw numerics_error(fmt::format("a minimisation ended after {} evaluations", report.evaluations),
                       report.reason, "take smaller steps, or another seed");
}

void require_converged(Packing& packing, const MinimiseReport& report, const std::string& where) {
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

double least_energy(Packing& packing, double pressure) {
  System<2>& system = packing.system;
  const ContactLaws& laws = packing.field->bodies()->laws();
  if (!laws.all([](const BodyLaw& law) { return law.is_harmonic(); })) return 0;
  double sum = 0;
  for (const ContactRecord<2>& r : packing.field->bodies()->records(system))
    sum += std::abs(r.multiplicity) * laws.of(r.species).spring(r.reach) * r.reach * r.reach;
  for (std::size_t b = 0; !packing.contact_pressure && b < system.shape.stiffness.size(); ++b) {
    const ShapeStiffness& k = system.shape.stiffness[b];
    if (k.tension != 0) return 0;
    sum += 4 * k.volume * system.shape.rest_volume[b] * system.shape.rest_volume[b];
    for (int f = system.topology.facet_begin[b]; f < system.topology.facet_begin[b + 1]; ++f)
      sum += k.facet * system.shape.rest_facet[f] * system.shape.rest_facet[f];
  }
  const double virial = 2 * pressure * packing.pressure_unit * system.box.volume();
  return sum > 0 ? virial * virial / (2 * sum) : 0;
}

}  // namespace supple
