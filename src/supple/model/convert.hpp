/// A system in other units.
#pragma once
#include <vector>

#include "supple/core/error.hpp"
#include "supple/model/quantities.hpp"

namespace supple {

namespace detail {

/// Numbers without a unit: counts, codes and places in tables.
template <class T>
void scale(T&, double) {}

inline void scale(double& x, double factor) { x *= factor; }
template <int Dim>
void scale(Vec<Dim>& x, double factor) {
  x *= factor;
}
template <int Dim>
void scale(Mat<Dim>& x, double factor) {
  x *= factor;
}
template <class T>
void scale(std::vector<T>& values, double factor) {
  for (T& x : values) scale(x, factor);
}
template <class Struct>
void convert_all(Struct& values, const Units& from, const Units& to) {
  for_each_quantity(values, [&](const auto& quantity, auto& value) {
    if (const double factor = from.of(quantity.unit) / to.of(quantity.unit); factor != 1)
      scale(value, factor);
  });
}

}  // namespace detail

/// Multiplies every quantity of the system by the ratio of its units (model/quantities.hpp). Input error
/// where terms act on whole bodies: their numbers have no units.
template <int Dim>
void convert(System<Dim>& system, const Units& from, const Units& to) {
  if (!system.terms.empty())
    throw input_error("the " + system.terms[0].name + " of particles", "it has no units to convert from",
                      "keep the units of the state");
  detail::convert_all(system, from, to);
  detail::convert_all(system.box, from, to);
  detail::convert_all(system.state, from, to);
  detail::convert_all(system.acceleration, from, to);
  detail::convert_all(system.shape, from, to);
  for (ShapeStiffness& stiffness : system.shape.stiffness) detail::convert_all(stiffness, from, to);
  detail::convert_all(system.solid, from, to);
  for (SolidStiffness& stiffness : system.solid.stiffness) detail::convert_all(stiffness, from, to);
  detail::convert_all(system.rigid, from, to);
  detail::scale(system.pairs.history, from.of(meaning_of_history.unit) / to.of(meaning_of_history.unit));
  for (Touch& touch : system.touches.rows) detail::convert_all(touch, from, to);
  for (Link& link : system.links) detail::convert_all(link, from, to);
  detail::scale(system.floor_contact, from.of(meaning_of_floor.unit) / to.of(meaning_of_floor.unit));
}

}  // namespace supple
