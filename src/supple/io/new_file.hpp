/// Files that appear only when they are complete, and overwrite nothing unless asked.
#pragma once
#include <cstdio>
#include <string>
#include <string_view>

namespace supple {

/// What to do with a file of the same name.
enum class Existing { refuse, replace };

/// Throws a file error where `path` exists and may not be replaced, or its folder is missing or not writable.
void check_can_create(const std::string& path, Existing existing);

/// Makes the finished file `temporary` durable and gives it its name, in one step. Throws a file error where
/// `path` exists and may not be replaced.
void publish_file(const std::string& temporary, const std::string& path, Existing existing);

/// A file being written beside its place; commit() moves it there. Without commit nothing is left.
class NewFile {
 public:
  explicit NewFile(std::string path, Existing existing = Existing::refuse);
  ~NewFile();
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  void write(std::string_view bytes);
  void commit();

 private:
  std::string path_, temporary_;
  Existing existing_;
  std::FILE* file_;
};

/// The same for bytes that are in memory; a file of that name is replaced.
void write_whole_file(const std::string& path, std::string_view bytes);

}  // namespace supple
