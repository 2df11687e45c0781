#include "supple/core/new_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "supple/core/error.hpp"
#include "supple/core/path_kind.hpp"

namespace supple {
namespace {

namespace fs = std::filesystem;

std::string folder_of(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  return folder.empty() ? "." : folder.string();
}

void sync(const std::string& path, int flags) {
  const int file = open(path.c_str(), flags | O_CLOEXEC);
  const bool good = file >= 0 && (fsync(file) == 0 || errno == EINVAL);
  const int why = errno;
  if (file >= 0) close(file);
  if (!good) throw file_error("cannot write " + path, std::strerror(why));
}

Error exists(const std::string& path) {
  return file_error(path + " exists", "nothing is overwritten unless asked",
                    "choose another name, remove it, or overwrite it with --force");
}

/// Only a regular file may be replaced by a new one: readers of a pipe, a device or a link would lose it.
void check_can_replace(const std::string& path) {
  const fs::file_type type = fs::symlink_status(path).type();
  if (type == fs::file_type::not_found || type == fs::file_type::regular) return;
  const char* what = type == fs::file_type::symlink ? "a link"
                     : type == fs::file_type::fifo  ? "a pipe"
                                                    : "a device";
  throw file_error(
      "cannot replace " + path, std::string("it is ") + what + ", not a regular file",
      "choose another name or remove it; the name - is standard output where a command can write there");
}

/// The place that a path means, with links resolved; for what does not exist yet, its absolute path.
fs::path place_of(const std::string& path) {
  std::error_code error;
  const fs::path place = fs::weakly_canonical(fs::absolute(path), error);
  return error ? fs::path(path) : place;
}

}  // namespace

void check_can_create(const std::string& path, Existing existing) {
  if (path == standard_output) return;
  const std::string folder = folder_of(path);
  if (path_kind(folder) != PathKind::folder)
    throw file_error("cannot create " + path, "there is no folder " + folder, "make the folder first");
  if (access(folder.c_str(), W_OK | X_OK) != 0)
    throw file_error("cannot create " + path, "folder " + folder + " is not writable");
  if (path_kind(path) == PathKind::folder) throw file_error("cannot create " + path, "it is a folder");
  if (existing == Existing::refuse && fs::exists(fs::symlink_status(path))) throw exists(path);
  check_can_replace(path);
}

void check_not_input(const std::string& path, const std::string& input) {
  if (input.empty() || path == standard_output) return;
  std::error_code none;  // where one of them is not there
  if (!fs::equivalent(path, input, none) && place_of(path) != place_of(input)) return;
  throw file_error("cannot write " + path, "it is the file that is read", "choose another name with -o");
}

void publish_file(const std::string& temporary, const std::string& path, Existing existing) {
  sync(temporary, O_RDONLY);
  const unsigned flags = existing == Existing::refuse ? RENAME_NOREPLACE : 0;
  int result = renameat2(AT_FDCWD, temporary.c_str(), AT_FDCWD, path.c_str(), flags);
  if (result != 0 && errno == EINVAL &&
      existing == Existing::refuse) {  // file systems without RENAME_NOREPLACE
    result = link(temporary.c_str(), path.c_str());
    if (result == 0) unlink(temporary.c_str());
  }
  if (result != 0 && errno == EEXIST) throw exists(path);
  if (result != 0) throw file_error("cannot create " + path, std::strerror(errno));
  sync(folder_of(path), O_RDONLY | O_DIRECTORY);
}

NewFile::NewFile(std::string path, Existing existing) : path_(std::move(path)), existing_(existing) {
  if (path_ == standard_output) {
    file_ = stdout;
    return;
  }
  temporary_ = path_ + "." + std::to_string(getpid()) + ".tmp";
  check_can_create(path_, existing_);
  file_ = std::fopen(temporary_.c_str(), "we");
  if (!file_) fail();
}

NewFile::~NewFile() {
  if (!file_ || temporary_.empty()) return;
  std::fclose(file_);
  unlink(temporary_.c_str());
}

void NewFile::fail() const {
  throw file_error("cannot write " + (temporary_.empty() ? "standard output" : path_), std::strerror(errno));
}

void NewFile::write(std::string_view bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) fail();
}

void NewFile::commit() {
  if (std::fflush(file_) != 0) fail();
  if (temporary_.empty()) return;
  publish_file(temporary_, path_, existing_);
  std::fclose(file_);
  file_ = nullptr;
}

void remove_numbered_files(const std::string& folder, std::string_view stem) {
  if (!fs::is_directory(folder)) return;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    const std::string_view digits = std::string_view(name).substr(std::min(stem.size(), name.size()));
    if (name.starts_with(stem) && digits.size() > 8 && digits.find_first_not_of("0123456789") == 7 &&
        digits[7] == '.' && entry.is_regular_file())
      fs::remove(entry.path());
  }
}

void write_whole_file(const std::string& path, std::string_view bytes) {
  NewFile file(path, Existing::replace);
  file.write(bytes);
  file.commit();
}

}  // namespace supple
