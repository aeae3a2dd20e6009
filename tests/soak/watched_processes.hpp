#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace linkwright::soak {

struct ProcessLimits {
  int at_once = 1;
  double processor_seconds = 2;  ///< of each process: a busy machine does not count
  double clock_seconds = 60;     ///< for those that wait for ever
};

/// How a process ended.
struct Ended {
  enum class How { said, over_time, crashed };
  How how = How::said;
  std::string text;    ///< what it said, or how it crashed
  double seconds = 0;  ///< of processor time
};

/// Calls `work` for each number in a process of its own; `tell` hears here what it returned, or how it ended instead.
void run_apart(const std::vector<std::size_t>& numbers, const ProcessLimits& limits,
               const std::function<std::string(std::size_t)>& work,
               const std::function<void(std::size_t, const Ended&)>& tell);

}  // namespace linkwright::soak
