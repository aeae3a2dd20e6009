#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "draw.hpp"

namespace linkwright::soak {

/// What became of one task.
struct Trial {
  std::string outcome;  ///< "refused", or the status of the answer
  int linkages = 0;
  double solve_seconds = 0;           ///< of processor time
  std::vector<std::string> findings;  ///< what is wrong with the answer
};

/// Reads, solves, writes, reads back and checks. With `cancel_after` (seconds) it is first solved with a Progress that
/// another thread cancels then; with `windows` it is
/// solved once more with small windows round the hinges of a linkage that is known.
[[nodiscard]] Trial tried(std::string_view problem_text, std::optional<double> cancel_after,
                          std::optional<Draw> windows);

[[nodiscard]] std::string written(const Trial& trial);
[[nodiscard]] Trial read_trial(const std::string& text);

}  // namespace linkwright::soak
