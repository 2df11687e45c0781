#include "supple/observe/body_stress.hpp"

#include <algorithm>

#include "supple/core/error.hpp"
#include "supple/model/rigid.hpp"

namespace supple {

namespace {

/// Sites on the two sides of a contact: one of each.
struct Sides {
  std::int32_t negative = -1, positive = -1;

  template <int Dim>
  explicit Sides(const ContactRecord<Dim>& record) {
    for (int k = 0; k < record.sites; ++k) {
      if (record.weight[k] > 0) positive = record.site[k];
      if (record.weight[k] < 0) negative = record.site[k];
    }
  }
};

/// Part h/r of the contact's line that lies within the body of radius `own`: up to the chord where the
/// circles cross.
double share_of(double own, double other, double distance) {
  if (!(distance > 0)) return 0.5;
  return std::clamp(0.5 + 0.5 * (own - other) * (own + other) / (distance * distance), 0.0, 1.0);
}

template <int Dim>
Mat<Dim> kinetic_moment(const System<Dim>& system) {
  Mat<Dim> sum;
  const State<Dim>& s = system.state;
  for (int i = 0; i < s.size(); ++i) {
    const Vec<Dim> u = s.velocity[i] - system.box.flow_velocity(s.position[i]);
    sum.add_outer(s.mass[i], u, u);
  }
  return sum;
}

/// Sum F r^T over the sites of body b. The forces of a body sum to zero, so that r may be from any point; a
/// near one loses no digits.
template <int Dim>
Mat<Dim> shape_moment(const System<Dim>& system, std::span<const Vec<Dim>> force, int b) {
  Mat<Dim> moment;
  const std::int32_t first = system.topology.body_begin(b);
  for (std::int32_t i = first + 1; i < system.topology.body_end(b); ++i)
    moment.add_outer(1, force[i], system.state.position[i] - system.state.position[first]);
  return moment;
}

/// A wall moves with the cell: its force acts over the distance to it. Friction of the floor is along it and
/// does not.
template <int Dim>
Mat<Dim> wall_moment(const System<Dim>& system, const SiteForce<Dim>& wall) {
  const int d = direction_of(wall);
  const double x = system.state.position[wall.site][d];
  Mat<Dim> moment;
  moment[d][d] = wall.force[d] > 0 ? wall.force[d] * x : -wall.force[d] * (system.box.length[d] - x);
  return moment;
}

/// What a site at this arm from the centre is accelerated by toward the axis of a spin.
Vec2 toward_axis(double spin, const Vec2& arm) { return spin * spin * arm; }
Vec3 toward_axis(const Vec3& spin, const Vec3& arm) { return cross(cross(spin, arm), spin); }

/// Forces that keep the sites of rigid bodies together, under these forces on all sites.
template <int Dim>
void add_rigid_forces(const System<Dim>& system, const std::vector<Vec<Dim>>& force,
                      std::vector<Vec<Dim>>& inner) {
  const RigidBodiesOf<Dim>& rigid = system.rigid;
  for (int r = 0; r < rigid.size(); ++r) {
    if (held(system, r)) continue;  // what holds it acts on its sites: nothing is left to keep them together
    const RigidForceOf<Dim> whole = force_on_rigid(system, force, r);
    const Vec<Dim> acceleration = (1 / rigid.mass[r]) * whole.force;
    const Angular<Dim> turning = spin_change(system, r, whole.torque), spin = rigid.spin[r];
    const std::int32_t b = rigid.body[r];
    for (std::int32_t i = system.topology.body_begin(b); i < system.topology.body_end(b); ++i) {
      const Vec<Dim> arm = system.state.position[i] - rigid.centre[r];
      inner[i] +=
          system.state.mass[i] * (acceleration + cross(turning, arm) - toward_axis(spin, arm)) - force[i];
    }
  }
}

/// The forces of friction, viscosity and links, half to each of the two bodies.
void add_memory(const System<2>& system, const Evaluation<2>& evaluation, BodyStresses<2>& s) {
  const std::vector<std::int32_t> body = bodies_of_sites(system.topology, system.state.size());
  const auto add = [&](const Mat2& moment, std::int32_t one, std::int32_t other) {
    s.contact += (1 / system.box.volume()) * moment;
    s.moment[one] += 0.5 * moment;
    s.moment[other] += 0.5 * moment;
  };
  for (const TouchForce& f : evaluation.touch_force)
    add(f.virial, body[f.key.site], body_of_other(f.key, body));
  for (std::size_t k = 0; k < evaluation.link_force.size(); ++k)
    add(evaluation.link_force[k].virial, body[system.links[k].first], body[system.links[k].second]);
}

}  // namespace

template <int Dim>
std::vector<Mat<Dim>> BodyStresses<Dim>::of_bodies(std::span<const double> area) const {
  if (area.size() != moment.size())
    throw input_error("areas and bodies differ in number", "each body has one");
  std::vector<Mat<Dim>> stress = moment;
  for (std::size_t b = 0; b < stress.size(); ++b) stress[b] *= 1 / area[b];
  return stress;
}

template <int Dim>
BodyStresses<Dim> body_stresses(const System<Dim>& system,
                                std::type_identity_t<std::span<const Vec<Dim>>> shape_force,
                                const std::vector<ContactRecord<Dim>>& records, const ContactLaws& laws,
                                std::type_identity_t<std::span<const SiteForce<Dim>>> wall) {
  const State<Dim>& state = system.state;
  const std::vector<std::int32_t> body = bodies_of_sites(system.topology, state.size());
  BodyStresses<Dim> s;
  s.kinetic = kinetic_moment(system);
  for (int b = 0; b < system.topology.body_count(state.size()); ++b) {
    s.moment.push_back(shape_moment(system, shape_force, b));
    s.shape += s.moment.back();
  }
  for (const ContactRecord<Dim>& record : records) {
    const Sides sides(record);
    const double distance = record.distance(),
                 force = record.multiplicity * laws.of(record.species).force(distance, record.reach);
    Mat<Dim> moment;
    moment.add_outer(force, record.normal, record.branch);
    s.contact += moment;
    const double share = share_of(state.radius[sides.negative], state.radius[sides.positive], distance);
    s.moment[body[sides.negative]] += share * moment;
    s.moment[body[sides.positive]] += (1 - share) * moment;
  }
  for (const SiteForce<Dim>& w : wall) {
    const Mat<Dim> moment = wall_moment(system, w);
    s.wall += moment;
    s.moment[body[w.site]] += moment;
  }
  for (Mat<Dim>* part : {&s.kinetic, &s.shape, &s.contact, &s.wall}) *part *= 1 / system.box.volume();
  return s;
}

template <int Dim>
BodyStresses<Dim> body_stresses(const System<Dim>& system, ForceField<Dim>& field,
                                const Evaluation<Dim>& evaluation) {
  if (!field.bodies())
    throw input_error("no stress of bodies", "this force field is of discs with memory",
                      "use stress_tensors");
  Evaluation<Dim> shape;
  shape.force.assign(static_cast<std::size_t>(system.state.size()), Vec<Dim>{});
  field.terms().evaluate(system, Detail::forces, shape);
  add_rigid_forces(system, evaluation.force, shape.force);
  BodyStresses<Dim> s = body_stresses(system, shape.force, field.bodies()->records(system),
                                      field.bodies()->laws(), evaluation.wall);
  if constexpr (Dim == 2) add_memory(system, evaluation, s);
  return s;
}

template struct BodyStresses<2>;
template struct BodyStresses<3>;
template BodyStresses<2> body_stresses(const System<2>&, std::span<const Vec2>,
                                       const std::vector<ContactRecord<2>>&, const ContactLaws&,
                                       std::span<const SiteForce<2>>);
template BodyStresses<3> body_stresses(const System<3>&, std::span<const Vec3>,
                                       const std::vector<ContactRecord<3>>&, const ContactLaws&,
                                       std::span<const SiteForce<3>>);
template BodyStresses<2> body_stresses(const System<2>&, ForceField<2>&, const Evaluation<2>&);
template BodyStresses<3> body_stresses(const System<3>&, ForceField<3>&, const Evaluation<3>&);

}  // namespace supple
