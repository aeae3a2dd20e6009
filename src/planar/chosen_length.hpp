#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "linkwright/core/progress.hpp"
#include "linkwright/planar/four_bar_family.hpp"
#include "linkwright/region/best_cells.hpp"
#include "linkwright/region/requirements.hpp"
#include "three_pose_dyads.hpp"

namespace linkwright {

/// Shortest and longest, user's unit.
using LengthRange = std::array<double, 2>;

/// A length that the task leaves open, searched where linkages are.
struct ChosenLength {
  static constexpr int first_trials = 25;  ///< lengths that are tried at first, in equal ratios
  static constexpr int doublings = 2;      ///< where none has a linkage that meets the requirements: lengths between
  static constexpr double longest = 10;    ///< in characteristic lengths; max_length where that is less
  static constexpr double range = 100;     ///< longest over shortest
  static constexpr int samples = 100;      ///< a side of the map that is made for each

  double length = 0;         ///< user's unit
  std::int64_t meeting = 0;  ///< linkages looked at of this length that meet the requirements
  int tried = 0;             ///< lengths
  LengthRange within{};      ///< that were tried
};

/// The family that goes with a length (user's unit).
using FamilyOfLength = std::function<std::unique_ptr<const FourBarFamily>(double length)>;

/// What windows for pivots leave of the length of a grounded link through three positions: of the dyads whose pivots
/// lie in each, sampled and widened a little, and of both what they have in common. Nothing without windows, and where
/// they leave none.
[[nodiscard]] std::optional<LengthRange> lengths_in_windows(const ThreePoseDyads& dyads, const WorkingFrame& frame,
                                                            const Requirements& requirements);

/// The length whose best linkage is best by the objective: of lengths in equal ratios between those that the
/// requirements leave, windows for pivots looked into for themselves, then climbed. Where none has a linkage that meets
/// the requirements, those are tried too that lead nearer to the windows; then it is the one with most that fail a
/// single one, so that what is advised of its map holds of all lengths tried. `requirements` with both lengths set;
/// `frame`: that of the families; `within`: none is tried beyond, where that leaves any; `partner`: the other grounded
/// link's length, 0 where it is open. Cancelled, the best of those tried so far.
[[nodiscard]] ChosenLength chosen_length(const FamilyOfLength& family_of, const WorkingFrame& frame,
                                         const Requirements& requirements, Objective objective,
                                         const std::optional<LengthRange>& within = {}, double partner = 0,
                                         const Progress& progress = {});

}  // namespace linkwright
