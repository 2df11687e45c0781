/// Energies of whole bodies beside their shape energy: data, as a checkpoint holds it.
#pragma once
#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace supple {

/// A term (energy/list.hpp, BodyTerms) and its numbers for each body, in the order of Term::fields. On bodies
/// beyond the end, and where all numbers are 0, it does not act.
struct BodyTermData {
  std::string name;
  std::size_t width = 0;       ///< numbers of a body
  std::vector<double> number;  ///< [body * width + k]

  std::size_t bodies() const { return width == 0 ? 0 : number.size() / width; }
};

/// Has the term act on a body with these numbers. Terms are in the order of their names.
inline void set_body_term(std::vector<BodyTermData>& terms, std::string_view name, int body,
                          std::span<const double> numbers) {
  auto at = std::find_if(terms.begin(), terms.end(), [&](const BodyTermData& t) { return t.name >= name; });
  if (at == terms.end() || at->name != name) at = terms.insert(at, {std::string(name), numbers.size(), {}});
  const std::size_t begin = static_cast<std::size_t>(body) * at->width;
  if (at->number.size() < begin + at->width) at->number.resize(begin + at->width);
  std::copy(numbers.begin(), numbers.end(), at->number.begin() + static_cast<std::ptrdiff_t>(begin));
}

}  // namespace supple
