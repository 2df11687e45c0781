/// Pictures of a run file.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "supple/io/run/run_file.hpp"

namespace supple {

/// What bodies can be coloured by: "id" (particles that touch get different colours), and the numbers that
/// frame k holds of each body.
std::vector<std::string> body_colors(const RunFile& run, std::int64_t k);

/// Draws frame k with the walls that stand at that instant. `color` is one of body_colors(); empty: "id". All
/// pictures of a run by "id" have the same colours, chosen so that bodies that touch in its first or last
/// frame differ. Throws an input error where there is no such frame or colour.
void draw_frame(const std::string& path, const RunFile& run, std::int64_t k, const std::string& color = "");

/// The frame of image k, where `images` images are spread over the frames from the first to the last.
std::int64_t frame_of_image(std::int64_t k, std::int64_t images, std::int64_t frames);

/// Draws `images` evenly spaced frames, first and last included (all where there are fewer), as
/// FOLDER/image0000000.ENDING, ... on equal pages with one scale of forces and, of a `color`, one scale of
/// that; periodic cells, which may shrink, fill the page. `progress` (may be empty) hears how many are done,
/// none while frames are looked over for their scales; it may throw. Returns how many were drawn. Throws an
/// input error for an unknown ending or a run without frames, a file error where it cannot write.
std::int64_t draw_frames(const std::string& folder, const std::string& ending, const RunFile& run,
                         std::int64_t images, const std::string& color = "",
                         const std::function<void(std::int64_t done, std::int64_t total)>& progress = {});

/// Draws stress against time: plot_oscillatory() where moduli were found, else plot_dynamics(). Throws an
/// input error where the run has no series of stress.
void draw_run_plot(const std::string& path, const RunFile& run);

}  // namespace supple
