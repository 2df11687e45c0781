#include "command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <regex>
#include <sstream>

#include "supple/core/meant_number.hpp"
#include "supple/core/nearest_name.hpp"

namespace supple::command {

namespace {

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* c : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(c->get_name());
  return names;
}

/// "-o", "--output", ...
std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* o : command.get_options()) {
    for (const std::string& name : o->get_snames()) names.push_back("-" + name);
    for (const std::string& name : o->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

/// "CASE.toml": what the command works on.
std::string operand(const CLI::App& command) {
  for (const CLI::Option* o : command.get_options())
    if (o->get_positional()) return o->get_type_name();
  return "";
}

/// "supple run", or "supple" where no command was read.
const CLI::App& reading(const CLI::App& app) {
  const auto commands = app.get_subcommands();
  return commands.empty() ? app : *commands.front();
}
std::string full_name(const CLI::App& app, const CLI::App& command) {
  return &app == &command ? app.get_name() : app.get_name() + " " + command.get_name();
}

Error unknown_word(const CLI::App& app, const std::vector<std::string>& words) {
  const CLI::App& command = reading(app);
  const std::string name = full_name(app, command);
  auto word =
      std::find_if(words.begin(), words.end(), [](const std::string& w) { return w.starts_with('-'); });
  if (word == words.end()) {
    const std::string taken = operand(command);
    return input_error(fmt::format("'{}' is one word too many", words.front()),
                       taken.empty() ? "" : fmt::format("{} takes one {}", name, taken),
                       fmt::format("see {} --help", name));
  }
  const std::string option = word->substr(0, word->find('='));
  const std::vector<std::string> names = option_names(command);
  const auto near = nearest_name(option, names);
  return input_error(
      fmt::format("{} has no option {}", name, option), "",
      near ? fmt::format("did you mean {}?", *near) : "its options are " + join_names(names, ""));
}

/// Whether a message of CLI11, "--output: 1 required", "Could not convert: --force = no", is about this
/// option.
bool names_option(const std::string& what, const CLI::Option& o) {
  std::vector<std::string> words;
  std::istringstream in(what);
  for (std::string word; in >> word;) words.push_back(word.substr(0, word.find_last_not_of(':') + 1));
  const auto among_words = [&](const std::string& name) {
    return std::find(words.begin(), words.end(), name) != words.end();
  };
  return among_words(o.get_name()) ||
         std::any_of(o.get_lnames().begin(), o.get_lnames().end(),
                     [&](const std::string& name) { return among_words("--" + name); });
}

}  // namespace

std::optional<std::string> help_asked_for(const CLI::App& app, const std::vector<std::string>& words) {
  if (words.empty() || words.front().starts_with('-')) return std::nullopt;
  const bool help = words.front() == "help";
  if (help && words.size() == 1) return app.help();
  const std::string& name = words[help ? 1 : 0];
  const std::vector<std::string> names = command_names(app);
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    const auto near = nearest_name(name, names);
    throw input_error(
        fmt::format("there is no command '{}'", name), "",
        near ? fmt::format("did you mean '{}'?", *near) : "the commands are " + join_names(names, ""));
  }
  if (!help) return std::nullopt;
  return app.get_subcommand(name)->help(app.get_name());
}

Error explain(const CLI::App& app, const CLI::ParseError& e) {
  if (const auto words = app.remaining(true); !words.empty()) return unknown_word(app, words);
  const CLI::App& command = reading(app);
  const std::string name = full_name(app, command), what = e.what();
  const std::string taken = operand(command);
  if (dynamic_cast<const CLI::RequiredError*>(&e))
    return &app == &command ? input_error("supple needs a command", "", "see supple --help")
                            : input_error(fmt::format("{} needs a {}", name, taken), "",
                                          fmt::format("write {} {}", name, taken));
  for (const CLI::Option* o : command.get_options()) {
    if (!names_option(what, *o)) continue;
    const std::string option = o->get_lnames().empty() ? o->get_name() : "--" + o->get_lnames().front();
    if (o->get_expected_max() == 0)
      return input_error(fmt::format("{} takes no value", option), "", "leave it away");
    if (o->results().size() > 1)
      return input_error(fmt::format("{} stands more than once", option), "", "keep one of them");
    return input_error(fmt::format("{} needs a value", option), "",
                       fmt::format("write {} {}", option, o->get_type_name()));
  }
  return input_error("the options cannot be read", what.substr(0, what.find('\n')),
                     fmt::format("see {} --help", name));
}

int whole_number(const std::string& option, const std::string& text, int least, int most) {
  int value = 0;
  const std::from_chars_result result = std::from_chars(text.data(), text.data() + text.size(), value);
  const auto meant = meant_number(text);
  const bool digits = meant && meant->find_first_of(".e ") == meant->npos;
  const bool spelt_so = digits && *meant == text;
  if (spelt_so && result.ec == std::errc{} && value >= least && value <= most) return value;
  throw input_error(fmt::format("{} {}: {}", option, text.empty() ? "''" : text,
                                spelt_so ? "out of range" : "not a whole number"),
                    "",
                    digits && !spelt_so ? fmt::format("write {} {}", option, *meant)
                                        : fmt::format("give a whole number from {} to {}", least, most));
}

double seconds(const std::string& option, const std::string& text) {
  static const std::regex number(R"(([0-9]*\.?[0-9]+) ?(s|min|h|d)?)"),
      clock(R"((?:([0-9]+)-)?(?:([0-9]+):)?([0-9]+):([0-9]{2}))");
  std::smatch found;
  if (std::regex_match(text, found, number)) {
    const std::string unit = found[2];
    const double factor = unit == "min" ? 60 : unit == "h" ? 3600 : unit == "d" ? 86400 : 1;
    return factor * std::stod(found[1]);
  }
  if (std::regex_match(text, found, clock) && (!found[1].matched || found[2].matched)) {
    const auto part = [&](int k) { return found[k].matched ? std::stod(found[k]) : 0; };
    return 86400 * part(1) + 3600 * part(2) + 60 * part(3) + part(4);
  }
  throw input_error(fmt::format("{} {}: not a time", option, text.empty() ? "''" : text), "",
                    "give seconds, or 90s, 30min, 12h, 2d, M:SS, H:MM:SS, D-HH:MM:SS");
}

void check_choice(const std::string& option, const std::string& value,
                  const std::vector<std::string>& choices) {
  if (std::find(choices.begin(), choices.end(), value) != choices.end()) return;
  const auto near = nearest_name(value, choices);
  throw input_error(fmt::format("{} {}: not a choice", option, value), "",
                    (near ? fmt::format("did you mean {}? It", *near) : "it") + " must be one of " +
                        join_names(choices, ""));
}

}  // namespace supple::command
