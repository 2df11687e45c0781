/// Help, and errors that say what was meant by a command line that cannot be read.
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
/// command of `app` or an option. Throws an input error where it is none of these.
std::optional<std::string> help_asked_for(const CLI::App& app, const std::vector<std::string>& words);

/// The input error that says what is wrong with a command line that `app` could not read, and what comes
/// nearest to it.
Error explain(const CLI::App& app, const CLI::ParseError& e);

/// The value of an option that must be a whole number from `least` to `most`, in digits alone. Throws an
/// input error that names the option where it is not.
int whole_number(const std::string& option, const std::string& text, int least, int most);

/// The value of an option that is a time [s]: "90", "90s", "30min", "12h", "2d", "M:SS", "H:MM:SS",
/// "D-HH:MM:SS" as schedulers write it. Input error for anything else.
double seconds(const std::string& option, const std::string& text);

/// Throws an input error where the value of an option is not one of `choices`.
void check_choice(const std::string& option, const std::string& value,
                  const std::vector<std::string>& choices);

}  // namespace supple::command
