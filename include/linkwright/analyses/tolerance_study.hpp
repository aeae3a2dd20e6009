#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "linkwright/core/result.hpp"
#include "linkwright/mechanism/linkage_output.hpp"
#include "linkwright/robust/tolerance_report.hpp"
#include "linkwright/robust/tolerances.hpp"
#include "linkwright/synthesis/answer.hpp"
#include "linkwright/synthesis/solve.hpp"

namespace linkwright {

/// One linkage listed, how it lies in the positions of its task, and what tolerances do to it.
struct ToleranceStudy {
  std::string title, length_unit;
  Tolerances tolerances;  ///< as used
  LinkageOutput output;
  ToleranceReport report;
};
/// Of the linkage number `place` of the answer, from 0; it has a report.
[[nodiscard]] ToleranceStudy tolerance_study(const Problem& problem, const Answer& answer, std::size_t place);

/// As JSON text: `tolerances` as in a problem file, `tolerance` as in a result's linkages.
[[nodiscard]] std::string write_tolerance_study(const ToleranceStudy& study);

/// As a picture (SVG, 1000 × 800): histograms of the samples' errors in each position (of a straight line at
/// its ends and in the middle), where they lie (of a body in the plane its origin about where it is to be, of a
/// straight line the paths of some linkages made), and what contributes how much to the variance.
[[nodiscard]] std::string draw_tolerances(const ToleranceStudy& study);

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
