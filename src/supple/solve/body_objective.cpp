#include "supple/solve/body_objective.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace supple {

double mean_contact_force(const System<2>& system, BodyContacts& contacts) {
  double sum = 0;
  const std::vector<ContactRecord<2>> records = contacts.records(system);
  for (const ContactRecord<2>& r : records)
    sum += std::abs(r.multiplicity * contacts.laws().of(r.species).force(r.distance(), r.reach));
  return records.empty() ? 0 : sum / static_cast<double>(records.size());
}

namespace {

double largest_net(const BodyDegrees& degrees, std::span<const double> slope) {
  const auto of_sites = 2 * static_cast<std::size_t>(degrees.site_count());
  double square = largest_square_of_pairs(slope.first(of_sites)), other = 0;
  for (std::size_t k = of_sites; k < slope.size(); ++k) other = std::max(other, std::abs(slope[k]));
  return std::max(std::sqrt(square), other);
}

/// Stiffness of the stiffest vertex [energy/length^2]: two edges and three corners, or a contact.
double vertex_stiffness(const System<2>& system, BodyContacts* contacts) {
  double most = 0;
  for (std::size_t b = 0; b < system.shape.stiffness.size(); ++b) {
    const ShapeStiffness& k = system.shape.stiffness[b];
    const std::int32_t first = system.topology.facet_begin[b], end = system.topology.facet_begin[b + 1];
    if (first == end) continue;
    const double l =
        *std::min_element(&system.shape.rest_facet[first], &system.shape.rest_facet[first] + (end - first));
    most = std::max(most, 2 * k.facet + 6 * k.hinge / (l * l) + k.tension / l);
  }
  if (contacts && !system.state.radius.empty())
    most = std::max(most, contacts->laws().most([sigma = 2 * *std::min_element(system.state.radius.begin(),
                                                                               system.state.radius.end())](
                                                    const BodyLaw& law) { return law.spring(sigma); }));
  return most;
}

}  // namespace

BodyObjective::BodyObjective(System<2>& system, ForceField& field, const ForceTolerance& tolerance)
    : system_(system),
      field_(field),
      degrees_(system),
      tolerance_(tolerance),
      tolerance_now_(tolerance.least),
      stiffness_(vertex_stiffness(system, field.bodies())) {
  const std::vector<double>& radius = system.state.radius;
  largest_move_ = radius.empty() ? 1 : 0.2 * *std::min_element(radius.begin(), radius.end());
}

std::vector<double> BodyObjective::coordinates() const {
  std::vector<double> x(static_cast<std::size_t>(size()));
  degrees_.read(system_, x);
  return x;
}

double BodyObjective::evaluate(std::span<const double> x, std::span<double> slope) {
  evaluate(x, slope, Detail::energies);
  return out_.energy.stored();
}

void BodyObjective::evaluate(std::span<const double> x, std::span<double> slope, Detail detail) {
  degrees_.write(x, system_);
  field_.evaluate(system_, detail, out_);
  degrees_.gradient(system_, out_.force, slope);
  // The mean contact force changes slowly: it need not be counted at every step, only before one believes the
  // tolerance.
  if (--until_refresh_ < 0 || residual(x, slope) <= tolerance_now_) refresh_tolerance(x);
}

double largest_net_force(const System<2>& system, const std::vector<Vec2>& force) {
  const BodyDegrees degrees(system);
  std::vector<double> slope(static_cast<std::size_t>(degrees.size()));
  degrees.gradient(system, force, slope);
  return largest_net(degrees, slope);
}

double BodyObjective::residual(std::span<const double>, std::span<const double> slope) {
  return largest_net(degrees_, slope);
}

void BodyObjective::refresh_tolerance(std::span<const double> x) {
  constexpr int interval = 100;
  until_refresh_ = interval;
  const double mean = field_.bodies() ? mean_contact_force(system_, *field_.bodies()) : 0;
  // A position is known to half a unit in its last digit; two edges and three moments add up at a vertex.
  const double rounding = std::numeric_limits<double>::epsilon() * largest(x) * stiffness_;
  tolerance_now_ = std::max({tolerance_.least, rounding, tolerance_.relative * mean});
}

void BodyObjective::assemble(std::span<const double> x, HessianKind kind, SparseMatrix& lower) {
  degrees_.write(x, system_);
  blocks_.clear();
  field_.add_hessian(system_, blocks_, kind);
  // The angle of a rigid body turns its sites on circles, so that their forces enter.
  if (!system_.rigid.body.empty()) field_.evaluate(system_, Detail::forces, out_);
  degrees_.hessian(system_, blocks_, out_.force, entries_);
  sum_entries(size(), entries_, lower);
}

}  // namespace supple
