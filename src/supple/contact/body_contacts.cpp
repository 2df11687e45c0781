#include "supple/contact/body_contacts.hpp"

namespace supple {

namespace {

/// How the nearest point of a flat piece of a boundary (an edge, a triangle) runs along it: where the corner
/// k moves by z_k relative to corner 0, along the normal, the point moves by -d (n.z_k) g_k, d being the
/// distance, and g_k = `direction`/`length` the gradient of the weight of that corner: it points at the
/// corner from the opposite side, at the distance `length`.
template <int Dim>
struct Slide {
  Vec<Dim> direction;
  double length;
};

/// d2U / dx_a dx_b of a record under U(d) [energy/length^2]. The distance d has the gradient c_a n by site a.
/// Its second derivative d'' along displacements dx_a is, with y = sum c_a dx_a and z_k the displacement of
/// corner k of the piece less that of corner 0,
///     d'' = y.P y/d - sum_k 2 (g_k.y)(n.z_k) - d sum_kl (g_k.g_l)(n.z_k)(n.z_l),
/// P projecting on what is perpendicular to n and to the piece: of a corner I - n n^T, of an edge in 3D one
/// direction, else nothing. (Minimise |y - sum s_k e_k|^2/d - 2 sum s_k n.z_k over the shifts s_k of the
/// nearest point along the sides e_k of the piece.)
template <int Dim>
class Curvature {
 public:
  Curvature(const ContactRecord<Dim>& record, const BodyLaw& law, const std::vector<Vec<Dim>>& x)
      : record_(record),
        stretch_(record.multiplicity * law.stiffness(record.distance(), record.reach)),
        slope_(-record.multiplicity * law.force(record.distance(), record.reach)) {
    const Vec<Dim>& n = record.normal;
    if constexpr (Dim == 2) {
      // The direction from the start of an edge to its end, as n is on the right of it.
      if (record.sites == 3) slides_[0] = {turned_left(n), norm(x[record.site[2]] - x[record.site[1]])};
      else across_[0] = turned_left(n);
    } else {
      find_directions(x);
    }
  }

  Mat<Dim> block(int a, int b) const {
    const Vec<Dim>& n = record_.normal;
    const double both = record_.weight[a] * record_.weight[b];
    Mat<Dim> h;
    h.add_outer(stretch_ * both, n, n);
    for (int p = 0; p < Dim - 1 - sides(); ++p)
      h.add_outer(slope_ / record_.distance() * both, across_[p], across_[p]);
    for (int k = 0; k < sides(); ++k) {
      const Slide<Dim>& s = slides_[k];
      const double along = -slope_ / s.length;
      h.add_outer(along * record_.weight[a] * end(b, k), s.direction, n);
      h.add_outer(along * end(a, k) * record_.weight[b], n, s.direction);
      for (int l = 0; l < sides(); ++l) {
        const double cosine = k == l ? 1 : dot(s.direction, slides_[l].direction);
        h.add_outer(along * record_.distance() / slides_[l].length * cosine * end(a, k) * end(b, l), n, n);
      }
    }
    return h;
  }

 private:
  int sides() const { return record_.sites - 2; }
  /// z_k = sum end(a, k) dx_a; site 0 of the record is the point, site 1 the corner 0.
  static double end(int a, int k) { return a == 1 ? -1 : a == k + 2 ? 1 : 0; }

  void find_directions(const std::vector<Vec3>& x) {
    const Vec3& n = record_.normal;
    const auto side = [&](int k) { return x[record_.site[k + 2]] - x[record_.site[1]]; };
    if (sides() == 0) {
      const Vec3 other = std::abs(n[0]) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}, t = cross(n, other);
      across_[0] = (1 / norm(t)) * t;
      across_[1] = cross(n, across_[0]);
    } else if (sides() == 1) {
      const Vec3 e = side(0);
      slides_[0] = {(1 / norm(e)) * e, norm(e)};
      across_[0] = cross(n, slides_[0].direction);
    } else {
      const Vec3 e = side(0), f = side(1), area = cross(e, f);
      const auto slide = [&](const Vec3& across) {  // across the opposite side, within the plane
        const double length = norm(across);
        return Slide<3>{(1 / length) * across, dot(area, area) / length};
      };
      slides_[0] = slide(cross(f, area));
      slides_[1] = slide(cross(area, e));
    }
  }

  const ContactRecord<Dim>& record_;
  double stretch_, slope_;
  Slide<Dim> slides_[2]{};  // of an edge in 2D one alone: GCC sees no bound there
  Vec<Dim> across_[2]{};
};

}  // namespace

template <int Dim>
void BodyContacts<Dim>::update_species(const System<Dim>& system) {
  species_.clear();
  if (system.species.empty()) return;
  species_ = bodies_of_sites(system.topology, system.state.size());
  for (std::int32_t& of_site : species_) of_site = system.species_of(of_site);
}

template <int Dim>
void BodyContacts<Dim>::add_hessian(const System<Dim>& system, HessianBlocks<Dim>& blocks) {
  for (const ContactRecord<Dim>& record : records(system)) {
    const Curvature<Dim> curvature(record, laws_.of(record.species), system.state.position);
    for (int a = 0; a < record.sites; ++a)
      for (int b = 0; b <= a; ++b) blocks.push_back({record.site[a], record.site[b], curvature.block(a, b)});
  }
}

template <int Dim>
std::vector<BodyTouch<Dim>> sum_touches(const System<Dim>& system,
                                        const std::vector<ContactRecord<Dim>>& records,
                                        const ContactLaws& laws) {
  const std::vector<std::int32_t> body = bodies_of_sites(system.topology, system.state.size());
  std::vector<BodyTouch<Dim>> touches;
  for (std::int32_t k = 0; k < static_cast<std::int32_t>(records.size()); ++k) {
    const ContactRecord<Dim>& record = records[k];
    if (k == 0 || record.touch < 0 || record.touch != records[k - 1].touch) {
      const int at = record.weight[0] > 0 ? 0 : 1, other = at == 0 ? 1 : 0;
      touches.push_back({record.site[at], body[record.site[other]], {}, 0, {}, k, 0});
    }
    BodyTouch<Dim>& touch = touches.back();
    const BodyLaw& law = laws.of(record.species);
    touch.force += record.multiplicity * law.force(record.distance(), record.reach) * record.normal;
    touch.energy += record.multiplicity * law.energy(record.distance(), record.reach);
    touch.outward += record.multiplicity * record.normal;
    ++touch.records;
  }
  return touches;
}

template <int Dim>
void evaluate_conservative(const std::vector<ContactRecord<Dim>>& records, const ContactLaws& laws,
                           Evaluation<Dim>& out) {
  for (const ContactRecord<Dim>& record : records) {
    const BodyLaw& law = laws.of(record.species);
    const double distance = record.distance();
    const Vec<Dim> force = record.multiplicity * law.force(distance, record.reach) * record.normal;
    scatter(record, force, out.force, out.torque);
    out.energy.elastic += record.multiplicity * law.energy(distance, record.reach);
    out.virial.add_outer(1, force, record.branch);
  }
}

template class BodyContacts<2>;
template class BodyContacts<3>;
template std::vector<BodyTouch<2>> sum_touches(const System<2>&, const std::vector<ContactRecord<2>>&,
                                               const ContactLaws&);
template std::vector<BodyTouch<3>> sum_touches(const System<3>&, const std::vector<ContactRecord<3>>&,
                                               const ContactLaws&);
template void evaluate_conservative(const std::vector<ContactRecord<2>>&, const ContactLaws&, Evaluation<2>&);
template void evaluate_conservative(const std::vector<ContactRecord<3>>&, const ContactLaws&, Evaluation<3>&);

}  // namespace supple
