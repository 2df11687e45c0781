/// Rotations in 3D by rotation vectors: along the axis, as long as the angle [radian], counter-clockwise as
/// seen from the tip.
#pragma once
#include "supple/core/vec.hpp"

namespace supple {

/// The matrix R(q) of a rotation, which takes x to x + a q x x + b q x (q x x), a = sin|q|/|q| and b = (1 -
/// cos|q|)/|q|^2 [Rodrigues 1840]. It is a rotation to rounding for every q.
Mat<3> rotation(const Vec3& q);

/// T(q) of w = T(q) dq/dt, the angular velocity of R(q): dR/dt R^T = [w x]. T(q) x = x + b q x x + c q x (q x
/// x), c = (|q| - sin|q|)/|q|^3. It has an inverse for |q| < 2 pi, and changes lengths by 0.64 at least for
/// |q| <= pi.
Mat<3> turning(const Vec3& q);

/// The derivatives of T(q)^T m for a fixed vector m: element [k][l] is d(column k of T . m)/dq_l.
Mat<3> turning_slope(const Vec3& q, const Vec3& m);

/// The shortest vector of the same rotation, at most pi long; q itself where it is short enough.
Vec3 shortest(const Vec3& q);

/// The rotation vector, at most pi long, of two rotations, one after the other.
Vec3 combined(const Vec3& first, const Vec3& second);

/// x of m x = v. Not numbers where m has no inverse.
Vec3 solution(const Mat<3>& m, const Vec3& v);

/// m0 in a frame that is turned by the rotation R: R m0 R^T.
Mat<3> turned(const Mat<3>& m0, const Mat<3>& rotation);

}  // namespace supple
