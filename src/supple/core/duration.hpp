/// How long something takes, in words.
#pragma once
#include <string>

namespace supple {

/// The words for a time in seconds: "12 s", "3 min 20 s", "2 h 5 min", "40 days", "3 years".
std::string describe_seconds(double seconds);

}  // namespace supple
