/// Pictures of a run file.
#pragma once
#include <cstdint>
#include <functional>
#include <string>

#include "supple/draw/page/snapshot.hpp"
#include "supple/io/run/images.hpp"
#include "supple/io/run/run_file.hpp"

namespace supple {

/// Draws frame k in the colours of the first frame, so that all pictures of a run agree. Throws an input
/// error where there is no such frame.
void draw_run_snapshot(const std::string& path, const RunFile& run, std::int64_t k,
                       SnapshotOptions options = {});

/// Draws frame k of any run. `color`: what deformable particles are coloured by (body_colors). Input error
/// where there is no such frame or colour.
void draw_frame(const std::string& path, const RunFile& run, std::int64_t k, const std::string& color = "");

/// Draws `images` frames of any run as numbered files in the folder: draw_run_images, draw_body_images.
std::int64_t draw_frames(const std::string& folder, const std::string& ending, const RunFile& run,
                         std::int64_t images,
                         const std::function<void(std::int64_t done, std::int64_t total)>& progress = {});

/// The stress figure: plot_oscillatory where moduli were found, else plot_dynamics. Throws an input error
/// where the run has no stress series.
void draw_run_plot(const std::string& path, const RunFile& run);

/// draw_images of the run's frames.
std::int64_t draw_run_images(const std::string& folder, const std::string& ending, const RunFile& run,
                             std::int64_t images, const SnapshotOptions& options = {},
                             const std::function<void(std::int64_t done, std::int64_t total)>& progress = {});

}  // namespace supple
