/// A run of oscillatory shear in the text format of the published package particleShear 1.0.2 (its
/// documentation, Fig. S2-2, Tables S2-2 and S2-3), so that existing analysis reads it.
#pragma once
#include <string>

#include "supple/core/new_file.hpp"
#include "supple/io/run/run_file.hpp"

namespace supple {

/// Writes the case as the package's function call, constants and results, and the table "stress" if it has
/// tensors, with the labels, order and number style of the package; lengths in micrometre, masses in mg.
///
/// Needs of the run, besides case and discs:
///   constants (SI): mean_mass, link_spring_constant, time_constant, frequency, time_step, damping_factor,
///     and removed_link_fraction where links were removed at random
///   material (run's units): k, nu, k_t, nu_t, mu, permanent_ratio_central, permanent_ratio_tangential
///   results: in_phase_stress_internal, out_of_phase_stress_internal, storage_modulus_internal,
///     loss_modulus_internal, storage_modulus_external, loss_modulus_external
/// Throws a file error where one of them is missing (a run that did not finish has no results).
void export_published_text(const RunFile& run, const std::string& path, Existing existing = Existing::refuse);

/// The package's name for the file:
/// <folder>/dermal_filler[_bulk|_uncrosslinked]<mu>_f_<f>_strain_<A>_nr_<n>.txt, n the first that is free.
std::string published_text_path(const RunFile& run, const std::string& folder);

}  // namespace supple
