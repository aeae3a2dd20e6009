#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "linkwright/planar/curve_marks.hpp"
#include "linkwright/planar/display_order.hpp"
#include "linkwright/planar/task_family.hpp"
#include "linkwright/region/requirements.hpp"

namespace linkwright::wasm {

/// The curves of a task as the page draws them: dyads by rising τ, homogeneous unit vectors (w, x, y), fixed frame.
struct DrawnCurves {
  std::vector<double> tau, center, circle;
  std::vector<std::uint8_t> branch;
  std::vector<CurveMark> marks;
};
[[nodiscard]] DrawnCurves drawn_curves(const std::vector<PrescribedPose>& poses, const TaskFamily& given,
                                       LinkageFamily::Side side);

/// The two axes of a map, each in its display order.
struct MapOrders {
  DisplayOrder input, output;
  [[nodiscard]] const DisplayOrder& of(LinkageFamily::Side side) const {
    return side == LinkageFamily::Side::input ? input : output;
  }
};

/// TaskAnswer without its arrays. `reason`: null when solved.
[[nodiscard]] std::string task_json(const TaskFamily& given, std::span<const CurveMark> marks, const MapOrders& orders,
                                    const Requirements& requirements, std::string_view status, const Notice* reason);

}  // namespace linkwright::wasm
