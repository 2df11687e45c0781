/// Numbers with a unit, as they stand in cases and on the command line.
#pragma once
#include <string>
#include <string_view>

namespace supple {

/// The number that "500 um", "8 kPa", "0.1 us" or "1000 kg/m^3" means in `unit`, the unit of a parameter
/// ("m", "Pa", "s", "kg/m^3"). Units are products of m, g, s, Pa, N, J, Hz and degree with prefixes from p to
/// G and powers. "20 %" is a number without unit; any other unit ("d0") must be written as it is declared.
/// Prefixes are exact: "500 um" is the double 500e-6. Throws an input error (without position) that says what
/// was probably meant, for text that is no number, a number without unit, an unknown unit and a wrong
/// dimension; the error has `why` in its brackets.
double parse_quantity(std::string_view text, std::string_view unit, const std::string& why = {});

/// An example of a quantity in this unit, for errors and help: "8 kPa" for Pa, "500 um" for m, ...; empty
/// where there is none.
std::string_view example_quantity(std::string_view unit);

}  // namespace supple
