/// Errors: what is wrong, why, and what to do. The library throws; only the command prints and exits.
#pragma once
#include <stdexcept>
#include <string>

namespace supple {

/// The kind decides the exit code of the command.
enum class ErrorKind { input = 2, numerics = 3, file = 4, interrupted = 130 };

/// An error with its kind and a message for the user.
class Error : public std::runtime_error {
 public:
  /// The message reads "what (why); to_do": what is wrong, why it is, and what the user can do. `why` and
  /// `to_do` may be empty.
  Error(ErrorKind kind, const std::string& what, const std::string& why = {}, const std::string& to_do = {})
      : std::runtime_error(what + (why.empty() ? "" : " (" + why + ")") +
                           (to_do.empty() ? "" : "; " + to_do)),
        kind_(kind) {}
  ErrorKind kind() const { return kind_; }
  int exit_code() const { return static_cast<int>(kind_); }

 private:
  ErrorKind kind_;
};

inline Error input_error(const std::string& what, const std::string& why = {},
                         const std::string& to_do = {}) {
  return {ErrorKind::input, what, why, to_do};
}
inline Error numerics_error(const std::string& what, const std::string& why = {},
                            const std::string& to_do = {}) {
  return {ErrorKind::numerics, what, why, to_do};
}
inline Error file_error(const std::string& what, const std::string& why = {}, const std::string& to_do = {}) {
  return {ErrorKind::file, what, why, to_do};
}

}  // namespace supple
