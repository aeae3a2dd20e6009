#pragma once

#include <string_view>

#include "linkwright/synthesis/answer.hpp"

// Why an answer is as it is, in words.
namespace linkwright {

/// How a kind of task is spoken of.
struct TaskWords {
  std::string_view four_bars = "four-bars that pass through all poses";
  std::string_view lock = "lock between two poses (branch)";
  std::string_view ways_out = "Try another order of the poses, {}allow a defect (no_defects: false), or move a pose.";
};

inline constexpr TaskWords function_words = {
    "four-bars that generate all pairs", "lock between two pairs (branch)",
    "Try other ranges of the dials, fewer or other pairs, or allow a defect (no_defects: false)."};

/// Status and reason by what the map holds and what meets the requirements.
void state_reason(FourBarAnswer& answer, const TaskWords& words);

/// Where cells of the map meet the requirements, and yet no linkage is listed.
void explain_empty_list(Findings& found, bool nothing_listed);

}  // namespace linkwright
