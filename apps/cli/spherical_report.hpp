#pragma once

#include <string>

#include "linkwright/files/spherical_file.hpp"
#include "linkwright/synthesis/answer.hpp"
#include "linkwright/synthesis/problem.hpp"

namespace linkwright::cli {

/// What is found for a task of spherical four-bars, for people; `problem` with printable text.
[[nodiscard]] std::string spherical_report(const Problem& problem, const SphericalMotionAnswer& answer);

/// What a spherical four-bar does, for people.
[[nodiscard]] std::string spherical_words(const StoredSphericalAnalysis& analysis);

}  // namespace linkwright::cli
