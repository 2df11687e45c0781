#include "supple/contact/body_contacts.hpp"

namespace supple {

namespace {

/// d2U / dx_a dx_b of a record under U(d) [energy/length^2]. The distance d has the gradient c_a n by site a.
/// Its second derivative d'' along displacements dx_a is, with y = sum c_a dx_a,
///     d'' = (y.y - (n.y)^2)/d                          between two points,
///     d'' = -2 (t.y)(n.z)/L - d (n.z)^2/L^2            between a point and an edge of length L along t,
/// z being the displacement of the end of the edge less that of its start.
class Curvature {
 public:
  Curvature(const ContactRecord<2>& record, const BodyLaw& law, double edge_length)
      : record_(record),
        edge_length_(edge_length),
        stretch_(record.multiplicity * law.stiffness(record.distance(), record.reach)),
        slope_(-record.multiplicity * law.force(record.distance(), record.reach)) {}

  Mat2 block(int a, int b) const {
    const Vec2 &n = record_.normal, t = turned_left(n);
    const double both = record_.weight[a] * record_.weight[b];
    Mat2 h;
    h.add_outer(stretch_ * both, n, n);
    if (record_.sites == 2) {
      h.add_outer(slope_ / record_.distance() * both, t, t);
      return h;
    }
    const double along =
        -slope_ / edge_length_;  // t from the start of an edge to its end, as n is on the right of it
    h.add_outer(along * record_.weight[a] * end_[b], t, n);
    h.add_outer(along * end_[a] * record_.weight[b], n, t);
    h.add_outer(along * record_.distance() / edge_length_ * end_[a] * end_[b], n, n);
    return h;
  }

 private:
  static constexpr double end_[3] = {0, -1, 1};  ///< z = sum end_a dx_a
  const ContactRecord<2>& record_;
  double edge_length_, stretch_, slope_;
};

}  // namespace

void BodyContacts::update_species(const System<2>& system) {
  species_.clear();
  if (system.species.empty()) return;
  species_ = bodies_of_sites(system.topology, system.state.size());
  for (std::int32_t& of_site : species_) of_site = system.species_of(of_site);
}

void BodyContacts::add_hessian(const System<2>& system, HessianBlocks<2>& blocks) {
  for (const ContactRecord<2>& record : records(system)) {
    const bool edge = record.sites == 3;
    const std::vector<Vec2>& x = system.state.position;
    const Curvature curvature(record, laws_.of(record.species),
                              edge ? norm(x[record.site[2]] - x[record.site[1]]) : 0);
    for (int a = 0; a < record.sites; ++a)
      for (int b = 0; b <= a; ++b) blocks.push_back({record.site[a], record.site[b], curvature.block(a, b)});
  }
}

std::vector<BodyTouch> sum_touches(const System<2>& system, const std::vector<ContactRecord<2>>& records,
                                   const ContactLaws& laws) {
  const std::vector<std::int32_t> body = bodies_of_sites(system.topology, system.state.size());
  std::vector<BodyTouch> touches;
  for (std::int32_t k = 0; k < static_cast<std::int32_t>(records.size()); ++k) {
    const ContactRecord<2>& record = records[k];
    if (k == 0 || record.touch < 0 || record.touch != records[k - 1].touch) {
      const int at = record.weight[0] > 0 ? 0 : 1, other = at == 0 ? 1 : 0;
      touches.push_back({record.site[at], body[record.site[other]], {}, 0, {}, k, 0});
    }
    BodyTouch& touch = touches.back();
    const BodyLaw& law = laws.of(record.species);
    touch.force += record.multiplicity * law.force(record.distance(), record.reach) * record.normal;
    touch.energy += record.multiplicity * law.energy(record.distance(), record.reach);
    touch.outward += record.multiplicity * record.normal;
    ++touch.records;
  }
  return touches;
}

void evaluate_conservative(const std::vector<ContactRecord<2>>& records, const ContactLaws& laws,
                           Evaluation<2>& out) {
  for (const ContactRecord<2>& record : records) {
    const BodyLaw& law = laws.of(record.species);
    const double distance = record.distance();
    const Vec2 force = record.multiplicity * law.force(distance, record.reach) * record.normal;
    scatter(record, force, out.force, out.torque);
    out.energy.elastic += record.multiplicity * law.energy(distance, record.reach);
    out.virial.add_outer(1, force, record.branch);
  }
}

}  // namespace supple
