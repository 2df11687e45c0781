/// Progress of long work on a terminal, or as plain lines in a log.
#pragma once
#include <chrono>
#include <cstdint>
#include <functional>
#include <ostream>
#include <string>

namespace supple {

/// Shows phase, share done, rate and time left. In the style `bar` one line is redrawn a few times a second;
/// in the style `lines` a line is added at the start of a phase and then for every tenth of it or every 30 s.
class ProgressLine {
 public:
  enum class Style { bar, lines };
  using Clock = std::function<double()>;  ///< seconds since any instant

  ProgressLine(std::ostream& out, Style style, Clock clock = seconds_now);

  /// Shows that `done` of `total` is done; a total of 0 is unknown. Text after ": " in `phase`, as in "jam:
  /// phi = 0.81", is shown but is no part of the name: when it changes the phase goes on.
  void update(const std::string& phase, std::int64_t done, std::int64_t total);
  /// Writes a line of its own, above the bar.
  void message(const std::string& text);
  /// Ends the line that is being redrawn.
  void finish();

  static double seconds_now();

 private:
  void begin_phase(const std::string& phase, double now);
  std::string describe(std::int64_t done, std::int64_t total, double now) const;
  void draw(const std::string& line);

  std::ostream& out_;
  Style style_;
  Clock clock_;
  std::string phase_, shown_;  ///< its name; the name with the text after it
  double phase_start_ = 0, last_shown_ = 0;
  std::int64_t first_done_ = 0;
  int tenths_ = -1;
  std::size_t drawn_ = 0;  ///< characters of the line that is being redrawn
};

}  // namespace supple
