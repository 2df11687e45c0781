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
/// A link, pipe, device or folder is never replaced.
void check_can_create(const std::string& path, Existing existing);

/// Throws a file error where `path` is the file `input`, by whatever name.
void check_not_input(const std::string& path, const std::string& input);

/// Makes the finished file `temporary` durable and gives it its name, in one step. Throws a file error where
/// `path` exists and may not be replaced.
void publish_file(const std::string& temporary, const std::string& path, Existing existing);

/// A file that is written under a temporary name beside `path`; commit() gives it its name. Without commit()
/// nothing is left. The path "-" means standard output, which gets the bytes at once. Every member throws a
/// file error where it cannot create, write or publish.
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

/// Writes `bytes` as a whole file; replaces a file of that name. Throws as NewFile does.
void write_whole_file(const std::string& path, std::string_view bytes);

/// Removes the files STEMnnnnnnn.ENDING (seven digits) of an older run from a folder, where there is one.
void remove_numbered_files(const std::string& folder, std::string_view stem);

}  // namespace supple
