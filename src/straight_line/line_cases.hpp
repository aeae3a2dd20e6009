#pragma once

#include <array>
#include <variant>
#include <vector>

#include "linkwright/region/map_axis.hpp"
#include "linkwright/straight_line/line_design.hpp"
#include "linkwright/straight_line/line_shape.hpp"
#include "linkwright/straight_line/straight_line_task.hpp"

namespace linkwright {

/// An axis of a case's map.
struct LineAxis {
  AxisQuantity quantity = AxisQuantity::nothing;
  double low = 0, high = 0;  ///< radians or user's unit
};

/// A number along an axis; of an angle its direction beside it, so that a row and a column take it once.
struct LineAxisValue {
  double value = 0;
  Point direction{1, 0};  ///< e^{i value} of an angle
};
[[nodiscard]] LineAxisValue line_axis_value(const LineAxis& axis, double value);

/// The linkages of one place; as many of the first as the case has layers.
using LineDesigns = std::array<LineDesign, 3>;

/// The case's axes at their full ranges, lengths over ± 4 times the task's size.
[[nodiscard]] std::array<LineAxis, 2> axes_of(const StraightLineTask& task);
/// How many linkages a place may have.
[[nodiscard]] int layers_of(const StraightLineCase& given);
/// What of two layers the linkages are, in files: "alpha", "alpha_plus_90", "AB", …; empty where there is one.
[[nodiscard]] std::string_view layer_name(const StraightLineCase& given, int layer);

/// The linkages of a case at a place, without trigonometry. Formulas: docs/theory/straight_lines.md.
[[nodiscard]] LineDesigns designs_at(const StraightLineTask& task, LineAxisValue first, LineAxisValue second);

/// Linkages of the textbooks by their published proportions, of a kind of shape, each the first of its shape: with
/// them, too, a search begins (E. S. Ferguson, Kinematics of Mechanisms from the Time of Watt, 1962; R. L. Norton,
/// Design of Machinery). Where the classical line is the middle of three tangents or crosses the path, it is so here.
[[nodiscard]] std::vector<LineShape> line_classics(ShapeKind kind);

}  // namespace linkwright
