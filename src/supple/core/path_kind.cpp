#include "supple/core/path_kind.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "supple/core/error.hpp"

namespace supple {

namespace {

Error cannot_read(const std::string& path, const std::string& kind, const std::string& why) {
  return file_error("cannot read " + kind + " '" + path + "'", why);
}

/// Where it can be read: whether its end is known.
PathKind readable_kind(const std::string& path, const std::string& kind) {
  const PathKind found = path_kind(path);
  if (found == PathKind::nothing) throw cannot_read(path, kind, std::strerror(ENOENT));
  if (found == PathKind::folder) throw cannot_read(path, kind, "it is a folder");
  if (found == PathKind::other) throw cannot_read(path, kind, "it is a device, not a file");
  if (access(path.c_str(), R_OK) != 0) throw cannot_read(path, kind, std::strerror(errno));
  return found;
}

}  // namespace

PathKind path_kind(const std::string& path) {
  struct stat info {};
  if (stat(path.c_str(), &info) != 0) {
    if (errno == ENOENT || errno == ENOTDIR) return PathKind::nothing;
    throw file_error("cannot use the path '" + path.substr(0, 200) + (path.size() > 200 ? "..." : "") + "'",
                     std::strerror(errno));
  }
  if (S_ISREG(info.st_mode)) return PathKind::file;
  if (S_ISDIR(info.st_mode)) return PathKind::folder;
  return S_ISFIFO(info.st_mode) ? PathKind::pipe : PathKind::other;
}

void check_can_read(const std::string& path, const std::string& kind) {
  if (readable_kind(path, kind) == PathKind::pipe) throw cannot_read(path, kind, "it is a pipe, not a file");
}

void make_folder(const std::string& path) {
  if (path_kind(path) == PathKind::folder) return;
  if (mkdir(path.c_str(), 0777) != 0)
    throw file_error("cannot make the folder " + path, std::strerror(errno));
}

std::string read_whole_file(const std::string& path, const std::string& kind, std::size_t most) {
  readable_kind(path, kind);
  std::ifstream file(path, std::ios::binary);
  std::string bytes;
  std::array<char, 1 << 16> block;
  while (file.read(block.data(), block.size()), file.gcount() > 0) {
    bytes.append(block.data(), static_cast<std::size_t>(file.gcount()));
    if (bytes.size() > most)
      throw cannot_read(path, kind, "it is longer than " + std::to_string(most) + " bytes");
  }
  if (!file.eof()) throw cannot_read(path, kind, std::strerror(errno));
  return bytes;
}

}  // namespace supple
