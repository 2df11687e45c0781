/// Stress tensors of a sheared cell of discs.
#pragma once
#include "supple/model/evaluation.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// Stress tensors of one instant, compression positive; entry [i][j]: force along i, position along j. S1-x:
/// equations of the particleShear documentation. A is the area of the cell, F the force on the receiving
/// disc, l the vector from the acting to the receiving disc. The sample is the free discs. A contact is
/// internal if both its discs are free and meet without crossing a period of the cell; contacts with images
/// and with plate discs are external.
struct StressTensors {
  Mat2 love_weber;  ///< (1/A) sum F l^T over internal contacts (S1-19)
  Mat2 external;    ///< -(1/A) sum F r^T over external forces on the sample, r from the cell's centre (S1-16)
  Mat2 linear_acceleration;  ///< (1/A) sum m a r^T over the sample (S1-17); love_weber = external + this
  Mat2 otsuki;  ///< -(1/A) sum p p^T / m, momenta relative to the flow [Otsuki & Hayakawa 2017, eq. 15]
  Mat2 tangential_torque;  ///< (1/A) sum [[0, -T/2], [T/2, 0]] over all torques, also on plate discs (S1-22)
  Mat2 internal_torque;    ///< the same over torques from internal contacts (S1-24)
  Mat2 centrifugal;        ///< -(1/A) sum K 1, K = I w^2/2 of each disc of the sample (S1-21)
  Mat2 overall;            ///< love_weber + internal_torque + centrifugal: symmetric (S1-24)

  /// Love-Weber with the contacts across the period along the flow counted as internal: unlike love_weber it
  /// does not jump when a disc crosses that period.
  Mat2 love_weber_periodic;
  /// (1/A) sum F l^T over every contact, l from the nearest image. It does not depend on where the cell is
  /// cut. Plate discs count as matter of the cell like all others; the forces that drive the plates and
  /// kinetic terms are not in it.
  Mat2 virial;

  /// Shear stress that the plates exert on the sample: half the difference of the forces along the flow of
  /// the upper and the lower plate on the free discs, over the width of the cell. It does not depend on where
  /// the cell is cut; at rest it is the stress on every section along the flow. A contact counts for the
  /// plate on whose side of the cell its free disc is.
  double plates = 0;

  /// Numbers of elementary forces that the published package registers as internal and as external. Each
  /// contact has four on each of its free discs: central elastic, central viscous, and two halves of the
  /// tangential force.
  int pair_register = 0, external_register = 0;

  /// Mean normal stress of the sample, of the overall tensor.
  double pressure() const { return 0.5 * (overall[0][0] + overall[1][1]); }
  /// Shear stresses tau = -sigma_xy (S1-25).
  double shear_internal() const { return -overall[0][1]; }
  double shear_external() const { return -external[0][1]; }
  /// -sigma_xy of the symmetric part. With the torques of S1-22 a Love-Weber tensor of all contacts is
  /// symmetric, and this part is what remains.
  double shear_periodic() const { return -0.5 * (love_weber_periodic[0][1] + love_weber_periodic[1][0]); }
  double shear_virial() const { return -0.5 * (virial[0][1] + virial[1][0]); }
};

/// All tensors at the instant of `evaluation`; `unit` is one unit of stress of the run in Pa (Units::stress).
StressTensors stress_tensors(const System<2>& system, const Evaluation<2>& evaluation, double unit = 1);

}  // namespace supple
