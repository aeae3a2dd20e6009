#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "files/json/json_writer.hpp"
#include "linkwright/core/notice.hpp"
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
[[nodiscard]] DrawnCurves drawn_curves(const std::vector<PrescribedPose>& poses, const TaskFamily& given, Side side);
/// Of dyads by rising τ, working frame.
[[nodiscard]] DrawnCurves drawn_dyads(std::span<const Dyad> polygon, const std::vector<CurveBranch>& branches,
                                      const WorkingFrame& frame);

/// An axis of a map in its display order, and what people read along it, (τ, value); none: nothing but τ.
struct ShownAxis {
  MapAxis axis;
  DisplayOrder order;
  std::vector<std::array<double, 2>> ticks;
};
struct ShownAxes {
  ShownAxis input, output;
  bool symmetric = true;
  [[nodiscard]] const ShownAxis& of(Side side) const { return side == Side::input ? input : output; }
};
/// Twelve to a branch where the axis has numbers of its own.
[[nodiscard]] std::vector<std::array<double, 2>> axis_ticks(const LinkageFamily& family, Side side);

/// What is said of a task before any linkage is looked for.
struct TaskReply {
  std::string pattern;
  double condition = 1;
  double characteristic_length = 1;  ///< user's unit
  std::vector<Notice> warnings;
  std::function<void(JsonWriter&)> write_curves;    ///< the object `curves`
  std::function<void(JsonWriter&)> write_function;  ///< the object `function`; none: null
};
/// The object `curves` of Burmester curves, or of what the dyads lie along instead.
void write_curves(JsonWriter& json, const TaskFamily& given);
/// The same where there are none.
void write_no_curves(JsonWriter& json);

/// TaskAnswer without its arrays. `reason`: null when solved.
[[nodiscard]] std::string task_json(const TaskReply& task, std::span<const CurveMark> marks, const ShownAxes& axes,
                                    const Requirements& requirements, const LinkageClass& asked,
                                    std::string_view status, const Notice* reason);

}  // namespace linkwright::wasm
