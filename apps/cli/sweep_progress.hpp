#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace linkwright::cli {

/// How far a sweep is, on standard error: a line that changes where that is a terminal, otherwise one now and then.
class SweepProgressLine {
 public:
  /// `done`: samples that were there before this run.
  SweepProgressLine(std::int64_t samples, std::int64_t done);
  ~SweepProgressLine();
  SweepProgressLine(const SweepProgressLine&) = delete;
  SweepProgressLine& operator=(const SweepProgressLine&) = delete;

  void add(std::int64_t samples);
  [[nodiscard]] std::int64_t added() const { return added_; }
  [[nodiscard]] double seconds() const;

 private:
  void show();

  std::int64_t samples_, before_, added_ = 0;
  bool is_terminal_, is_shown_ = false;
  std::chrono::steady_clock::time_point begun_, shown_;
};

/// "40 s", "3 min", "2.5 h", "4 days".
[[nodiscard]] std::string duration_text(double seconds);

}  // namespace linkwright::cli
