#include "sweep_progress.hpp"

#include <cstdio>
#include <fmt/format.h>
#include <unistd.h>

#include "linkwright/core/count_text.hpp"
#include "linkwright/files/number_text.hpp"

namespace linkwright::cli {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds between_looks{200};
constexpr std::chrono::seconds between_lines{30};

double seconds_since(Clock::time_point then) { return std::chrono::duration<double>(Clock::now() - then).count(); }

}  // namespace

std::string duration_text(double seconds) {
  constexpr double minute = 60, hour = 3600, day = 86400;
  if (seconds < 2 * minute) return significant_text(seconds, seconds < 10 ? 1 : 2) + " s";
  if (seconds < 2 * hour) return fmt::format("{:.0f} min", seconds / minute);
  if (seconds < 2 * day) return fmt::format("{:.1f} h", seconds / hour);
  return significant_text(seconds / day, 3) + " days";
}

SweepProgressLine::SweepProgressLine(std::int64_t samples, std::int64_t done)
    : samples_(samples),
      before_(done),
      is_terminal_(::isatty(STDERR_FILENO) != 0),
      begun_(Clock::now()),
      shown_(begun_) {}

SweepProgressLine::~SweepProgressLine() {
  if (is_terminal_ && is_shown_) std::fputs("\r\033[K", stderr);
}

double SweepProgressLine::seconds() const { return seconds_since(begun_); }

void SweepProgressLine::add(std::int64_t samples) {
  added_ += samples;
  const auto now = Clock::now();
  const auto since = now - shown_;
  if (is_terminal_ ? since < between_looks : since < between_lines) return;
  shown_ = now;
  show();
}

// What is left takes as long a sample as what this run has done, by the clock and so by all its threads.
void SweepProgressLine::show() {
  is_shown_ = true;
  const std::int64_t done = before_ + added_;
  const double each = seconds() / static_cast<double>(added_);
  const std::string line =
      fmt::format("{} of {} samples ({:.1f} %), {} a second, about {} left", grouped_text(done), grouped_text(samples_),
                  100.0 * static_cast<double>(done) / static_cast<double>(samples_), significant_text(1 / each, 3),
                  duration_text(each * static_cast<double>(samples_ - done)));
  std::fputs(is_terminal_ ? fmt::format("\r{}\033[K", line).c_str() : fmt::format("linkwright: {}\n", line).c_str(),
             stderr);
  std::fflush(stderr);
}

}  // namespace linkwright::cli
