#include "supple/io/text/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "supple/core/duration.hpp"

namespace supple {

namespace {
constexpr double redraw_seconds = 0.2, line_seconds = 30;
constexpr int bar_width = 24;

std::string bar(double share) {
  const int filled = static_cast<int>(share * bar_width);
  return "[" + std::string(filled, '#') + std::string(bar_width - filled, '-') + "]";
}
}  // namespace

double ProgressLine::seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

ProgressLine::ProgressLine(std::ostream& out, Style style, Clock clock)
    : out_(out), style_(style), clock_(std::move(clock)) {}

void ProgressLine::begin_phase(const std::string& phase, double now) {
  finish();
  phase_ = phase.substr(0, phase.find(": "));
  phase_start_ = now;
  last_shown_ = -INFINITY;
  tenths_ = -1;
}

std::string ProgressLine::describe(std::int64_t done, std::int64_t total, double now) const {
  const double rate = static_cast<double>(done - first_done_) / std::max(now - phase_start_, 1e-9);
  std::string text = fmt::format("{:<12}", shown_);
  if (total > 0) {
    const double share = std::clamp(static_cast<double>(done) / static_cast<double>(total), 0.0, 1.0);
    if (style_ == Style::bar) text += " " + bar(share);
    text += fmt::format(" {:3.0f} %  {} of {}", 100 * share, done, total);
  } else {
    text += fmt::format(" {}", done);
  }
  if (done <= first_done_) return text;
  text += fmt::format("  {:.3g}/s", rate);
  if (total > done)
    text += fmt::format("  {} left", describe_seconds(static_cast<double>(total - done) / rate));
  return text;
}

void ProgressLine::draw(const std::string& line) {
  if (style_ == Style::bar) {
    const std::size_t blanks = drawn_ > line.size() ? drawn_ - line.size() : 0;
    out_ << '\r' << line << std::string(blanks, ' ') << std::flush;
    drawn_ = line.size();
  } else {
    out_ << line << std::endl;
  }
}

void ProgressLine::update(const std::string& phase, std::int64_t done, std::int64_t total) {
  const double now = clock_();
  shown_ = phase;
  if (phase.substr(0, phase.find(": ")) != phase_) {
    begin_phase(phase, now);
    first_done_ = done;
  }
  const bool last = total > 0 && done >= total;
  const int tenths = total > 0 ? static_cast<int>(10 * done / total) : 0;
  const double wait = style_ == Style::bar ? redraw_seconds : line_seconds;
  const bool passed_tenth = style_ == Style::lines && tenths > tenths_;
  if (!passed_tenth && !(last && drawn_ > 0) && now - last_shown_ < wait) return;
  draw(describe(done, total, now));
  last_shown_ = now;
  tenths_ = tenths;
}

void ProgressLine::message(const std::string& text) {
  finish();
  out_ << text << std::endl;
}

void ProgressLine::finish() {
  if (drawn_ > 0) out_ << std::endl;
  drawn_ = 0;
}

}  // namespace supple
