/// Pictures of JPEG.
#pragma once
#include <string>

#include "supple/draw/canvas/pixel_rows.hpp"

namespace supple {

/// Bytes of a JPEG file of quality 92. Throws a file error where it cannot be.
std::string encode_jpeg(const PixelRows& pixels);

}  // namespace supple
