#pragma once

#include <functional>

#include "dxf_groups.hpp"
#include "strokes.hpp"

namespace linkwright {

/// The points of a rational spline; none where its knots do not fit its control points. A step for each of its spans.
[[nodiscard]] std::vector<Point> spline_points(const DxfEntity& spline, const std::function<Point(Point)>& place,
                                               StrokeCollector& collector);

}  // namespace linkwright
