/// Lines, words and numbers of mesh files, with errors that say where. For readers of meshes only.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "supple/core/error.hpp"

namespace supple {

/// The text between quotes as errors show it: 40 bytes at most, those that are no printed ASCII as \xNN.
std::string quoted(std::string_view text);

/// A line (from 1 on) or byte (from 0 on) of a mesh file.
struct MeshPlace {
  const std::string& path;
  const char* unit;  ///< "line" or "byte"
  std::size_t at;

  /// A file error: "cell.obj, line 7: what (why); to_do".
  Error fault(const std::string& what, const std::string& why, const std::string& to_do = {}) const;
  /// The error that a face of this many corners is.
  Error not_a_triangle(std::int64_t corners) const;
};

/// The double nearest to the digits of a word. Throws a fault at this place where the word is no number, or
/// one that is not finite or beyond the range of doubles.
double number_in(std::string_view word, const MeshPlace& place);
/// The whole number of a word, with a fault where it is none or outside [low, high]; `what` is what it
/// counts.
std::int64_t whole_number_in(std::string_view word, std::int64_t low, std::int64_t high, const char* what,
                             const MeshPlace& place);

/// Whether a line that ends with a backslash goes on in the next one.
enum class Continuation { none, backslash };

/// The lines of a text one after the other, in words. Each line ends with \n, \r\n or \r.
class MeshLines {
 public:
  /// What follows the character `comment` in a line is left out; '\0' means that there are no comments.
  MeshLines(const std::string& path, std::string_view text, char comment,
            Continuation continuation = Continuation::none, std::size_t first_line = 1)
      : path_(path), left_(text), comment_(comment), continuation_(continuation), next_line_(first_line) {}

  /// Goes to the next line that has a word; false where there is none.
  bool next();
  const std::vector<std::string_view>& words() const { return words_; }
  /// The line where the present words begin; behind the last one, the line after it.
  MeshPlace place() const { return {path_, "line", line_}; }
  /// Whether a line end stands behind the present line; a text that was cut off often has none there.
  bool is_complete() const { return complete_; }

 private:
  std::string_view take_line();
  void split(std::string_view line);
  void append_continuation(std::string_view line);

  const std::string& path_;
  std::string_view left_;
  char comment_;
  Continuation continuation_;
  std::size_t line_ = 0, next_line_;
  bool complete_ = true;
  std::vector<std::string_view> words_;
};

}  // namespace supple
