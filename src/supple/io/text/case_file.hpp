/// Cases as TOML: read with errors that say where and why, and written with the meaning of every key.
#pragma once
#include <string>
#include <vector>

#include "supple/experiment/case.hpp"

namespace supple {

/// The case in the file `path`, with `overrides` ("section.key=value", as --set has them) on top. A number
/// with a unit may be a string such as "500 um"; in overrides, strings need no quotes. A relative path in the
/// file starts from the folder of the file. Sets Case::given and Case::origin. Checks every key by itself;
/// supple::check() checks the rest. Throws an input error with a line "file:line:column: what (why); what to
/// do" for everything that is wrong, or a file error where the file cannot be read.
Case read_case(const std::string& path, const std::vector<std::string>& overrides = {});

/// The same for text in memory; `name` stands for the file, in errors and for relative paths.
Case read_case_text(const std::string& text, const std::string& name,
                    const std::vector<std::string>& overrides = {});

/// Which keys of a case are written, and how.
enum class CaseStyle {
  all,  ///< every key with its meaning; keys that were not given are commented out, holding their default
  commented,  ///< the same for the keys that the experiment uses
  resolved    ///< every key of its sections with its value, nothing else: what a run keeps
};
/// The case as TOML. Numbers are the shortest that read back as the same double.
std::string write_case(const Case& c, CaseStyle style);

/// Every key with its default, unit, valid values and meaning: Markdown tables, one for each section.
std::string describe_parameters();

}  // namespace supple
