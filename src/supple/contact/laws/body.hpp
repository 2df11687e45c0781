/// The law of contacts between bodies of many sites: any elastic law, with the spring of the two sites.
#pragma once
#include <utility>

#include "supple/contact/laws/harmonic.hpp"
#include "supple/contact/laws/list.hpp"

namespace supple {

/// One law by its type, for loops: sigma is where the surfaces of the two sites meet [length].
template <class Elastic>
struct LawOfSites {
  Harmonic scale;
  Elastic elastic;

  double range() const { return range_of(elastic); }
  double energy(double r, double sigma) const { return elastic.energy(r, sigma, scale.spring(sigma)); }
  /// -dU/dr, positive: repulsion.
  double force(double r, double sigma) const { return elastic.force(r, sigma, scale.spring(sigma)); }
  /// d2U/dr2.
  double stiffness(double r, double sigma) const { return elastic.stiffness(r, sigma, scale.spring(sigma)); }
};

/// Callers ask only for r < range() sigma.
class BodyLaw {
 public:
  BodyLaw(const Harmonic& scale, Repulsion elastic = Linear())
      : scale_(scale), elastic_(std::move(elastic)) {}

  /// visit(LawOfSites) of the law that it is.
  template <class Visit>
  auto visit(const Visit& visitor) const {
    return std::visit(
        [&]<class Elastic>(const Elastic& elastic) {
          return visitor(LawOfSites<Elastic>{scale_, elastic});
        },
        elastic_);
  }
  /// k of these two sites, by which the law is multiplied [force/length].
  double spring(double sigma) const { return scale_.spring(sigma); }
  double range() const { return range_of(elastic_); }
  bool attracts() const { return range() > 1; }
  bool is_harmonic() const { return std::holds_alternative<Linear>(elastic_); }
  double energy(double r, double sigma) const {
    return visit([&](const auto& law) { return law.energy(r, sigma); });
  }
  double force(double r, double sigma) const {
    return visit([&](const auto& law) { return law.force(r, sigma); });
  }
  double stiffness(double r, double sigma) const {
    return visit([&](const auto& law) { return law.stiffness(r, sigma); });
  }

  const Harmonic& scale() const { return scale_; }
  /// The same law, so many times as stiff.
  BodyLaw stiffer(double factor) const {
    BodyLaw law = *this;
    law.scale_.stiffness *= factor;
    return law;
  }

 private:
  Harmonic scale_;
  Repulsion elastic_;
};

}  // namespace supple
