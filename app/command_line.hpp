/// What was meant by a command line that cannot be read.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "supple/core/error.hpp"

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace supple::command {

/// The help that `supple help` or `supple help COMMAND` asks for; nothing where the first word is another
/// command of `app`, or an option. Throws an input error where it is neither.
std::optional<std::string> help_asked_for(const CLI::App& app, const std::vector<std::string>& words);

/// The error that says what is wrong with the words that `app` could not read, and what comes nearest.
Error explain(const CLI::App& app, const CLI::ParseError& e);

/// The whole number that an option got, written in digits alone. Throws an input error that names the option.
int whole_number(const std::string& option, const std::string& text, int least, int most);

/// Throws an input error where an option got another value than these.
void check_choice(const std::string& option, const std::string& value,
                  const std::vector<std::string>& choices);

}  // namespace supple::command
