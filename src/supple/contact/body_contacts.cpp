#include "supple/contact/body_contacts.hpp"

namespace supple {

namespace {

/// Curvature of U(d) by the branch vector b = sum c_a x_a, whose length is the distance: U'' n n^T + (U'/d) (1 - n n^T). For a vertex on an
/// edge the distance also turns with the edge; that part is added by the contacts that have edges.
Mat2 curvature(const ContactRecord<2>& record, const Harmonic& law) {
  const double stretch = record.multiplicity * law.spring(record.reach);
  const double turn = -record.multiplicity * law.force(record.distance(), record.reach) / record.distance();
  Mat2 h;
  h.add_outer(stretch - turn, record.normal, record.normal);
  h[0][0] += turn;
  h[1][1] += turn;
  return h;
}

}  // namespace

void BodyContacts::add_hessian(const System<2>& system, HessianBlocks<2>& blocks) {
  for (const ContactRecord<2>& record : records(system)) {
    const Mat2 h = curvature(record, law_);
    for (int a = 0; a < record.sites; ++a)
      for (int b = 0; b <= a; ++b) blocks.push_back({record.site[a], record.site[b], record.weight[a] * record.weight[b] * h});
  }
}

const std::vector<std::int32_t>& BodyContacts::sites_inside() const {
  static const std::vector<std::int32_t> none;
  return none;
}

void evaluate_conservative(const std::vector<ContactRecord<2>>& records, const Harmonic& law, Evaluation<2>& out) {
  for (const ContactRecord<2>& record : records) {
    const double distance = record.distance();
    const Vec2 force = record.multiplicity * law.force(distance, record.reach) * record.normal;
    scatter(record, force, out.force, out.torque);
    out.energy.elastic += record.multiplicity * law.energy(distance, record.reach);
    out.virial.add_outer(1, force, record.branch);
  }
}

}  // namespace supple
