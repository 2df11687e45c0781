/// Bodies as wholes: where they are, and how to move them.
#pragma once
#include "supple/model/rigid.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// Mean position of the sites of body b, each counted alike [length].
Vec2 body_centre(const System<2>& system, int b);

/// Radius of the circle about body_centre(b) that holds the discs of all sites of body b [length].
double outer_radius(const System<2>& system, int b);

/// Displaces body b, rigid or not, by `move` [length].
void move_body(System<2>& system, int b, const Vec2& move);

/// Multiplies the lengths of the cell by `factor`, along x and y; bodies move with their centres and keep
/// their shapes.
void scale_cell(System<2>& system, const Vec2& factor);

}  // namespace supple
