#pragma once

#include <string>
#include <string_view>

#include "linkwright/planar/four_bar_family.hpp"
#include "linkwright/synthesis/task.hpp"

namespace linkwright {

/// How an axis of a map is spoken of.
struct AxisLabel {
  std::string name;   ///< in files: "input side link, place on its curve"
  std::string title;  ///< at the axis of a drawing: "Driving side link, τ₁"
  std::string unit;   ///< tau, deg, the user's unit of length, or 1
};
[[nodiscard]] AxisLabel axis_label(const MapAxis& axis, Side side, const Task& task, std::string_view length_unit);

/// The numbers along the axis are read, not τ itself.
[[nodiscard]] bool has_values(AxisQuantity quantity);

}  // namespace linkwright
