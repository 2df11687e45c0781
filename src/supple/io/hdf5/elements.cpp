#include "supple/io/hdf5/elements.hpp"

#include <fmt/format.h>

#include "supple/core/error.hpp"

namespace supple {

void expect_sound(bool good, const h5::Object& object, const std::string& what) {
  if (!good) throw file_error("cannot use what is in " + object.where(), what, "the file is damaged");
}

std::string unit_text(const Units& units, const Unit& unit) {
  if (!*unit.si || units.name == reduced_units().name) return "";
  const double size = units.of(unit);
  return size == 1 ? unit.si : fmt::format("{:.12g} {}", size, unit.si);  // products of units are rounded
}

}  // namespace supple
