#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "linkwright/region/map_axis.hpp"

namespace linkwright {

/// How an axis of a map is spoken of; the kinds give theirs by axis_label().
struct AxisLabel {
  std::string name;           ///< in files: "input link, place on its curve"
  std::string title;          ///< at the axis of a drawing: "Driving grounded link, τ₁"
  std::string unit;           ///< tau, deg, the user's unit of length, or 1
  std::string_view quantity;  ///< in files
  std::vector<CurveBranch> branches;
};

/// The numbers along the axis are read, not τ itself.
[[nodiscard]] bool has_values(AxisQuantity quantity);

}  // namespace linkwright
