/// The table "stress" of sheared bodies.
#pragma once
#include <string>
#include <vector>

#include "supple/experiment/packing_record.hpp"

namespace supple {

/// A row per step: the stress of all shapes, contacts and links, compression positive, in pressure units;
/// with `tensors`, every component of the virial.
class BodyStressTable {
 public:
  BodyStressTable(const Packing<2>& packing, bool tensors, Recorder& recorder);
  /// Adds a row. The evaluation must hold energies; the strain rate is that of its instant [1/time].
  void append(const Evaluation<2>& evaluation, double strain_rate);

  /// A column of the table so far, one value a row.
  std::vector<double> column(const std::string& name) const { return recorder_.column("stress", name); }
  /// Whether there were plates at first.
  bool has_plates() const { return has_plates_; }

  void keep(Keeper& k) { k("has_plates", has_plates_); }

 private:
  /// sum m u_x u_y at the instant of the forces [energy], u relative to the flow of the box (that of half a
  /// step before). Rigid bodies count as wholes, as in their virial: what they turn with is no stress in the
  /// mean, as the forces that keep them together cancel it.
  double kinetic_moment(const Evaluation<2>& evaluation) const;

  const Packing<2>& packing_;
  bool tensors_, has_plates_;
  Recorder& recorder_;
};

}  // namespace supple
