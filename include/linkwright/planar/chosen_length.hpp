#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "linkwright/planar/four_bar_family.hpp"
#include "linkwright/region/best_cells.hpp"
#include "linkwright/region/requirements.hpp"

namespace linkwright {

/// A length that the task leaves open, chosen so that the map over the rest has something to show.
struct ChosenLength {
  static constexpr int trials = 25;      ///< lengths that are tried, in equal ratios
  static constexpr double longest = 10;  ///< in characteristic lengths; max_length where that is less
  static constexpr double range = 100;   ///< longest over shortest
  static constexpr int samples = 100;    ///< a side of the map that is made for each

  double length = 0;         ///< user's unit
  std::int64_t meeting = 0;  ///< cells of that map that meet the requirements
};

/// The family that goes with a length (user's unit).
using FamilyOfLength = std::function<std::unique_ptr<const FourBarFamily>(double length)>;

/// Of all rungs the one whose best cell is best by the objective; among equals the one with most cells that meet the
/// requirements, then the shortest. Where nothing meets them: most cells free of defects, then most four-bars.
/// `requirements` with both lengths set; `frame`: that of the families.
[[nodiscard]] ChosenLength chosen_length(const FamilyOfLength& family_of, const WorkingFrame& frame,
                                         const Requirements& requirements, Objective objective);

}  // namespace linkwright
