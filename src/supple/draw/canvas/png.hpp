/// Pictures of PNG (ISO/IEC 15948).
#pragma once
#include <string>
#include <string_view>

#include "supple/draw/canvas/pixel_rows.hpp"

namespace supple {

/// A chunk: its length, its type, these bytes, and their check.
std::string png_chunk(const std::string& type, std::string_view data);

/// Bytes of a PNG file with these very colours, eight bits each; the same bytes each time. Throws a file
/// error where it cannot be.
std::string encode_png(const PixelRows& pixels);

}  // namespace supple
