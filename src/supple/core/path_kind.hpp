/// What lies at a path. Every answer is a value or a file error, never an exception of the standard library.
#pragma once
#include <string>

namespace supple {

/// `pipe`: such as a shell makes for <(command). `other`: a device or a socket, which we neither read nor
/// write.
enum class PathKind { nothing, file, folder, pipe, other };

/// The kind of what `path` names; links are followed. Throws a file error where the system cannot tell: a
/// name too long, a folder that may not be entered.
PathKind path_kind(const std::string& path);

/// Throws a file error unless `path` is a file that may be read. `kind` names what was wanted, such as "a
/// state".
void check_can_read(const std::string& path, const std::string& kind);

/// Makes the folder if there is none. Throws a file error where it cannot be made, or `path` is something
/// else.
void make_folder(const std::string& path);

/// All bytes of a file or pipe. Throws as check_can_read does, and where there are more than `most` bytes.
std::string read_whole_file(const std::string& path, const std::string& kind, std::size_t most);

}  // namespace supple
