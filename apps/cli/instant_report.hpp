#pragma once

#include <string>

#include "linkwright/files/analysis_file.hpp"

namespace linkwright::cli {

/// What one instant tells, in words for people.
[[nodiscard]] std::string instant_words(const LinkageAnalysis& analysis);
[[nodiscard]] std::string instant_words(const PrescribedInstant& instant);

}  // namespace linkwright::cli
