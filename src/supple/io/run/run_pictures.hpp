/// Pictures of a run file.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "supple/draw/solid/solid_snapshot.hpp"
#include "supple/io/run/run_file.hpp"

namespace supple {

/// What bodies can be coloured by: "id" (particles that touch get different colours), and the numbers that
/// frame k holds of each body.
std::vector<std::string> body_colors(const RunFile& run, std::int64_t k);

/// What pictures of a run show. `color` is one of body_colors(); empty: "id". `view` is a name or the angles
/// of a view (view_of) of a run in 3D; empty: "corner". `edges` are those of the triangles in 3D.
struct PictureChoice {
  std::string color = {}, view = {};
  TriangleEdges edges = TriangleEdges::hidden;
};

/// Draws frame k with the walls that stand at that instant. All pictures of a run by "id" have the same
/// colours, chosen so that bodies that touch in its first or last frame differ. Throws an input error where
/// there is no such frame, colour or view, or a view or edges of triangles are asked for of a run in 2D.
void draw_frame(const std::string& path, const RunFile& run, std::int64_t k,
                const PictureChoice& choice = {});

/// The frame of image k, where `images` images are spread over the frames from the first to the last.
std::int64_t frame_of_image(std::int64_t k, std::int64_t images, std::int64_t frames);

/// Draws `images` evenly spaced frames, first and last included (all where there are fewer), as
/// FOLDER/image0000000.ENDING, ... on equal pages with one scale of forces and, of a colour, one scale of
/// that; periodic cells, which may shrink, fill the page. `progress` (may be empty) hears how many are done,
/// none while frames are looked over for their scales; it may throw. Returns how many were drawn. Throws an
/// input error for an unknown ending or a run without frames, a file error where it cannot write.
std::int64_t draw_frames(const std::string& folder, const std::string& ending, const RunFile& run,
                         std::int64_t images, const PictureChoice& choice = {},
                         const std::function<void(std::int64_t done, std::int64_t total)>& progress = {});

/// Draws stress against time: plot_oscillatory() where moduli were found, else plot_dynamics(). Throws an
/// input error where the run has no series of stress.
void draw_run_plot(const std::string& path, const RunFile& run);

}  // namespace supple
