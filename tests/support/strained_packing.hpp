/// -dU/d(strain) of packings in 3D by differences, to 1e-8 of the pressure and better, for every strain.
#pragma once
#include <algorithm>
#include <vector>

#include "supple/build/surfaces.hpp"
#include "supple/experiment/packing.hpp"
#include "supple/model/bodies.hpp"
#include "supple/model/rigid.hpp"

namespace supple::testing {

/// The derivative of f at 0, from 2 `pairs` values (4 or 8) at +-step ... +-pairs step: the error is of the
/// order step^(2 pairs) [Fornberg 1988, table 1].
template <class Function>
double slope_at_zero(const Function& f, double step, int pairs) {
  constexpr double of_two[] = {2. / 3, -1. / 12}, of_four[] = {4. / 5, -1. / 5, 4. / 105, -1. / 280};
  double sum = 0;
  for (int k = pairs; k > 0; --k)
    sum += (pairs == 4 ? of_four : of_two)[k - 1] * (f(k * step) - f(-k * step));
  return sum / step;
}

/// Moves every site by the strain x_i += e x_j; rigid bodies move with their centres.
inline void strain_sites(System<3>& system, int i, int j, double e) {
  for (auto* points : {&system.state.position, &system.rigid.centre})
    for (Vec3& x : *points) x[i] += e * x[j];
  place_sites(system);
}

/// The same of the cell, which has its lengths and one shear.
inline void strain_box(Box<3>& box, int i, int j, double e) {
  if (i != j) {
    box.strain += e;
    return;
  }
  // The tilt is strain times height: it grows with the length that it lies along.
  box.length[i] *= 1 + e;
  if (i == flow) box.strain *= 1 + e;
  if (i == gradient) box.strain /= 1 + e;
}
inline bool box_holds(int i, int j) { return i == j || (i == flow && j == gradient); }

/// The bodies of one cell, and those of the cells around it that they may meet, in empty space: there
/// everything can be strained in every way, the lattice of images with it.
class UnfoldedCell {
 public:
  explicit UnfoldedCell(const Packing<3>& packing)
      : contacts_(packing.field->bodies()->clone()),
        neighbors_(default_skin, contacts_->meeting(), contacts_->range()) {
    system_.box.periodic = {false, false, false};
    system_.box.length = {1, 1, 1};
    const System<3>& cell = packing.system;
    const int bodies = cell.topology.body_count(cell.state.size());
    for (int b = 0; b < bodies; ++b) add_copy(cell, b, {});
    own_ = system_.state.size();
    for (int x = -2; x <= 2; ++x)
      for (int y = -2; y <= 2; ++y)
        for (int z = -2; z <= 2; ++z) {
          const Vec3 shift = cell.box.lattice().vector({1.0 * x, 1.0 * y, 1.0 * z});
          for (int b = 0; b < bodies; ++b)
            if ((x != 0 || y != 0 || z != 0) && is_near(cell, b, shift)) add_copy(cell, b, shift);
        }
    rest_ = system_;
  }

  /// Energy of the contacts of one cell under this strain: of each the half for each of its bodies that is of
  /// the cell.
  double energy(int i, int j, double e) {
    double sum = 0;
    for (const ContactRecord<3>& r : records(i, j, e)) {
      const int own = (r.site[0] < own_) + (r.site[1] < own_);
      sum += 0.5 * own * r.multiplicity * contacts_->laws().of(r.species).energy(r.distance(), r.reach);
    }
    return sum;
  }

  /// A strain so small that up to twice of it no contact opens, closes or passes from one piece of a surface
  /// to another: where that happens the energy has no third derivative.
  double smooth_strain(int i, int j) {
    const Records at = records(i, j, 0);
    const auto same = [&](double e) {
      const Records other = records(i, j, e);
      return std::equal(at.begin(), at.end(), other.begin(), other.end(), [](const auto& a, const auto& b) {
        return a.sites == b.sites && a.site == b.site && a.multiplicity == b.multiplicity;
      });
    };
    double step = 1e-4;
    while (!(same(step) && same(-step) && same(2 * step) && same(-2 * step))) step *= 0.5;
    return step;
  }

 private:
  using Records = std::vector<ContactRecord<3>>;

  static bool is_near(const System<3>& cell, int b, const Vec3& shift) {
    for (int a = 0; a < cell.topology.body_count(cell.state.size()); ++a) {
      const double apart = norm(body_centre(cell, b) + shift - body_centre(cell, a));
      if (apart < 1.05 * (outer_radius(cell, a) + outer_radius(cell, b))) return true;
    }
    return false;
  }

  void add_copy(const System<3>& cell, int b, const Vec3& shift) {
    const double radius = cell.state.radius[cell.topology.body_begin(b)];
    TriangleMesh mesh = mesh_of(cell, b);
    if (mesh.face.empty()) return add_sphere_body(system_, body_centre(cell, b) + shift, radius);
    for (Vec3& x : mesh.vertex) x += shift;
    add_surface(system_, mesh, radius, {}, 1, std::vector<double>(mesh.face.size(), 1),
                std::vector<double>(hinges_of(mesh).size(), 0));
    if (std::ranges::binary_search(cell.rigid.body, b))
      make_rigid(system_, system_.topology.body_count(system_.state.size()) - 1);
  }

  Records records(int i, int j, double e) {
    system_.state.position = rest_.state.position;
    system_.rigid = rest_.rigid;
    strain_sites(system_, i, j, e);
    neighbors_.update(system_);
    return contacts_->records(system_);
  }

  System<3> system_;
  Owned<BodyContacts<3>> contacts_;
  NeighborList<3> neighbors_;
  System<3> rest_;
  std::int32_t own_ = 0;  ///< sites of the cell itself, which come first
};

/// The energy of a packing under strain by its parts, as they bear different steps: shapes are smooth and
/// their energy is large, so that small changes of it drown; contacts are small, and soon others.
class StrainedPacking {
 public:
  explicit StrainedPacking(const Packing<3>& packing) : packing_(packing), unfolded_(packing) {}

  /// -dU/de of x_i += e x_j, without the cell's own periodicity.
  double moment(int i, int j) {
    const auto contacts = [&](double e) { return unfolded_.energy(i, j, e); };
    return -slope_at_zero(contacts, unfolded_.smooth_strain(i, j), 2) + shape_moment(i, j);
  }
  /// The same by a strain of the periodic cell, which must hold it.
  double moment_by_box(int i, int j) {
    const auto contacts = [&](double e) {
      Packing<3> p = packing_;
      strain_sites(p.system, i, j, e);
      strain_box(p.system.box, i, j, e);
      p.field->evaluate(p.system, Detail::energies, out_);
      return out_.energy.elastic;
    };
    return -slope_at_zero(contacts, unfolded_.smooth_strain(i, j), 2) + shape_moment(i, j);
  }

 private:
  double shape_moment(int i, int j) {
    const auto shapes = [&](double e) {
      System<3> s = packing_.system;
      strain_sites(s, i, j, e);
      out_.force.assign(s.state.position.size(), {});
      out_.energy = {};
      packing_.field->terms().evaluate(s, Detail::energies, out_);
      return out_.energy.terms;
    };
    return -slope_at_zero(shapes, 0.005, 4);
  }

  Packing<3> packing_;
  UnfoldedCell unfolded_;
  Evaluation<3> out_;
};

}  // namespace supple::testing
