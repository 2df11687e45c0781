/// Bodies as wholes: where they are, and moving them.
#pragma once
#include "supple/model/rigid.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// Mean position of the sites of body b.
Vec2 body_centre(const System<2>& system, int b);

/// Radius of the circle about that point that holds all discs of body b [length].
double outer_radius(const System<2>& system, int b);

/// Moves body b, rigid or not.
void move_body(System<2>& system, int b, const Vec2& move);

/// Scales the lengths of the cell; bodies move with their centres and keep their shapes.
void scale_cell(System<2>& system, const Vec2& factor);

}  // namespace supple
