/// What the theory of elasticity says of a cylinder and of a ball between two flat, rigid, frictionless
/// plates. Compressions are delta/D: how much the plates have come nearer, over the diameter.
#pragma once

namespace supple {

/// Compression of a disc in two dimensions, or of a long cylinder across its axis, under the force `force` =
/// F/(E' D) of the plates, F per length of the cylinder:
///     delta/D = (2/pi) f (ln(2 pi/f) - 1),   f = F/(E' D).
/// E' is the plane modulus [energy/length^2]: of a sheet, and of particles in 2D, their own Young's modulus E
/// (no 1 - nu^2: nothing acts across the sheet); of a long cylinder E/(1 - nu^2). Each contact is Hertz's,
/// half as wide as a with a^2 = 4 F R/(pi E'); the strain from there to the centre, with the stress of the
/// opposite contact and the tension F/(pi R) that frees the round boundary from load, brings delta/2 = (F/(pi
/// E')) (2 ln(4 R/a) - 1) [Johnson, Contact Mechanics (1985), eq. 5.57], where nu drops out up to (a/R)^2.
/// For 0 < f << 1; NaN from f = 2 pi/e^2 on, where the formula turns back.
double cylinder_compression(double force);
/// The force f of this compression, the inverse of cylinder_compression(). 0 at 0; NaN where there is none.
double cylinder_force(double compression);

/// The same as MacKeith et al. (2025) print it (9.14), for a cylinder of length D:
///     delta/D = (4/pi) f (1 + ln(pi/f)),   f = F (1 - nu^2)/(E D^2).
/// It takes each contact for a line on a half space as long as the cylinder [Puttock and Thwaite, CSIRO
/// (1969)], where rigid plates would halve the factor. It is here for comparison.
double printed_cylinder_compression(double force);

/// Force F (1 - nu^2)/(E D^2) = (1/3) (delta/D)^1.5 of a ball: two contacts of Hertz, F = (4/3) E/(1 - nu^2)
/// sqrt(D/2) (delta/2)^1.5 each [Johnson (1985), eq. 4.23]. For small compressions.
double ball_force(double compression);

}  // namespace supple
