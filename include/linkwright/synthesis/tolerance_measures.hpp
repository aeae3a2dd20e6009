#pragma once

#include <optional>
#include <string>
#include <vector>

#include "linkwright/core/progress.hpp"
#include "linkwright/mechanism/linkage_output.hpp"
#include "linkwright/region/added_measures.hpp"
#include "linkwright/region/linkage_family.hpp"
#include "linkwright/robust/tolerances.hpp"
#include "linkwright/synthesis/answer.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "linkwright/synthesis/task.hpp"

namespace linkwright {

/// How the linkages that an answer lists lie in the positions of its task, one to each; turns counted by the turning
/// length, user's unit.
[[nodiscard]] std::vector<std::optional<LinkageOutput>> listed_outputs(const Answer& answer, double turning_length);

/// Samples of a linkage of a map: those listed are sampled as often as the tolerances say.
inline constexpr int map_samples = 1000;

/// By how much a yield by map_samples has to be above the one that is required, so that nearly all that do are met by
/// as many samples as the tolerances say; 0 where these are no more.
[[nodiscard]] double margin_of_yield(double required, const Tolerances& tolerances);

/// The error to first order, and where there is a limit the yield by map_samples, of a family's linkages. The turning
/// length is set, and so is the limit where yields are wanted. The family must outlive them.
[[nodiscard]] AddedMeasures tolerance_measures(const LinkageFamily& family, const Tolerances& tolerances);

/// Findings::tolerance of the linkages listed; those that do not meet by it what is required are left out, and a
/// warning says so, but not what is at a place that was asked for; where these rank them, the list is put in their
/// order. Cancelled: of those that were reached.
void report_tolerances(Answer& answer, const Progress& progress = {});

/// One linkage listed, how it lies in the positions of its task, and what tolerances do to it.
struct ToleranceStudy {
  std::string title, length_unit;
  Tolerances tolerances;  ///< as used
  LinkageOutput output;
  ToleranceReport report;
};
/// Of the linkage number `place` of the answer, from 0; it has a report.
[[nodiscard]] ToleranceStudy tolerance_study(const Problem& problem, const Answer& answer, std::size_t place);

/// An error as people read it: of functions and spheres degrees, which the engine has in radians.
[[nodiscard]] double readable_error(const LinkageOutput& output, double error);

}  // namespace linkwright
