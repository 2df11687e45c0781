#include "supple/model/sanity.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "supple/core/error.hpp"

namespace supple {

namespace {

constexpr double farthest = 1e9;  ///< in radii of the smallest site
constexpr double widest = 1e7;    ///< radius, in radii of the smallest site

template <int Dim>
class Judge {
 public:
  Judge(const System<Dim>& system, const std::string& what) : system_(system), what_(what) {}

  [[noreturn]] void refuse(const std::string& problem, const std::string& why) const {
    throw input_error(fmt::format("{} cannot be computed with: {}", what_, problem), why,
                      "look for a wrong unit or a damaged number");
  }

  void size(double x, const std::string& name) const {
    if (!is_computable(x))
      refuse(fmt::format("{} is {:.6g}", name, x),
             fmt::format("numbers are from {:g} to {:g} here", least_number, most_number));
  }
  void positive_size(double x, const std::string& name) const {
    if (!(x > 0)) refuse(fmt::format("{} is {:.6g}", name, x), "it must be positive");
    size(x, name);
  }
  void sizes(std::span<const double> values, const char* name) const {
    for (std::size_t i = 0; i < values.size(); ++i)
      if (!is_computable(values[i])) size(values[i], fmt::format("{} {}", name, i));
  }
  void positive_sizes(std::span<const double> values, const char* name) const {
    for (std::size_t i = 0; i < values.size(); ++i)
      if (!(values[i] > 0 && is_computable(values[i])))
        positive_size(values[i], fmt::format("{} {}", name, i));
  }
  /// Tensors, of which the diagonal is positive.
  void positive_sizes(const std::vector<Mat<3>>& values, const char* name) const {
    for (std::size_t i = 0; i < values.size(); ++i)
      for (int d = 0; d < 3; ++d) {
        positive_size(values[i][d][d], fmt::format("{} {}", name, i));
        for (int e = 0; e < d; ++e) size(values[i][d][e], fmt::format("{} {}", name, i));
      }
  }
  template <int D>
  void sizes(const std::vector<Vec<D>>& values, const char* name) const {
    for (std::size_t i = 0; i < values.size(); ++i)
      for (int d = 0; d < D; ++d)
        if (!is_computable(values[i][d])) size(values[i][d], fmt::format("{} {}", name, i));
  }

  void cell() const {
    constexpr const char* names[] = {"its width", "its height", "its depth"};
    for (int d = 0; d < Dim; ++d) positive_size(system_.box.length[d], names[d]);
    size(system_.box.strain, "its strain");
    size(system_.box.strain_rate, "its strain rate");
    size(system_.time, "its time");
  }

  void sites() const {
    const State<Dim>& s = system_.state;
    if (s.size() == 0) refuse("it holds no particle", "there is nothing to move");
    positive_sizes(s.radius, "the radius of site");
    positive_sizes(s.mass, "the mass of site");
    sizes(s.inertia, "the inertia of site");
    sizes(s.position, "the position of site");
    sizes(s.velocity, "the velocity of site");
    sizes(s.angle, "the angle of site");
    sizes(s.spin, "the spin of site");
  }

  void extents() const {
    const State<Dim>& s = system_.state;
    const auto [least, most] = std::minmax_element(s.radius.begin(), s.radius.end());
    if (*most > widest * *least)
      refuse(fmt::format("radii are from {:.6g} to {:.6g}", *least, *most),
             fmt::format("the largest may be {:g} of the smallest", widest));
    const double reach = farthest * *least;
    const auto within = [&](const Vec<Dim>& x) {
      return std::all_of(x.e, x.e + Dim, [&](double c) { return std::abs(c) <= reach; });
    };
    const std::string why = fmt::format(
        "beyond {:g} radii of the smallest site, {:.6g}, contacts would not be resolved", farthest, reach);
    if (!within(system_.box.length))
      refuse(fmt::format("its cell is {:.6g}", fmt::join(system_.box.length.e, " x ")), why);
    if (std::abs(system_.box.lattice().shift) > reach)
      refuse(fmt::format("its strain is {:.6g}", system_.box.strain), why);
    for (std::size_t i = 0; i < s.position.size(); ++i)
      if (!within(s.position[i]))
        refuse(fmt::format("site {} lies at ({:.6g})", i, fmt::join(s.position[i].e, ", ")), why);
  }

  void shapes() const {
    const Shape& shape = system_.shape;
    for (std::size_t b = 0; b < shape.stiffness.size(); ++b) {
      const ShapeStiffness& k = shape.stiffness[b];
      for (const double x : {k.volume, k.facet, k.hinge, k.tension})
        if (!is_computable(x)) size(x, fmt::format("a stiffness of particle {}", b));
    }
    sizes(shape.rest_volume,
          Dim == 2 ? "the preferred area of particle" : "the preferred volume of particle");
    positive_sizes(shape.rest_facet,
                   Dim == 2 ? "the preferred length of edge" : "the preferred area of triangle");
    sizes(shape.rest_hinge, Dim == 2 ? "the preferred angle of corner" : "the preferred angle of edge");
    for (std::size_t b = 0; b < system_.solid.stiffness.size(); ++b) {
      const SolidStiffness& k = system_.solid.stiffness[b];
      for (const double x : {k.bond, k.lambda, k.mu})
        if (!is_computable(x)) size(x, fmt::format("a stiffness of solid {}", b));
    }
    positive_sizes(system_.solid.rest_bond, "the preferred length of bond");
    for (const Mat<Dim>& inverse : system_.solid.rest_element)
      positive_size(determinant(inverse), "the preferred size of an element");
    for (const BodyTermData& term : system_.terms)
      sizes(term.number, fmt::format("the {} of particles, number", term.name).c_str());
    const RigidBodiesOf<Dim>& r = system_.rigid;
    positive_sizes(r.mass, "the mass of rigid particle");
    positive_sizes(r.inertia, "the inertia of rigid particle");
    for (const auto* vectors : {&r.centre, &r.velocity, &r.offset})
      sizes(*vectors, "a vector of rigid particle");
    for (const auto* numbers : {&r.angle, &r.spin}) sizes(*numbers, "an angle or spin of rigid particle");
    sizes(system_.pairs.history, "the elongation of contact");
  }

  void energy() const {
    const State<Dim>& s = system_.state;
    double sum = 0;
    for (std::size_t i = 0; i < s.velocity.size(); ++i) sum += s.mass[i] * dot(s.velocity[i], s.velocity[i]);
    if (!(0.5 * sum <= most_number))
      refuse(fmt::format("its kinetic energy is {:.6g}", 0.5 * sum), "it is too much");
  }

 private:
  const System<Dim>& system_;
  const std::string& what_;
};

}  // namespace

template <int Dim>
void require_sane(const System<Dim>& system, const std::string& what) {
  const Judge<Dim> judge(system, what);
  judge.cell();
  judge.sites();
  judge.extents();
  judge.shapes();
  judge.energy();
}

template void require_sane(const System<2>&, const std::string&);
template void require_sane(const System<3>&, const std::string&);

}  // namespace supple
