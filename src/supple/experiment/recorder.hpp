/// What an experiment tells the outside world. io/ makes files and progress of it; tests keep it in memory.
#pragma once
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "supple/model/evaluation.hpp"
#include "supple/model/frame.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// A column of a table against time, or a named number.
struct Column {
  std::string name, unit, meaning;
};

/// What an experiment calls while it runs: tables such as "preparation" and "stress" (one row per step),
/// frames, numbers, the final state, progress and warnings.
class Recorder {
 public:
  virtual ~Recorder() = default;
  virtual void begin(const RunInfo& info) = 0;
  /// Declares a table; append() with the same name then adds rows, with one value for each column.
  virtual void declare(const std::string& table, const std::vector<Column>& columns) = 0;
  virtual void append(const std::string& table, std::span<const double> row) = 0;
  virtual void frame(const Frame& frame) = 0;
  /// A named number. The group is "constants" (derived parameters), "results", or one that a continuation
  /// reads; error < 0: not known.
  virtual void value(const std::string& group, const Column& name, double value, double error = -1) = 0;
  /// The complete state at the end, or where the run was interrupted: a run with `[initial] state` goes on
  /// from it, bit for bit.
  virtual void final_state(const System<2>& system, const Evaluation<2>& evaluation) = 0;
  virtual void progress(const std::string& phase, std::int64_t done, std::int64_t total) = 0;
  virtual void warning(const std::string& text) = 0;
  /// Whether the user asked to stop (Ctrl-C). The experiment then hands over its state and throws
  /// `interrupted`.
  virtual bool stop_requested() const { return false; }
};

/// A recorder that keeps everything in memory.
class MemoryRecorder : public Recorder {
 public:
  struct Table {
    std::vector<Column> columns;
    std::vector<std::vector<double>> rows;
    std::vector<double> column(const std::string& name) const;
  };
  struct Value {
    Column name;
    double value, error;
  };
  RunInfo info;
  std::map<std::string, Table> tables;
  std::vector<Frame> frames;
  std::map<std::string, std::vector<Value>> values;
  System<2> last_system;
  Evaluation<2> last_evaluation;
  std::vector<std::string> warnings;

  void begin(const RunInfo& i) override { info = i; }
  void declare(const std::string& table, const std::vector<Column>& columns) override {
    tables[table] = {columns, {}};
  }
  void append(const std::string& table, std::span<const double> row) override {
    tables[table].rows.emplace_back(row.begin(), row.end());
  }
  void frame(const Frame& f) override {
    if (frames.empty() || !same_instant(frames.back(), f)) frames.push_back(f);
  }
  void value(const std::string& group, const Column& name, double v, double error) override {
    values[group].push_back({name, v, error});
  }
  void final_state(const System<2>& s, const Evaluation<2>& e) override {
    last_system = s;
    last_evaluation = e;
  }
  void progress(const std::string&, std::int64_t, std::int64_t) override {}
  void warning(const std::string& text) override { warnings.push_back(text); }
  /// The first value of this name. Throws an input error where there is none.
  double get(const std::string& group, const std::string& name) const;
};

}  // namespace supple
