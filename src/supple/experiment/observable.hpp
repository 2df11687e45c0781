/// Numbers of an instant, each declared once: tables, results and what reads them follow.
#pragma once
#include <algorithm>
#include <functional>
#include <string_view>
#include <utility>

#include "supple/experiment/recorder.hpp"

namespace supple {

/// A number of an instant: its name, unit and meaning, and how it follows.
template <class Instant>
struct Observable {
  Column column;
  std::function<double(const Instant&)> of;
};

template <class Instant>
class Observables {
 public:
  Observables(std::initializer_list<Observable<Instant>> list) : list_(list) {}
  /// Those of a part of the instant.
  template <class Part>
  Observables(const Observables<Part>& of_part) {
    for (const Observable<Part>& o : of_part) list_.push_back({o.column, o.of});
  }
  auto begin() const { return list_.begin(); }
  auto end() const { return list_.end(); }
  void add(const Observables& more) { list_.insert(list_.end(), more.begin(), more.end()); }

  /// Declares a table with a column for each.
  void declare(const std::string& table, Recorder& recorder) const {
    std::vector<Column> columns;
    for (const Observable<Instant>& o : list_) columns.push_back(o.column);
    recorder.declare(table, columns);
  }
  /// Appends a row to that table.
  void append(const std::string& table, const Instant& instant, Recorder& recorder) const {
    std::vector<double> row;
    for (const Observable<Instant>& o : list_) row.push_back(o.of(instant));
    recorder.append(table, row);
  }
  /// Records those as results whose name `is_wanted` accepts.
  template <class Wanted>
  void record(const Instant& instant, Recorder& recorder, Wanted&& is_wanted) const {
    for (const Observable<Instant>& o : list_)
      if (is_wanted(std::string_view(o.column.name))) recorder.value("results", o.column, o.of(instant));
  }

 private:
  std::vector<Observable<Instant>> list_;
};

/// Whether a name is one of these.
inline auto one_of(std::initializer_list<std::string_view> names) {
  return [names = std::vector<std::string_view>(names)](std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
}

}  // namespace supple
