#include <algorithm>

#include "supple/core/error.hpp"
#include "supple/experiment/recorder.hpp"

namespace supple {

template <int Dim>
std::vector<double> MemoryRecorderOf<Dim>::Table::column(const std::string& name) const {
  const auto at =
      std::find_if(columns.begin(), columns.end(), [&](const Column& c) { return c.name == name; });
  if (at == columns.end()) throw input_error("no column '" + name + "'");
  std::vector<double> out;
  for (const auto& row : rows) out.push_back(row[static_cast<std::size_t>(at - columns.begin())]);
  return out;
}

template <int Dim>
std::vector<double> MemoryRecorderOf<Dim>::column(const std::string& table, const std::string& name) {
  const auto at = tables.find(table);
  if (at == tables.end()) throw input_error("no table '" + table + "'");
  return at->second.column(name);
}

template <int Dim>
double MemoryRecorderOf<Dim>::get(const std::string& group, const std::string& name) const {
  if (const auto at = values.find(group); at != values.end())
    for (const Value& v : at->second)
      if (v.name.name == name) return v.value;
  throw input_error("no value '" + name + "' in '" + group + "'");
}

template class MemoryRecorderOf<2>;
template class MemoryRecorderOf<3>;

}  // namespace supple
