/// Results of an oscillatory run: moduli by every estimator, contacts, pressure.
#pragma once
#include "supple/experiment/stress_table.hpp"
#include "supple/observe/demodulate.hpp"

namespace supple {

/// Values in the group "results": storage_modulus_X, loss_modulus_X, ... for X = internal, external,
/// external_corrected, periodic, virial. Warns where |G*| of the internal and the external stress differ by more than
/// 30 %.
void record_moduli(const StressTable& table, const Protocol& protocol, DriftCorrection correction, Recorder& recorder);

/// Contacts, links and plate discs at the end.
void record_counts(const System<2>& system, const Evaluation<2>& evaluation, Recorder& recorder);

}  // namespace supple
