/// Pictures of deformable particles in a run.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "supple/draw/page/polygon_snapshot.hpp"
#include "supple/io/run/run_file.hpp"

namespace supple {

/// What bodies can be coloured by: "id" (those that touch differ), and the numbers that frame k keeps of each
/// body.
std::vector<std::string> body_colors(const RunFile& run, std::int64_t k);

/// Draws frame k with the walls that stand then. `color`: one of body_colors; empty: "id". Throws an input
/// error where there is no such frame or colour.
void draw_body_snapshot(const std::string& path, const RunFile& run, std::int64_t k,
                        const std::string& color = "");

/// Draws `images` evenly spaced frames, first and last included (all where there are fewer), as
/// FOLDER/image0000000.ENDING, ... on equal pages with one scale of forces and, of a `color`, one scale of
/// that; periodic cells, which may shrink, fill the page. `progress` (may be empty) hears how many are done.
/// Returns how many were drawn.
std::int64_t draw_body_images(
    const std::string& folder, const std::string& ending, const RunFile& run, std::int64_t images,
    const std::string& color = "",
    const std::function<void(std::int64_t done, std::int64_t total)>& progress = {});

}  // namespace supple
