#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "linkwright/files/spherical_file.hpp"
#include "linkwright/synthesis/answer.hpp"
#include "linkwright/synthesis/problem.hpp"

namespace linkwright::cli {

/// What is found for a task of spherical four-bars, for people; `problem` with printable text.
[[nodiscard]] std::string spherical_report(const Problem& problem, const SphericalMotionAnswer& answer);

/// Type, drive and angles of linkages, numbered from 1.
[[nodiscard]] std::string spherical_table(const std::vector<SphericalSolution>& all);

/// The analysis of one spherical four-bar in words for people; `drive`: which of the file's grounded links is the
/// input.
[[nodiscard]] std::string spherical_words(const StoredSphericalAnalysis& analysis, std::string_view drive);

}  // namespace linkwright::cli
