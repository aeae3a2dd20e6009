#pragma once

#include <string>

#include "linkwright/analysis/four_bar_analysis.hpp"
#include "linkwright/files/instant_file.hpp"
#include "linkwright/files/linkage_file.hpp"

namespace linkwright {

/// The analysis of a four-bar and the file that it came from.
struct LinkageAnalysis : FourBarAnalysis {
  StoredLinkage linkage;
  std::optional<LinkageInstant> instant{};  ///< where it is asked for
};

/// Traced is traced_point().
[[nodiscard]] LinkageAnalysis analyze(const StoredLinkage& linkage);

/// The analysis as JSON text: angles in degrees with `_deg`, columns of the motion by name.
[[nodiscard]] std::string write_analysis(const LinkageAnalysis& analysis);

}  // namespace linkwright
