#include "supple/io/run/images.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "supple/core/error.hpp"
#include "supple/draw/canvas/canvas.hpp"
#include "supple/draw/scene/cell_scene.hpp"
#include "supple/draw/scene/particle_colors.hpp"

namespace supple {

namespace {

/// Completes what the options leave open so that it holds for all images.
void settle(SnapshotOptions& options, const RunInfo& info, const FrameSource& frames, std::int64_t images) {
  const bool choose_force = options.full_force <= 0;
  for (std::int64_t k = 0; k < images; ++k) {
    const Frame frame = frames.frame(frame_of_image(k, images, frames.count));
    options.strain_room =
        std::max(options.strain_room, std::abs(drawn_strain(sheared(info.box, frame.strain))));
    if (choose_force) options.full_force = std::max(options.full_force, strongest_force(info, frame));
    if (options.color.empty()) options.color = disc_colors(info, frame);
  }
}

}  // namespace

std::int64_t frame_of_image(std::int64_t k, std::int64_t images, std::int64_t frames) {
  if (images == 1) return frames - 1;
  return std::llround(static_cast<double>(k) * static_cast<double>(frames - 1) /
                      static_cast<double>(images - 1));
}

std::int64_t draw_images(const std::string& folder, const std::string& ending, const RunInfo& info,
                         const FrameSource& frames, std::int64_t images, SnapshotOptions options,
                         const std::function<void(std::int64_t, std::int64_t)>& progress) {
  picture_format("image." + ending);
  if (frames.count < 1) throw input_error("cannot draw images", "the run has no frames", "set output.frames");
  images = std::clamp<std::int64_t>(images, 1, frames.count);
  settle(options, info, frames, images);
  for (std::int64_t k = 0; k < images; ++k) {
    const std::string path = fmt::format("{}/image{:07}.{}", folder, k, ending);
    draw_snapshot(path, info, frames.frame(frame_of_image(k, images, frames.count)), options);
    if (progress) progress(k + 1, images);
  }
  return images;
}

}  // namespace supple
