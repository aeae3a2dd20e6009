#pragma once

#include <string>

#include "linkwright/files/analysis_file.hpp"

namespace linkwright {

/// One instant as a picture (SVG, 1000 × 800): the linkage, pole, pole tangent and normal, inflection, return and
/// Bresse circles, circling-point and centering-point curves, Ball's point, Burmester points, and the centre of
/// curvature of the point that was asked for. `analysis` has an instant.
[[nodiscard]] std::string draw_instant(const LinkageAnalysis& analysis);

/// The same of a body in a prescribed pose.
[[nodiscard]] std::string draw_instant(const PrescribedInstant& instant);

}  // namespace linkwright
