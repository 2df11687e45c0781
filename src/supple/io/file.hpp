/// Writing a file as a whole.
#pragma once
#include <string>
#include <string_view>

namespace supple {

/// Writes `bytes` under a temporary name beside `path` and renames it, so that no reader ever sees half a file and
/// a failure leaves what was there. Throws a file error.
void write_whole_file(const std::string& path, std::string_view bytes);

}  // namespace supple
