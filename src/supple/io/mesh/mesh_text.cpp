#include "supple/io/mesh/mesh_text.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "supple/core/meant_number.hpp"

namespace supple {

namespace {

constexpr std::string_view blanks = " \t\v\f";

/// Digits as std::from_chars takes them, which knows no plus sign.
std::string_view without_plus(std::string_view word) {
  const bool plus = word.size() > 1 && word[0] == '+' && word[1] != '-' && word[1] != '+';
  return word.substr(plus ? 1 : 0);
}

/// What the writer of a word that is no number may have meant.
std::string number_meant_by(std::string_view word) {
  const auto meant = meant_number(word);
  return meant && *meant != word ? "did you mean " + *meant + "?" : "write digits, as in -1.5e-3";
}

}  // namespace

std::string quoted(std::string_view text) {
  constexpr std::size_t most = 40;
  std::string out = "'";
  for (const char c : text.substr(0, most)) {
    if (c >= ' ' && c <= '~') out += c;
    else out += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
  }
  return out + (text.size() > most ? "...'" : "'");
}

Error MeshPlace::fault(const std::string& what, const std::string& why, const std::string& to_do) const {
  return file_error(fmt::format("{}, {} {}: {}", path, unit, at, what), why, to_do);
}

Error MeshPlace::not_a_triangle(std::int64_t corners) const {
  return fault(fmt::format("a face has {} corners", corners), "the surface must consist of triangles",
               corners > 3 ? "triangulate the mesh where it was made, and export it again"
                           : "remove what is no triangle, or add the missing corners");
}

double number_in(std::string_view word, const MeshPlace& place) {
  const std::string_view digits = without_plus(word);
  double x = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), x);
  if (error == std::errc::invalid_argument || end != digits.data() + digits.size())
    throw place.fault(quoted(word) + " is no number", "a number was expected here", number_meant_by(word));
  if (error == std::errc::result_out_of_range)
    throw place.fault(quoted(word) + " is too large or too small", "doubles reach from 5e-324 to 1.8e308",
                      "take another unit of length");
  if (!std::isfinite(x))
    throw place.fault(quoted(word) + " is not finite", "a place must be known", "correct it");
  return x;
}

std::int64_t whole_number_in(std::string_view word, std::int64_t low, std::int64_t high, const char* what,
                             const MeshPlace& place) {
  const std::string_view digits = without_plus(word);
  std::int64_t n = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), n);
  if (error == std::errc::invalid_argument || end != digits.data() + digits.size())
    throw place.fault(fmt::format("{} is no whole number", quoted(word)), fmt::format("it is {}", what),
                      "write digits alone");
  if (error == std::errc::result_out_of_range || n < low || n > high)
    throw place.fault(fmt::format("{} is {}", what, quoted(word)),
                      high < low ? "there is none yet" : fmt::format("it can be {} to {}", low, high),
                      "correct it");
  return n;
}

std::string_view MeshLines::take_line() {
  const std::size_t end = left_.find_first_of("\r\n");
  complete_ = end != std::string_view::npos;
  const std::string_view line = left_.substr(0, end);
  left_.remove_prefix(complete_ ? end + (left_.substr(end).starts_with("\r\n") ? 2 : 1) : left_.size());
  ++next_line_;
  const std::size_t comment = comment_ ? line.find(comment_) : std::string_view::npos;
  return line.substr(0, comment);
}

void MeshLines::split(std::string_view line) {
  for (std::size_t at = 0; (at = line.find_first_not_of(blanks, at)) != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
    words_.push_back(line.substr(at, end - at));
    at = end;
  }
}

/// Adds the words of the lines in which `line`, which ends with a backslash, goes on.
void MeshLines::append_continuation(std::string_view line) {
  while (line.ends_with('\\')) {
    const MeshPlace here{path_, "line", next_line_ - 1};
    line.remove_suffix(1);
    split(line);
    if (left_.empty())
      throw here.fault("the line ends with a backslash", "no line follows in which it could go on",
                       "the file may be cut off; remove the backslash if not");
    const bool in_word = !line.empty() && blanks.find(line.back()) == std::string_view::npos;
    line = take_line();
    if (in_word && !line.empty() && blanks.find(line.front()) == std::string_view::npos)
      throw here.fault("the line ends with a backslash within a word",
                       "it is not clear whether the next line goes on with that word",
                       "put a space before the backslash");
  }
  split(line);
}

bool MeshLines::next() {
  words_.clear();
  while (words_.empty()) {
    line_ = next_line_;
    if (left_.empty()) return false;
    const std::string_view line = take_line();
    if (continuation_ == Continuation::backslash) append_continuation(line);
    else split(line);
  }
  return true;
}

}  // namespace supple
