#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace linkwright {

class RegionMap;

/// A number that each cell of a map has. A family says which ones its maps hold; each keeps a column.
struct Measure {
  enum class Stored : std::uint8_t {
    as_it_is,   ///< a number, user's unit
    as_versine  ///< of an angle γ as 1 − cos γ, which keeps its digits at both ends
  };

  std::string_view key;  ///< in result files; measures of the same key are the same
  Stored stored = Stored::as_it_is;
  bool larger_is_better = false;
  bool is_added = false;  ///< by an analysis: no family measures it itself

  friend bool operator==(const Measure& a, const Measure& b) { return a.key == b.key; }
};

namespace measures {
/// Least transmission angle over the task, radians; 0 where a defect or degenerate.
inline constexpr Measure min_transmission_angle{"min_transmission_angle_deg", Measure::Stored::as_versine, true};
/// The same over the full turn of a crank; 0 for other types.
inline constexpr Measure min_transmission_angle_full_turn{"min_transmission_angle_full_turn_deg",
                                                          Measure::Stored::as_versine, true};
/// Longest over shortest link; 0 degenerate.
inline constexpr Measure link_ratio{"link_ratio"};
/// User's unit; 0 degenerate.
inline constexpr Measure longest_link{"longest_link"};
/// Of spherical linkages, radians in [0, π/2]: the least and the largest of the four links' angles, where an angle and
/// its supplement are the same link; 0 degenerate.
inline constexpr Measure min_link_angle{"min_link_angle_deg", Measure::Stored::as_versine, true};
inline constexpr Measure max_link_angle{"max_link_angle_deg", Measure::Stored::as_versine};
/// Of linkages with a straight line, user's unit: length of the line that is usable by its tangent, and by a strip; the
/// largest deviation over the stroke. 0 degenerate.
inline constexpr Measure usable_stroke{"usable_stroke", Measure::Stored::as_it_is, true};
inline constexpr Measure usable_strip{"usable_strip", Measure::Stored::as_it_is, true};
inline constexpr Measure deviation{"deviation"};
/// Usable length over the longest link or arm.
inline constexpr Measure stroke_over_longest{"stroke_over_longest", Measure::Stored::as_it_is, true};
/// (fastest − slowest) / mean of the point's velocity by the input's angle; infinite where the input turns back.
inline constexpr Measure velocity_nonuniformity{"velocity_nonuniformity"};
/// The usable length that counts, by tangent or strip.
inline constexpr Measure usable_length{"usable_length", Measure::Stored::as_it_is, true};
/// 0 where there is nothing, 1 a linkage, 2 one with a slider in place of a link.
inline constexpr Measure valid{"valid"};
/// |K| of the first term K s^k of the deviation that does not vanish; in units of length¹⁻ᵏ.
inline constexpr Measure contact_coefficient{"contact_coefficient"};
/// What tolerances make of the error in the task's positions, to first order: user's unit, of functions and spherical
/// linkages degrees; infinite at a dead point, 0 degenerate.
inline constexpr Measure tolerance_error{.key = "tolerance_error", .is_added = true};
/// Share of sampled linkages that assemble and keep the limit in all positions; NaN where it is not computed.
inline constexpr Measure yield{.key = "yield", .larger_is_better = true, .is_added = true};
/// Under loads, the worst of the cases that count, over the travel: N (at the positions of a map and between them, by
/// LoadMeasures), infinite with a defect. Of opening and closing the hand's largest force and the larger of both, what
/// holds the last position open, the largest force of a pin, the largest torque of the driving crank (N·m), the
/// cylinder's largest force.
inline constexpr Measure max_open_force{.key = "max_open_force", .is_added = true};
inline constexpr Measure max_close_force{.key = "max_close_force", .is_added = true};
inline constexpr Measure hand_force{.key = "hand_force", .is_added = true};
inline constexpr Measure hold_open{.key = "hold_open", .larger_is_better = true, .is_added = true};
inline constexpr Measure max_pin_force{.key = "max_pin_force", .is_added = true};
inline constexpr Measure max_torque{.key = "max_torque", .is_added = true};
inline constexpr Measure cylinder_force{.key = "cylinder_force", .is_added = true};
/// How far the body has turned from position 1, degrees, where it begins to rise by itself to the end, the whole turn
/// where it does not; and from where it closes by itself, 0 where it does not.
inline constexpr Measure self_rise{.key = "self_rise_deg", .is_added = true};
inline constexpr Measure self_close{.key = "self_close_deg", .larger_is_better = true, .is_added = true};
/// Of the hand force, that of looking at stations; and F1 of the spring that leaves it free, with which all others are.
inline constexpr Measure hand_force_error{.key = "hand_force_error", .is_added = true};
inline constexpr Measure best_f1{.key = "best_F1", .is_added = true};
/// Of several linkages at a place the one that is shown, by the number of its layer, from 1.
inline constexpr Measure layer{"layer"};
/// Of paths that pass near points: root mean square of the distances of the points from the path, or the
/// largest of them where that is to be least; user's unit.
inline constexpr Measure path_error{"path_error"};
/// Of motions past near poses: root mean square of the errors there, √(d² + (L Δθ)²) each, user's unit; infinite where
/// near poses are out of order, or past a dead point, though the exact ones are not.
inline constexpr Measure near_error{.key = "near_error", .is_added = true};
/// Angle that the driver turns from the first to the last position; every map computes it, none keeps it.
inline constexpr Measure driver_sweep{"driver_sweep_deg"};
}  // namespace measures

/// The measure of each cell of a row as files and pages have it: angles in degrees, 0 where it is not defined, never
/// NaN or infinite. `values` has a place for each column; `measure` is one of reported_measures(map).
void row_values(const RegionMap& map, const Measure& measure, std::size_t row, std::span<float> values);

/// One stored value as files and pages have it: angles in degrees.
[[nodiscard]] double readable_value(const Measure& measure, double stored);

/// γ from 1 − cos γ, radians.
[[nodiscard]] double angle_of_versine(double versine);
/// 1 − cos γ.
[[nodiscard]] double versine_of_angle(double angle);

}  // namespace linkwright
