/// What stands in run files, as tables.
#pragma once
#include <string>

namespace supple {

/// Every array of a run file that does not depend on the experiment: name, SI unit and meaning, as Markdown
/// (docs/quantities.md).
std::string describe_quantities();

}  // namespace supple
