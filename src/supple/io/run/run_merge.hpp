/// One file from the segments of a run.
#pragma once
#include <string>

#include "supple/core/new_file.hpp"
#include "supple/io/run/run_file.hpp"

namespace supple {

/// Writes all segments of `run` as one run file `path`, with this status. The file is put together in memory.
/// Throws file errors; the segments stay as they are.
void save_merged(const RunFile& run, const std::string& status, const std::string& path, Existing existing);

}  // namespace supple
