#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "linkwright/region/measure.hpp"
#include "linkwright/region/requirements.hpp"
#include "linkwright/synthesis/answer.hpp"

// Lists by what an analysis found out about each linkage, which it knows better than the map did.
namespace linkwright {

/// Which measures are the analysis's, and what it found of a linkage of the list; nothing where that has no value.
struct ListedMeasures {
  std::function<bool(const Measure& measure)> has;
  std::function<std::optional<double>(std::size_t linkage, const Measure& measure)> value;
};

/// What did not meet by an analysis what is required.
struct LeftOut {
  std::size_t count = 0;
  /// Stricter than what is required by twice as much as the worst of them misses it, of those that miss it by little:
  /// what meets these by a map's estimate is likely to meet the others by the analysis. Nothing: none misses it so.
  std::optional<Requirements> with_room;
};

/// Leaves out of the list what does not meet by it what is required.
LeftOut leave_out_what_fails(Answer& answer, const ListedMeasures& by);

/// Best first where the objective is one of its measures and lists are in that order; by `score`, larger being better.
void rank_again(Answer& answer, const ListedMeasures& by, const std::function<double(std::size_t linkage)>& score);

}  // namespace linkwright
