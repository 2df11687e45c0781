/// A parameter is declared once; the TOML loader, the command's help, the file's attributes and the docs all
/// read the declaration.
#pragma once
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace supple {

/// Interval of allowed values; `open_low` and `open_high` exclude its ends.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool open_low = false, open_high = false;

  bool contains(double x) const {
    return std::isfinite(x) && (open_low ? x > low : x >= low) && (open_high ? x < high : x <= high);
  }
};
/// "above 0", "from 0 to 1", "from 0, below 1"; empty where every finite number is allowed.
std::string describe(const Range& range);

inline constexpr Range any_value{};
inline constexpr Range positive{0, std::numeric_limits<double>::infinity(), true, false};
inline constexpr Range not_negative{0};
inline constexpr Range at_least_one{1};
inline constexpr Range fraction{0, 1};

/// What becomes of a parameter when a run goes on from a state.
enum class Role {
  unsaid,     ///< the role of its section (with_role), or else `run`
  run,        ///< how this run goes; a state does not keep it
  law,        ///< what acts; the state keeps it by name, and it holds unless the case gives the key
  exception,  ///< a law in the place of another one where it is given; the state keeps it only there
  sample,     ///< how the sample was made; a case with a state may only repeat what the state says
  number      ///< what acts, too, but the state keeps it among its numbers, not by name
};

/// One parameter of the struct P: its key, the member that holds it, its unit ("" for none), its meaning in
/// one line. A member of type double reads integers too. `choices` lists the valid values of a string; empty,
/// any text is valid.
template <class P>
struct Field {
  using Member = std::variant<double P::*, int P::*, std::int64_t P::*, bool P::*, std::string P::*>;
  std::string_view name;
  Member member;
  std::string_view unit;
  std::string_view meaning;
  Range range = any_value;
  std::vector<std::string_view> choices = {};
  Role role = Role::unsaid;
};

template <class P>
using Fields = std::vector<Field<P>>;

/// The same fields, with this role for those that are `unsaid`.
template <class P>
Fields<P> with_role(Role role, Fields<P> fields) {
  for (Field<P>& f : fields)
    if (f.role == Role::unsaid) f.role = role;
  return fields;
}

}  // namespace supple
