#pragma once

#include <string>
#include <string_view>

#include "linkwright/synthesis/answer.hpp"

// Why an answer is as it is, in words.
namespace linkwright {

/// How a kind of task is spoken of.
struct TaskWords {
  std::string_view four_bars = "four-bars that pass through all poses";
  std::string_view linkages = "four-bars";
  std::string_view lock = "lock between two poses (branch)";
  std::string_view ways_out = "Try another order of the poses, {}allow a defect (no_defects: false), or move a pose.";
  std::string_view order = "reach them in another order";
};

inline constexpr TaskWords function_words = {
    "four-bars that generate all pairs", "four-bars", "lock between two pairs (branch)",
    "Try other ranges of the dials, fewer or other pairs, or allow a defect (no_defects: false)."};

inline constexpr TaskWords spherical_function_words = {"spherical four-bars that generate all pairs", "four-bars",
                                                       function_words.lock, function_words.ways_out};

inline constexpr TaskWords timed_path_words = {
    "four-bars whose point passes all points at the angles given", "four-bars", "lock between two points (branch)",
    "Try other angles of the crank, move a point, {}or allow a defect (no_defects: false).",
    "have a crank that cannot turn from the first point to the last in its sense"};

inline constexpr TaskWords path_words = {
    "four-bars whose point passes all points", "four-bars", timed_path_words.lock,
    "Move a point or what is given beside the points, {}or allow a defect (no_defects: false)."};

inline constexpr TaskWords near_path_words = {"four-bars found whose point passes near all points", "four-bars",
                                              timed_path_words.lock,
                                              "Move a point, {}or allow a defect (no_defects: false)."};

inline constexpr TaskWords spherical_words = {
    "spherical four-bars that pass through all orientations", "four-bars", "lock between two orientations (branch)",
    "Try another order of the orientations, {}allow a defect (no_defects: false), or turn an orientation a little."};

/// What a reason needs to know beside the findings.
struct ReasonFacts {
  bool has_directions = false;  ///< some position prescribes how it is passed
  std::string no_pair;          ///< why no pair of dyads makes a linkage
  std::string missed;           ///< what places required of hinges miss; starts with a space where there is something
  bool is_complete = false;     ///< the map holds all linkages that there are: what it has not, there is not
};
[[nodiscard]] ReasonFacts reason_facts(const FourBarAnswer& answer);
[[nodiscard]] ReasonFacts reason_facts(const SphericalAnswer& answer);

/// The map of a family of a few dyads, any two of which make a linkage, holds all that there are.
[[nodiscard]] bool is_complete(const LinkageFamily& family);

/// What was looked at inside the windows for hinges, where nothing meets all requirements: a sentence after another, or
/// nothing. `linkages`: how those of the kind are called.
[[nodiscard]] std::string inside_text(const Findings& found, std::string_view linkages);

/// A further sentence, or nothing.
[[nodiscard]] std::string after_a_sentence(const std::string& text);

/// Neither a cell of the map meets all requirements nor anything looked at inside the windows.
[[nodiscard]] bool nothing_meets_requirements(const Findings& found);

/// Status and reason by what the map holds and what meets the requirements.
void state_reason(Findings& found, const TaskWords& words, const ReasonFacts& facts);

/// Where cells of the map meet the requirements, and yet no linkage is listed.
void explain_empty_list(Findings& found, bool nothing_listed);

}  // namespace linkwright
