/// A mark in pictures says of which run they are, so that Supple replaces only pictures of the same run
/// unasked.
#pragma once
#include <string>

#include "supple/io/run/run_file.hpp"

namespace supple {

/// The mark of a run, "Supple run 0123456789abcdef": a digest of version, case, status, numbers and final
/// state. Runs with the same mark have the same bits, so that pictures of one are pictures of the other.
std::string mark_of(const RunFile& run);

/// Puts the mark into a picture: a text chunk of png, a comment of jpg and svg, a last comment line of pdf
/// and ps.
void mark_picture(const std::string& path, const std::string& mark);

/// Whether the file is a picture with this mark.
bool is_marked(const std::string& path, const std::string& mark);

}  // namespace supple
