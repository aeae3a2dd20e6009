#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "linkwright/algebra/circular_cubic.hpp"
#include "linkwright/algebra/cubic_cone.hpp"
#include "linkwright/mechanism/defects.hpp"
#include "linkwright/mechanism/linkage_type.hpp"
#include "linkwright/mechanism/position.hpp"
#include "linkwright/mechanism/six_bar.hpp"

namespace linkwright {

// The words that people read, in tables and drawings, for the words of the files.

/// "Crank-rocker", "Triple rocker, input longest", "Slider or zero link", …
[[nodiscard]] std::string_view label(LinkageType type);

/// At most 22 characters: "Triple rocker, input", …
[[nodiscard]] std::string_view short_label(LinkageType type);

/// "counter-clockwise", "clockwise", "either way"; empty for none.
[[nodiscard]] std::string_view label(DriveSense sense);

/// "two branches", "a line and a circle", …
[[nodiscard]] std::string_view label(CubicKind kind);

/// "a cubic cone of one component", "a plane and a quadratic cone", …
[[nodiscard]] std::string_view label(CubicConeKind kind);

/// Of a CurveBranch's name: "branch through infinity", "closed branch", …
[[nodiscard]] std::string_view branch_label(std::string_view name);
/// Of one on the sphere: "odd branch", "oval", …
[[nodiscard]] std::string_view cone_branch_label(std::string_view name);

/// Of what is made with a tolerance: "input's fixed pivot, x", "coupler", …
[[nodiscard]] std::string dimension_label(std::string_view name);

/// "Watt I", "Stephenson II", …
[[nodiscard]] std::string_view label(SixBarTopology topology);

/// "parallelogram or kite", … as Barker divides change points; empty for none.
[[nodiscard]] std::string_view label(ChangePointKind kind);

/// Where an input can be: "the input rocks from … to …", without a full stop.
[[nodiscard]] std::string range_sentence(const std::vector<AngleRange>& ranges);

}  // namespace linkwright
