/// Files that appear only when they are complete, and overwrite nothing unless asked.
#pragma once
#include <cstdio>
#include <string>
#include <string_view>

namespace supple {

/// What to do with a file of the same name.
enum class Existing { refuse, replace };

/// The name that stands for standard output.
inline constexpr std::string_view standard_output = "-";

/// Throws a file error where `path` exists and may not be replaced, or its folder is missing or not writable.
/// What is no regular file (link, pipe, device, folder) is never replaced.
void check_can_create(const std::string& path, Existing existing);

/// Throws a file error where `path` is the file `input`, by whatever name.
void check_not_input(const std::string& path, const std::string& input);

/// Makes the finished file `temporary` durable and gives it its name, in one step. Throws a file error where
/// `path` exists and may not be replaced.
void publish_file(const std::string& temporary, const std::string& path, Existing existing);

/// A file being written beside its place; commit() moves it there. Without commit nothing is left. Under the
/// name - it is standard output, which gets the bytes as they come.
class NewFile {
 public:
  explicit NewFile(std::string path, Existing existing = Existing::refuse);
  ~NewFile();
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  void write(std::string_view bytes);
  void commit();

 private:
  [[noreturn]] void fail() const;

  std::string path_, temporary_;  ///< `temporary_` is empty for standard output
  Existing existing_;
  std::FILE* file_;
};

/// The same for bytes that are in memory; a file of that name is replaced.
void write_whole_file(const std::string& path, std::string_view bytes);

/// Removes the files STEMnnnnnnn.ENDING (seven digits) of an older run from a folder, where there is one.
void remove_numbered_files(const std::string& folder, std::string_view stem);

}  // namespace supple
