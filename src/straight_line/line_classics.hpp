#pragma once

#include <vector>

#include "linkwright/straight_line/line_shape.hpp"

namespace linkwright {

/// Linkages of the textbooks by their published proportions, of a kind of shape, each the first of its shape: with
/// them, too, a search begins (E. S. Ferguson, Kinematics of Mechanisms from the Time of Watt, 1962; R. L. Norton,
/// Design of Machinery). Where the classical line is the middle of three tangents or crosses the path, it is so here.
[[nodiscard]] std::vector<LineShape> line_classics(ShapeKind kind);

}  // namespace linkwright
