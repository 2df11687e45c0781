/// The figures of runs: what their experiment says that is drawn.
#pragma once
#include <string>
#include <string_view>

#include "supple/experiment/experiments.hpp"
#include "supple/io/run/run_file.hpp"

namespace supple {

/// A word for the name of its file: "stress", "pressure", "force" or "energy".
std::string_view figure_subject(Figure figure);

/// Draws the figure of the run's experiment. Throws an input error where it has none or the run holds less
/// than two rows of its table, and file errors.
void draw_figure(const std::string& path, const RunFile& run);

}  // namespace supple
