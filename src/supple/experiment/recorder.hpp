/// What an experiment tells the outside world. io/ makes files and progress of it; tests keep it in memory.
#pragma once
#include <cstdint>
#include <ctime>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "supple/model/evaluation.hpp"
#include "supple/model/frame.hpp"
#include "supple/model/kept.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// A column of a table against time, or a named number.
struct Column {
  std::string name, unit, meaning;
};

/// Saves everything that decides how a run goes on, or restores it.
using Keep = std::function<void(Keeper&)>;

/// A system, and the forces on it.
template <int Dim>
struct FinalState {
  System<Dim> system;
  Evaluation<Dim> evaluation;
};
using AnyFinalState = std::variant<FinalState<2>, FinalState<3>>;

/// What an experiment calls while it runs: tables such as "preparation" and "stress" (one row per step),
/// frames, numbers, the final state, progress and warnings.
class Recorder {
 public:
  virtual ~Recorder() = default;
  /// Begins a run in two dimensions or in three; whatever follows is of the same.
  virtual void begin(const AnyRunInfo& info) = 0;
  /// Whether begin() was called, by this run or the one that it goes on with.
  virtual bool began() const = 0;
  /// Declares a table; append() with the same name then adds rows, with one value for each column.
  virtual void declare(const std::string& table, const std::vector<Column>& columns) = 0;
  virtual void append(const std::string& table, std::span<const double> row) = 0;
  virtual void frame(const AnyFrame& frame) = 0;
  /// A named number. The group is "constants" (derived parameters), "results", or one that a continuation
  /// reads; error < 0: not known.
  virtual void value(const std::string& group, const Column& name, double value, double error = -1) = 0;
  /// All values of a column so far. Throws an input error where there is none of that name.
  virtual std::vector<double> column(const std::string& table, const std::string& name) = 0;
  /// The complete state at the end, or where the run was interrupted: a run with `[initial] state` goes on
  /// from it, bit for bit.
  virtual void final_state(const AnyFinalState& instant) = 0;
  virtual void progress(const std::string& phase, std::int64_t done, std::int64_t total) = 0;
  virtual void warning(const std::string& text) = 0;
  /// Whether the user asked to stop (Ctrl-C), for work between two safe points, which then throws
  /// `interrupted`.
  virtual bool stop_requested() { return false; }

  /// A place from which the run can go on, bit for bit, with what `keep` saves: what was recorded before is
  /// of the time before. Here checkpoints are written and requests to stop are obeyed, by an error:
  /// "interrupted at step 12" for `where` "at step" and `number` 12.
  virtual void safe_point(const Keep&, const char* where, std::int64_t number) {
    if (stop_requested()) throw interrupted_at(where, number);
  }
  /// The same before work that is long and does not lead to the next safe point unless it is finished, such
  /// as a minimisation: what `keep` saves is kept for a stop within it. Nothing may be recorded before it is
  /// finished.
  virtual void hold(const Keep& keep, const char* where, std::int64_t number) {
    safe_point(keep, where, number);
  }
  /// What was kept of the run that goes on here; null where a run starts.
  virtual const Kept* resumed() const { return nullptr; }
  /// Processor time of the run so far, with that before it was stopped [s].
  double cpu_time() const {
    return cpu_time_before_ + static_cast<double>(std::clock() - started_) / CLOCKS_PER_SEC;
  }

 protected:
  double cpu_time_before_ = 0;  ///< of a run that goes on

  static Error interrupted_at(const char* where, std::int64_t number) {
    return {ErrorKind::interrupted, std::string("interrupted ") + where + " " + std::to_string(number)};
  }

 private:
  std::clock_t started_ = std::clock();
};

/// Which part of an experiment a run that goes on was in, by what was kept as "part"; empty where a run
/// starts, and in experiments of one part.
inline std::string resumed_part(const Recorder& recorder) {
  std::string part;
  if (recorder.resumed() && recorder.resumed()->contains("part"))
    Keeper::restoring (*recorder.resumed())("part", part);
  return part;
}

/// Restores what was kept of the run that goes on, if it was in this part. False where it was not, or where a
/// run starts.
inline bool restore(const Recorder& recorder, const Keep& keep, const std::string& part = {}) {
  if (!recorder.resumed() || resumed_part(recorder) != part) return false;
  Keeper keeper = Keeper::restoring(*recorder.resumed());
  keep(keeper);
  return true;
}

/// `keep`, with the name of the part of the experiment that it belongs to.
inline Keep in_part(std::string part, Keep keep) {
  return [part = std::move(part), keep = std::move(keep)](Keeper& k) {
    std::string name = part;
    k("part", name);
    keep(k);
  };
}

/// A recorder that keeps everything of a run in this many dimensions in memory.
template <int Dim>
class MemoryRecorderOf : public Recorder {
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
  RunInfo<Dim> info;
  std::map<std::string, Table> tables;
  std::vector<Frame<Dim>> frames;
  std::map<std::string, std::vector<Value>> values;
  System<Dim> last_system;
  Evaluation<Dim> last_evaluation;
  std::vector<std::string> warnings;

  void begin(const AnyRunInfo& i) override {
    info = std::get<RunInfo<Dim>>(i);
    began_ = true;
  }
  bool began() const override { return began_; }
  void declare(const std::string& table, const std::vector<Column>& columns) override {
    tables.try_emplace(table, Table{columns, {}});
  }
  void append(const std::string& table, std::span<const double> row) override {
    tables[table].rows.emplace_back(row.begin(), row.end());
  }
  void frame(const AnyFrame& any) override {
    const auto& f = std::get<Frame<Dim>>(any);
    if (frames.empty() || !same_instant(frames.back(), f)) frames.push_back(f);
  }
  void value(const std::string& group, const Column& name, double v, double error) override {
    values[group].push_back({name, v, error});
  }
  std::vector<double> column(const std::string& table, const std::string& name) override;
  void final_state(const AnyFinalState& any) override {
    const auto& instant = std::get<FinalState<Dim>>(any);
    last_system = instant.system;
    last_evaluation = instant.evaluation;
  }
  void progress(const std::string&, std::int64_t, std::int64_t) override {}
  void warning(const std::string& text) override { warnings.push_back(text); }
  /// The first value of this name. Throws an input error where there is none.
  double get(const std::string& group, const std::string& name) const;

 private:
  bool began_ = false;
};
using MemoryRecorder = MemoryRecorderOf<2>;

}  // namespace supple
