/// The table "stress" of sheared bodies.
#pragma once
#include <vector>

#include "supple/experiment/packing_record.hpp"

namespace supple {

/// A row per step: the stress of all shapes, contacts and links, compression positive, in pressure units;
/// with `tensors`, every component of the virial. Keeps the series that demodulation needs.
class BodyStressTable {
 public:
  BodyStressTable(const Packing& packing, bool tensors, Recorder& recorder);
  /// Adds a row. The evaluation must hold energies; the strain rate is that of its instant [1/time].
  void append(const Evaluation<2>& evaluation, double strain_rate);

  std::vector<double> time, virial, total, pressures;
  std::vector<double> plates;  ///< empty where there were no plates at first

 private:
  /// sum m u_x u_y at the instant of the forces [energy], u relative to the flow of the box (that of half a
  /// step before). Rigid bodies count as wholes, as in their virial: what they turn with is no stress in the
  /// mean, as the forces that keep them together cancel it.
  double kinetic_moment(const Evaluation<2>& evaluation) const;

  const Packing& packing_;
  bool tensors_, has_plates_;
  Recorder& recorder_;
};

}  // namespace supple
