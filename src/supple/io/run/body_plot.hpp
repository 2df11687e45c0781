/// The figures of runs of deformable particles.
#pragma once
#include <string>

#include "supple/experiment/case.hpp"
#include "supple/io/run/run_file.hpp"

namespace supple {

/// What the figure of a case shows, as a word for the name of its file: "pressure", "energy" or "force".
std::string body_plot_subject(const Case& c);

/// jamming: pressure against packing fraction near the end of the search. compression: the same of both
/// branches, with the lines that were fitted. uniaxial_compression: force on the wall and contacts against
/// strain. dynamics, slump: energies against time, and the pressure or the reach of the heap. Throws an input
/// error where the run holds less than two rows of its table, and file errors.
void draw_body_plot(const std::string& path, const RunFile& run);

}  // namespace supple
