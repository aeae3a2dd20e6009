#pragma once

#include <string>

#include "linkwright/files/linkage_file.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/files/six_bar_file.hpp"
#include "linkwright/synthesis/answer.hpp"

namespace linkwright {

/// An answer as one picture (SVG, 1440 × 900): the poses with both Burmester curves and the best linkage; the solution
/// region by type; the best linkage's numbers. Below 300 kB at any number of samples.
[[nodiscard]] std::string draw_answer(const Problem& problem, const Answer& answer);

/// One linkage as a picture (SVG, 1000 × 800): its positions, its dimensions, its coupler curve.
[[nodiscard]] std::string draw_linkage(const StoredLinkage& linkage);

/// One six-bar as a picture of the same size: its positions, the path of the moving frame, its hinges and lengths.
[[nodiscard]] std::string draw_linkage(const StoredSixBar& linkage);

/// One spherical four-bar as a picture of the same size.
[[nodiscard]] std::string draw_linkage(const StoredSphericalFourBar& linkage);

}  // namespace linkwright
