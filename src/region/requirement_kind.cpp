#include "linkwright/region/requirement_kind.hpp"

namespace linkwright {
namespace {

constexpr std::array<std::string_view, requirement_kind_count> requirement_keys = {"types",
                                                                                   "no_defects",
                                                                                   "min_transmission_angle_deg",
                                                                                   "max_link_ratio",
                                                                                   "max_length",
                                                                                   "min_length",
                                                                                   "ground_pivots_within",
                                                                                   "moving_pivots_within",
                                                                                   "min_link_angle_deg",
                                                                                   "max_link_angle_deg",
                                                                                   "fixed_axes_within",
                                                                                   "moving_axes_within",
                                                                                   "min_stroke",
                                                                                   "max_deviation",
                                                                                   "max_tolerance_error",
                                                                                   "min_yield"};

}  // namespace

std::string_view key(RequirementKind kind) { return requirement_keys[static_cast<std::size_t>(kind)]; }

bool is_angle(RequirementKind kind) {
  switch (kind) {
    case RequirementKind::min_transmission_angle:
    case RequirementKind::min_link_angle:
    case RequirementKind::max_link_angle:
    case RequirementKind::fixed_axes_within:
    case RequirementKind::moving_axes_within:
      return true;
    default:
      return false;
  }
}

}  // namespace linkwright
