/// The area of a polygon with discs at its vertices where nothing but neighbours meets: a closed form.
#pragma once
#include <optional>
#include <span>

#include "supple/observe/body_shapes.hpp"

namespace supple {

/// Area that a lone ring covers, counter-clockwise and of one radius [length^2]: that of packing_fraction(),
/// in time proportional to its vertices. Nothing where vertices do not follow each other in angle about their
/// mean, or where more than neighbours may meet; it never guesses.
std::optional<double> plain_area(std::span<const Vec2> ring, double radius, Outline outline);

}  // namespace supple
