#pragma once

#include "linkwright/core/progress.hpp"
#include "linkwright/synthesis/answer.hpp"

namespace linkwright {

/// Findings::tolerance of the linkages listed; where these rank them, the list is put in their order. Cancelled: of
/// those that were reached.
void report_tolerances(Answer& answer, const Progress& progress);

}  // namespace linkwright
