#include "supple/solve/body_objective.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace supple {

template <int Dim>
double mean_contact_force(const System<Dim>& system, BodyContacts<Dim>& contacts) {
  double sum = 0;
  const std::vector<ContactRecord<Dim>> records = contacts.records(system);
  for (const ContactRecord<Dim>& r : records)
    sum += std::abs(r.multiplicity * contacts.laws().of(r.species).force(r.distance(), r.reach));
  return records.empty() ? 0 : sum / static_cast<double>(records.size());
}

namespace {

template <int Dim>
double largest_net(const BodyDegrees<Dim>& degrees, std::span<const double> slope) {
  const auto of_sites = Dim * static_cast<std::size_t>(degrees.site_count());
  double square = largest_square<Dim>(slope.first(of_sites)), other = 0;
  for (std::size_t k = of_sites; k < slope.size(); ++k) other = std::max(other, std::abs(slope[k]));
  return std::max(std::sqrt(square), other);
}

/// Stiffness of a vertex by what of its body is round it [energy/length^2], `rest` the smallest rest value of
/// a facet: two edges and three corners in 2D; six triangles and, of their hinges, twelve in 3D.
template <int Dim>
double stiffness_of_shape(const ShapeStiffness& k, double rest) {
  if constexpr (Dim == 2) return 2 * k.facet + 6 * k.hinge / (rest * rest) + k.tension / rest;
  const double square = 4 * rest / std::numbers::sqrt3;  // of the edge of a regular triangle
  return 1.5 * k.facet * square + 24 * k.hinge / square + 4 * k.tension;
}

/// Stiffness of a site by its bonds and elements [energy/length^2], roughly: by the trace of the second
/// derivatives of a bond along it and of an element at small strain.
template <int Dim>
double stiffness_inside(const Solid<Dim>& solid) {
  double most = 0;
  for (int b = 0; b < solid.bodies(); ++b) {
    const SolidStiffness& k = solid.stiffness[b];
    if (solid.bond_begin[b] < solid.bond_begin[b + 1]) most = std::max(most, 2.0 * Dim * k.bond);
    for (std::int32_t e = solid.element_begin[b]; e < solid.element_begin[b + 1]; ++e) {
      const Mat<Dim>& inverse = solid.rest_element[e];
      double square = 0;  // of the slopes of the deformation by the sites
      for (int a = 0; a < Dim; ++a)
        for (int d = 0; d < Dim; ++d) square = std::max(square, inverse[a][d] * inverse[a][d]);
      const double volume = 1 / ((Dim == 2 ? 2 : 6) * determinant(inverse));
      most = std::max(most, volume * square * (k.lambda + 2 * k.mu));
    }
  }
  return most;
}

/// Stiffness of the stiffest vertex [energy/length^2]: by its shape, what is inside, or a contact.
template <int Dim>
double vertex_stiffness(const System<Dim>& system, BodyContacts<Dim>* contacts) {
  double most = 0;
  for (std::size_t b = 0; b < system.shape.stiffness.size(); ++b) {
    const ShapeStiffness& k = system.shape.stiffness[b];
    const std::int32_t first = system.topology.facet_begin[b], end = system.topology.facet_begin[b + 1];
    if (first == end) continue;
    const double rest =
        *std::min_element(&system.shape.rest_facet[first], &system.shape.rest_facet[first] + (end - first));
    most = std::max(most, stiffness_of_shape<Dim>(k, rest));
  }
  most = std::max(most, stiffness_inside(system.solid));
  if (contacts && !system.state.radius.empty())
    most = std::max(most, contacts->laws().most([sigma = 2 * *std::min_element(system.state.radius.begin(),
                                                                               system.state.radius.end())](
                                                    const BodyLaw& law) { return law.spring(sigma); }));
  return most;
}

}  // namespace

template <int Dim>
BodyObjective<Dim>::BodyObjective(System<Dim>& system, ForceField<Dim>& field,
                                  const ForceTolerance& tolerance)
    : system_(system),
      field_(field),
      degrees_(system),
      tolerance_(tolerance),
      tolerance_now_(tolerance.least),
      stiffness_(vertex_stiffness(system, field.bodies())) {
  if constexpr (Dim == 3) shorten_angles(system);
  const std::vector<double>& radius = system.state.radius;
  largest_move_ = radius.empty() ? 1 : 0.2 * *std::min_element(radius.begin(), radius.end());
}

template <int Dim>
std::vector<double> BodyObjective<Dim>::coordinates() const {
  std::vector<double> x(static_cast<std::size_t>(size()));
  degrees_.read(system_, x);
  return x;
}

template <int Dim>
double BodyObjective<Dim>::evaluate(std::span<const double> x, std::span<double> slope) {
  evaluate(x, slope, Detail::energies);
  return out_.energy.stored();
}

template <int Dim>
void BodyObjective<Dim>::evaluate(std::span<const double> x, std::span<double> slope, Detail detail) {
  degrees_.write(x, system_);
  field_.evaluate(system_, detail, out_);
  degrees_.gradient(system_, out_.force, slope);
  // The mean contact force changes slowly: it need not be counted at every step, only before one believes the
  // tolerance.
  if (--until_refresh_ < 0 || residual(x, slope) <= tolerance_now_) refresh_tolerance(x);
}

template <int Dim>
double largest_net_force(const System<Dim>& system, const std::vector<Vec<Dim>>& force) {
  const BodyDegrees<Dim> degrees(system);
  std::vector<double> slope(static_cast<std::size_t>(degrees.size()));
  degrees.gradient(system, force, slope);
  return largest_net(degrees, slope);
}

template <int Dim>
double BodyObjective<Dim>::residual(std::span<const double>, std::span<const double> slope) {
  return largest_net(degrees_, slope);
}

template <int Dim>
void BodyObjective<Dim>::refresh_tolerance(std::span<const double> x) {
  constexpr int interval = 100;
  until_refresh_ = interval;
  const double mean = field_.bodies() ? mean_contact_force(system_, *field_.bodies()) : 0;
  // A position is known to half a unit in its last digit; two edges and three moments add up at a vertex.
  const double rounding = std::numeric_limits<double>::epsilon() * largest(x) * stiffness_;
  tolerance_now_ = std::max({tolerance_.least, rounding, tolerance_.relative * mean});
}

template <int Dim>
void BodyObjective<Dim>::assemble(std::span<const double> x, HessianKind kind, SparseMatrix& lower) {
  degrees_.write(x, system_);
  blocks_.clear();
  field_.add_hessian(system_, blocks_, kind);
  // The angle of a rigid body turns its sites on circles, so that their forces enter.
  if (!system_.rigid.body.empty()) field_.evaluate(system_, Detail::forces, out_);
  degrees_.hessian(system_, blocks_, out_.force, entries_);
  sum_entries(size(), entries_, lower);
}

template class BodyObjective<2>;
template class BodyObjective<3>;
template double largest_net_force(const System<2>&, const std::vector<Vec2>&);
template double largest_net_force(const System<3>&, const std::vector<Vec3>&);
template double mean_contact_force(const System<2>&, BodyContacts<2>&);
template double mean_contact_force(const System<3>&, BodyContacts<3>&);

}  // namespace supple
