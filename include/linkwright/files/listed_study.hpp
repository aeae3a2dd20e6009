#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "linkwright/core/result.hpp"
#include "linkwright/synthesis/answer.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "linkwright/synthesis/tolerance_measures.hpp"

namespace linkwright {

/// What is asked otherwise than the problem says.
struct ToleranceChanges {
  std::optional<double> length;      ///< half tolerance of every length and pivot, user's unit
  std::optional<int> samples;        ///< how many linkages are made
  std::optional<std::int64_t> seed;  ///< of the linkages made
};

/// What tolerances do to one linkage of a result file.
struct ListedStudy {
  Problem problem;  ///< as solved anew at the linkage's place
  Answer answer;
  std::size_t place = 0;  ///< of the linkage in the answer, from 0
  ToleranceStudy study;   ///< its title names the linkage
};

/// `text`: of a result file; `linkage`: from 1. The caller's mistakes: those of read_listed_problem(), a problem
/// without tolerances, a linkage at a dead point.
[[nodiscard]] Result<ListedStudy> listed_study(std::string_view text, int linkage,
                                               const ToleranceChanges& changes = {});

}  // namespace linkwright
