/// Numbered pictures of a whole run, for films.
#pragma once
#include <cstdint>
#include <functional>
#include <string>

#include "supple/draw/page/snapshot.hpp"

namespace supple {

/// Frame k, 0 <= k < count, of a run that need not fit in memory.
struct FrameSource {
  std::int64_t count;
  std::function<Frame(std::int64_t)> frame;
};

/// Frame of image k: the images are spread over the frames from the first to the last.
std::int64_t frame_of_image(std::int64_t k, std::int64_t images, std::int64_t frames);

/// Draws `images` evenly spaced frames, first and last included (all frames if there are fewer), as
/// FOLDER/image0000000.ENDING, image0000001.ENDING, ... on equal pages with one scale of forces and one
/// colour for each particle throughout. `progress` (may be empty) hears how many are done. Returns how many
/// were drawn. Throws an input error for an unknown ending or a run without frames, a file error where it
/// cannot write.
std::int64_t draw_images(const std::string& folder, const std::string& ending, const RunInfo& info,
                         const FrameSource& frames, std::int64_t images, SnapshotOptions options = {},
                         const std::function<void(std::int64_t done, std::int64_t total)>& progress = {});

}  // namespace supple
