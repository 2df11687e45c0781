/// The table "stress" of sheared bodies.
#pragma once
#include <vector>

#include "supple/experiment/packing_record.hpp"

namespace supple {

/// A row per step: of all shapes, contacts and links, compression positive, in pressure units; with `tensors`
/// every component of the virial. Keeps the series that demodulation needs.
class BodyStressTable {
 public:
  BodyStressTable(const Packing& packing, bool tensors, Recorder& recorder);
  /// One row; the evaluation holds energies. The rate is that of this instant.
  void append(const Evaluation<2>& evaluation, double strain_rate);

  std::vector<double> time, virial, total, pressures;

 private:
  /// sum m u_x u_y of this instant [energy]; the flow is that of the velocities, of half a step before.
  double kinetic_moment(const Evaluation<2>& evaluation) const;

  const Packing& packing_;
  bool tensors_;
  Recorder& recorder_;
};

}  // namespace supple
