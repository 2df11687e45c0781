/// Bodies as wholes: where they are, and how to move them.
#pragma once
#include "supple/model/rigid.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// Mean position of the sites of body b, each counted alike [length].
template <int Dim>
Vec<Dim> body_centre(const System<Dim>& system, int b);

/// Radius of the circle (3D: sphere) about body_centre(b) that holds the discs (spheres) of all sites of body
/// b [length].
template <int Dim>
double outer_radius(const System<Dim>& system, int b);

/// Displaces body b, rigid or not, by `move` [length].
template <int Dim>
void move_body(System<Dim>& system, int b, const Vec<Dim>& move);

/// Turns body b, rigid or not, by an angle (3D: a rotation vector) [radian], about its centre of mass where
/// it is rigid, else about body_centre().
template <int Dim>
void turn_body(System<Dim>& system, int b, const Angular<Dim>& by);

/// Multiplies the lengths of the cell by `factor`, by direction; bodies move with their centres and keep
/// their shapes.
template <int Dim>
void scale_cell(System<Dim>& system, const Vec<Dim>& factor);
/// The same, all lengths alike.
template <int Dim>
void scale_cell(System<Dim>& system, double factor) {
  Vec<Dim> all;
  for (int d = 0; d < Dim; ++d) all[d] = factor;
  scale_cell(system, all);
}

}  // namespace supple
