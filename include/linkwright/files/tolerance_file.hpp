#pragma once

#include <string>

#include "linkwright/synthesis/tolerance_measures.hpp"

namespace linkwright {

/// A study as JSON text: `tolerances` as in a problem file, `tolerance` as in a result's linkages.
[[nodiscard]] std::string write_tolerance_study(const ToleranceStudy& study);

}  // namespace linkwright
