#pragma once

#include <string>
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

inline constexpr TaskWords spherical_function_words = {"spherical four-bars that generate all pairs",
                                                       function_words.lock, function_words.ways_out};

inline constexpr TaskWords spherical_words = {
    "spherical four-bars that pass through all orientations", "lock between two orientations (branch)",
    "Try another order of the orientations, {}allow a defect (no_defects: false), or turn an orientation a little."};

/// What a reason needs to know beside the findings.
struct ReasonFacts {
  bool has_directions = false;  ///< some position prescribes how it is passed
  std::string no_pair;          ///< why no pair of dyads makes a linkage
  std::string missed;           ///< what places required of hinges miss; starts with a space where there is something
};
[[nodiscard]] ReasonFacts reason_facts(const FourBarAnswer& answer);

/// Status and reason by what the map holds and what meets the requirements.
void state_reason(Findings& found, const TaskWords& words, const ReasonFacts& facts);

/// Where cells of the map meet the requirements, and yet no linkage is listed.
void explain_empty_list(Findings& found, bool nothing_listed);

}  // namespace linkwright
