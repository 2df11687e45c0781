/// What lies at a path, asked so that every answer is a value or a file error.
#pragma once
#include <string>

namespace supple {

/// `pipe`: of a shell, such as <(command). `other`: a device or a socket, which no file is read from or
/// written to.
enum class PathKind { nothing, file, folder, pipe, other };

/// Links are followed. Throws a file error where it cannot be told: a name too long, a folder that may not be
/// entered.
PathKind path_kind(const std::string& path);

/// Throws a file error unless `path` is a file that may be read; `kind` says what was wanted, "a state".
void check_can_read(const std::string& path, const std::string& kind);

/// Makes a folder where there is none. Throws a file error where it cannot be made, or is something else.
void make_folder(const std::string& path);

/// All bytes of a file or pipe. Throws a file error, as above, or where it is longer than `most` bytes.
std::string read_whole_file(const std::string& path, const std::string& kind, std::size_t most);

}  // namespace supple
