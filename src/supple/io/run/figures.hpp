/// The figures of runs: which one is drawn is said by the experiment (Figure).
#pragma once
#include <string>
#include <string_view>

#include "supple/experiment/experiments.hpp"
#include "supple/io/run/run_file.hpp"

namespace supple {

/// A word for the name of the file of a figure: "stress", "pressure", "force", "energy" or "friction".
std::string_view figure_subject(Figure figure);

/// Draws the figure of the run's experiment. Throws an input error where the experiment has none or the table
/// that it shows has less than two rows, and file errors.
void draw_figure(const std::string& path, const RunFile& run);

}  // namespace supple
