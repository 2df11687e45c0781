/// The law of contacts between bodies of many sites: any elastic law, with the spring constant of Harmonic.
#pragma once
#include <utility>

#include "supple/contact/laws/harmonic.hpp"
#include "supple/contact/laws/list.hpp"

namespace supple {

/// The law with a known type, for fast loops. sigma is the distance at which the surfaces of the two sites
/// meet [length].
template <class Elastic>
struct LawOfSites {
  Harmonic scale;
  Elastic elastic;

  double range() const { return range_of(elastic); }
  double energy(double r, double sigma) const { return elastic.energy(r, sigma, scale.spring(sigma)); }
  /// -dU/dr [force]; positive: repulsion.
  double force(double r, double sigma) const { return elastic.force(r, sigma, scale.spring(sigma)); }
  /// d2U/dr2 [energy/length^2].
  double stiffness(double r, double sigma) const { return elastic.stiffness(r, sigma, scale.spring(sigma)); }
};

/// The law with any elastic law. Its functions may be called only with r < range() sigma.
class BodyLaw {
 public:
  BodyLaw(const Harmonic& scale, Repulsion elastic = Linear())
      : scale_(scale), elastic_(std::move(elastic)) {}

  /// Calls visitor(LawOfSites) with the law in its own type.
  template <class Visit>
  auto visit(const Visit& visitor) const {
    return std::visit(
        [&]<class Elastic>(const Elastic& elastic) {
          return visitor(LawOfSites<Elastic>{scale_, elastic});
        },
        elastic_);
  }
  /// The spring constant of two sites, to which the law is proportional [force/length].
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
  /// The same law, `factor` times as stiff.
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
