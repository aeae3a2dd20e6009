#include "linkwright/region/criterion.hpp"

#include <array>

#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

using Rule = Criterion::Rule;
using Unit = Criterion::Unit;
constexpr double unlimited = Requirements::unlimited;

constexpr std::array<Criterion, requirement_kind_count> all_criteria = {{
    {.kind = RequirementKind::types,
     .key = "types",
     .about = "Wanted types; none or null: any. Triple rockers are told by their longest link in the plane, on the "
              "sphere they are one type.",
     .rule = Rule::one_of_types,
     .unit = Unit::number,
     .asked = &Requirements::types,
     .name = "type"},
    {.kind = RequirementKind::no_defects,
     .key = "no_defects",
     .about = "Neither order nor branch nor circuit defect.",
     .rule = Rule::without_defects,
     .unit = Unit::number,
     .asked = &Requirements::no_defects,
     .name = "no defects"},
    {.kind = RequirementKind::min_transmission_angle,
     .key = "min_transmission_angle_deg",
     .about = "Least transmission angle over the task.",
     .rule = Rule::at_least,
     .unit = Unit::angle,
     .asked = &Requirements::min_transmission_angle,
     .name = "transmission angle over the task",
     .as_advice = "A transmission angle",
     .of = &measures::min_transmission_angle,
     .range = {.high = pi / 2, .with_high = false},
     .range_code = "transmission_angle_range",
     .range_sentence =
         "the transmission angle lies between 0 and 90 degrees, 90 itself is never kept; 30 to 50 is usual"},
    {.kind = RequirementKind::max_link_ratio,
     .key = "max_link_ratio",
     .about = "Longest over shortest of the four links.",
     .rule = Rule::at_most,
     .unit = Unit::number,
     .asked = &Requirements::max_link_ratio,
     .name = "link ratio",
     .as_advice = "A link ratio",
     .of = &measures::link_ratio,
     .any = unlimited,
     .range = {.low = 1},
     .range_code = "link_ratio_range",
     .range_sentence = "the longest over the shortest link is at least 1"},
    {.kind = RequirementKind::max_length,
     .key = "max_length",
     .about = "Longest of the four links; default 10 times the task's characteristic length, which is seen from "
              "position 1: give a length where the positions may also be passed the other way round.",
     .rule = Rule::at_most,
     .unit = Unit::length,
     .asked = &Requirements::max_length,
     .name = "longest link",
     .as_advice = "A longest link",
     .of = &measures::longest_link,
     .any = unlimited,
     .has_default = true,
     .range = {.with_low = false},
     .range_code = "max_length_range",
     .range_sentence = "the longest link must be allowed a positive length"},
    {.kind = RequirementKind::min_length,
     .key = "min_length",
     .about = "Shortest of the four links; default a thousandth of the task's characteristic length, or of max_length "
              "where that is shorter. null: any.",
     .rule = Rule::at_least,
     .unit = Unit::length,
     .asked = &Requirements::min_length,
     .name = "shortest link",
     .as_advice = "A shortest link",
     .of = &measures::longest_link,
     .per = &measures::link_ratio,
     .has_default = true,
     .range = {.with_high = false},
     .range_code = "min_length_range",
     .range_sentence = "the shortest link must be a positive length; null lets any length pass"},
    {.kind = RequirementKind::ground_pivots_within,
     .key = "ground_pivots_within",
     .about = "Both fixed pivots.",
     .rule = Rule::ground_inside,
     .unit = Unit::length,
     .asked = &Requirements::ground_pivots_within,
     .name = "fixed pivots"},
    {.kind = RequirementKind::moving_pivots_within,
     .key = "moving_pivots_within",
     .about = "Both moving pivots, in position 1; in position 2 where \"freed_pose\" is 1.",
     .rule = Rule::moving_inside,
     .unit = Unit::length,
     .asked = &Requirements::moving_pivots_within,
     .name = "moving pivots"},
    {.kind = RequirementKind::min_link_angle,
     .key = "min_link_angle_deg",
     .about = "Spherical linkages: least of the four links' angles, an angle and its supplement being the same link.",
     .rule = Rule::at_least,
     .unit = Unit::angle,
     .asked = &Requirements::min_link_angle,
     .name = "link angles",
     .as_advice = "Link angles",
     .of = &measures::min_link_angle,
     .has_default = true,
     .range = {.high = pi / 2, .with_high = false},
     .range_code = "min_link_angle_range",
     .range_sentence =
         "the least link angle lies between 0 and 90 degrees, 90 itself is never kept; null lets any pass"},
    {.kind = RequirementKind::max_link_angle,
     .key = "max_link_angle_deg",
     .about = "Spherical linkages: largest of the four links' angles, as for the least.",
     .rule = Rule::at_most,
     .unit = Unit::angle,
     .asked = &Requirements::max_link_angle,
     .name = "link angles",
     .as_advice = "Link angles",
     .of = &measures::max_link_angle,
     .any = pi,
     .range = {.high = pi / 2, .with_low = false},
     .range_code = "max_link_angle_range",
     .range_sentence = "the largest link angle lies above 0 and is at most 90 degrees: a link and its supplement are "
                       "the same; null lets any pass"},
    {.kind = RequirementKind::fixed_axes_within,
     .key = "fixed_axes_within",
     .about = "Spherical linkages: both fixed axes.",
     .rule = Rule::ground_inside,
     .unit = Unit::angle,
     .asked = &Requirements::fixed_axes_within,
     .name = "fixed axes"},
    {.kind = RequirementKind::moving_axes_within,
     .key = "moving_axes_within",
     .about = "Spherical linkages: both moving axes, in position 1.",
     .rule = Rule::moving_inside,
     .unit = Unit::angle,
     .asked = &Requirements::moving_axes_within,
     .name = "moving axes"},
    {.kind = RequirementKind::min_stroke,
     .key = "min_stroke",
     .about = "Straight lines: least usable length.",
     .rule = Rule::at_least,
     .unit = Unit::length,
     .asked = &Requirements::min_stroke,
     .name = "usable length",
     .as_advice = "A usable length",
     .of = &measures::usable_length,
     .range = {.with_high = false},
     .range_code = "min_stroke_range",
     .range_sentence = "the least stroke must be a positive length, or 0 for any"},
    {.kind = RequirementKind::max_deviation,
     .key = "max_deviation",
     .about =
         "Straight lines: largest deviation over the stroke, or over the usable length where no stroke is asked for.",
     .rule = Rule::at_most,
     .unit = Unit::length,
     .asked = &Requirements::max_deviation,
     .name = "deviation",
     .as_advice = "A deviation",
     .of = &measures::deviation,
     .any = unlimited,
     .lets_infinite_pass = false,
     .range = {.with_low = false},
     .range_code = "max_deviation_range",
     .range_sentence =
         "the largest deviation must be a positive length; null lets any pass"},  // a straight line that does not go as
                                                                                  // far as its stroke
    {.kind = RequirementKind::full_turn,
     .key = "full_turn",
     .about = "Paths: the crank turns fully, so that the path is closed.",
     .rule = Rule::turning_fully,
     .unit = Unit::number,
     .asked = &Requirements::full_turn,
     .name = "full turn of the crank"},
    {.kind = RequirementKind::max_path_error,
     .key = "max_path_error",
     .about = "Paths near their points: root mean square of the distances of the points from the path, or the largest "
              "of them where that is to be least.",
     .rule = Rule::at_most,
     .unit = Unit::length,
     .asked = &Requirements::max_path_error,
     .name = "distance from the points",
     .as_advice = "A distance from the points",
     .of = &measures::path_error,
     .any = unlimited,
     .range = {.with_low = false},
     .range_code = "max_path_error_range",
     .range_sentence = "the distance from the points must be above 0; null lets any pass"},
    {.kind = RequirementKind::max_near_error,
     .key = "max_near_error",
     .about =
         "Motions past near poses: root mean square of the errors there, user's unit; an error of angle counts by the "
         "turning length.",
     .rule = Rule::at_most,
     .unit = Unit::length,
     .asked = &Requirements::max_near_error,
     .name = "error at the near poses",
     .as_advice = "An error at the near poses",
     .of = &measures::near_error,
     .any = unlimited,
     .range = {.with_low = false},
     .range_code = "max_near_error_range",
     .range_sentence = "the error at the near poses must be above 0; null lets any pass"},
    {.kind = RequirementKind::max_tolerance_error,
     .key = "max_tolerance_error",
     .about = "Largest error by tolerances, in their unit: the user's length; of functions and spherical linkages "
              "degrees. Needs tolerances; off where it is not given.",
     .rule = Rule::at_most,
     .unit = Unit::number,  // a length, or degrees
     .asked = &Requirements::max_tolerance_error,
     .name = "error by tolerances",
     .of = &measures::tolerance_error,
     .any = unlimited,
     .range = {.with_low = false},
     .range_code = "max_tolerance_error_range",
     .range_sentence = "the largest error by tolerances must be above 0; null lets any pass"},
    {.kind = RequirementKind::min_yield,
     .key = "min_yield",
     .about = "Least share of sampled linkages that assemble and keep the limit in all positions. Needs tolerances "
              "with a limit; off where it is not given.",
     .rule = Rule::at_least,
     .unit = Unit::share,
     .asked = &Requirements::min_yield,
     .name = "yield",
     .of = &measures::yield,
     .range = {.high = 1},
     .range_code = "min_yield_range",
     .range_sentence = "a yield is a share between 0 and 1: 0.99 asks for 99 good linkages of 100; null lets any pass"},
    {.kind = RequirementKind::max_open_force,
     .key = "max_open_force",
     .about = "Loads: largest force of the hand while opening, N; a negative one: it is never needed.",
     .rule = Rule::at_most,
     .unit = Unit::force,
     .asked = &Requirements::max_open_force,
     .name = "opening force",
     .as_advice = "An opening force",
     .of = &measures::max_open_force,
     .any = unlimited,
     .lets_infinite_pass = false,
     .range = {.low = -unlimited, .with_low = false},
     .range_code = "force_range",
     .range_sentence = "a force is a number of newtons; null lets any pass"},
    {.kind = RequirementKind::max_close_force,
     .key = "max_close_force",
     .about = "Loads: largest force of the hand while closing, N.",
     .rule = Rule::at_most,
     .unit = Unit::force,
     .asked = &Requirements::max_close_force,
     .name = "closing force",
     .as_advice = "A closing force",
     .of = &measures::max_close_force,
     .any = unlimited,
     .lets_infinite_pass = false,
     .range = {.low = -unlimited, .with_low = false},
     .range_code = "force_range",
     .range_sentence = "a force is a number of newtons; null lets any pass"},
    {.kind = RequirementKind::min_hold_open,
     .key = "min_hold_open",
     .about = "Loads: least force that holds the last position open, N: with it the body still rises by itself.",
     .rule = Rule::at_least,
     .unit = Unit::force,
     .asked = &Requirements::min_hold_open,
     .name = "hold-open force",
     .as_advice = "A hold-open force",
     .of = &measures::hold_open,
     .any = -unlimited,
     .range = {.low = -unlimited, .with_high = false},
     .range_code = "force_range",
     .range_sentence = "a force is a number of newtons; null lets any pass"},
    {.kind = RequirementKind::max_pin_force,
     .key = "max_pin_force",
     .about = "Loads: largest force of a pin, N.",
     .rule = Rule::at_most,
     .unit = Unit::force,
     .asked = &Requirements::max_pin_force,
     .name = "pin force",
     .as_advice = "A pin force",
     .of = &measures::max_pin_force,
     .any = unlimited,
     .lets_infinite_pass = false,
     .range = {.with_low = false},
     .range_code = "load_limit_range",
     .range_sentence = "the largest force or torque must be above 0; null lets any pass"},
    {.kind = RequirementKind::max_torque,
     .key = "max_torque",
     .about = "Loads, driven by a crank: its largest torque, N·m.",
     .rule = Rule::at_most,
     .unit = Unit::torque,
     .asked = &Requirements::max_torque,
     .name = "driving torque",
     .as_advice = "A driving torque",
     .of = &measures::max_torque,
     .any = unlimited,
     .lets_infinite_pass = false,
     .range = {.with_low = false},
     .range_code = "load_limit_range",
     .range_sentence = "the largest force or torque must be above 0; null lets any pass"},
}};

constexpr bool are_by_kind() {
  for (std::size_t k = 0; k < all_criteria.size(); ++k)
    if (static_cast<std::size_t>(all_criteria[k].kind) != k) return false;
  return true;
}
static_assert(are_by_kind());

}  // namespace

std::vector<RequirementKind> kinds_of(FailureBits failures, RequirementKinds kinds) {
  std::vector<RequirementKind> found;
  for (std::size_t k = 0; k < kinds.size(); ++k)
    if ((failures >> k & 1) != 0) found.push_back(kinds[k]);
  return found;
}

std::span<const Criterion, requirement_kind_count> criteria() { return all_criteria; }

std::optional<double> Criterion::given(const Requirements& wanted) const {
  if (const auto* number = std::get_if<double Requirements::*>(&asked)) return wanted.**number;
  if (const auto* number = std::get_if<std::optional<double> Requirements::*>(&asked)) return wanted.**number;
  return std::nullopt;
}

void Criterion::set(Requirements& wanted, double limit) const {
  if (const auto* number = std::get_if<double Requirements::*>(&asked)) wanted.** number = limit;
  if (const auto* number = std::get_if<std::optional<double> Requirements::*>(&asked)) wanted.** number = limit;
}

double Criterion::limit(const Requirements& wanted) const { return given(wanted).value_or(any); }

std::optional<PivotWindow> Criterion::window(const Requirements& wanted) const {
  if (const auto* box = std::get_if<std::optional<Box> Requirements::*>(&asked)) return wanted.**box;
  if (const auto* cone = std::get_if<std::optional<Cone> Requirements::*>(&asked)) return wanted.**cone;
  return std::nullopt;
}

bool Criterion::is_asked(const Requirements& wanted) const {
  return window(wanted) || (rule == Rule::turning_fully && wanted.full_turn) ||
         (has_limit(wanted) && limit(wanted) != limit(Requirements{}));
}

}  // namespace linkwright
