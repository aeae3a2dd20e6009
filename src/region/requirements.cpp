#include "linkwright/region/requirements.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

void check_box(const std::optional<Box>& box, const char* place, std::vector<Error>& found) {
  if (!box) return;
  const auto check = [&](double low, double high, const char* axis) {
    const std::string where = std::string(place) + "." + axis;
    if (!std::isfinite(low) || !std::isfinite(high))
      found.push_back({"limits_finite", where, "the limits must be finite numbers"});
    else if (low > high)
      found.push_back({"limits_order", where, "the lower limit is above the upper one; write them as [low, high]"});
  };
  check(box->x_low, box->x_high, "x");
  check(box->y_low, box->y_high, "y");
}

void check_cone(const std::optional<Cone>& cone, const char* place, std::vector<Error>& found) {
  if (!cone) return;
  const std::string where(place);
  if (!is_finite(cone->axis))
    found.push_back({"axis_finite", where + ".axis", "the coordinates of the axis must be finite numbers"});
  else if (cone->axis == Vector3{})
    found.push_back({"axis_null", where + ".axis", "a null vector has no direction; give the axis of the cone"});
  if (!(cone->half_angle > 0 && cone->half_angle <= pi / 2))
    found.push_back({"half_angle_range", where + ".half_angle_deg",
                     "the half-angle of the cone lies above 0 and is at most 90 degrees, which leaves no line out"});
}

void check_link_angles(const Requirements& wanted, std::vector<Error>& found) {
  if (wanted.min_link_angle && !(*wanted.min_link_angle >= 0 && *wanted.min_link_angle < pi / 2))
    found.push_back(
        {"min_link_angle_range", "requirements.min_link_angle_deg",
         "the least link angle lies between 0 and 90 degrees, 90 itself is never kept; null lets any pass"});
  if (wanted.max_link_angle && !(*wanted.max_link_angle > 0 && *wanted.max_link_angle <= pi / 2))
    found.push_back({"max_link_angle_range", "requirements.max_link_angle_deg",
                     "the largest link angle lies above 0 and is at most 90 degrees: a link and its supplement are the "
                     "same; null lets any pass"});
  if (wanted.min_link_angle && wanted.max_link_angle && *wanted.min_link_angle > *wanted.max_link_angle)
    found.push_back({"min_link_angle_order", "requirements.min_link_angle_deg",
                     "the least link angle is above the largest; lower it, or raise the largest"});
}

}  // namespace

Requirements with_default_lengths(Requirements wanted, double size) {
  if (!wanted.min_length) wanted.min_length = default_min_length * std::min(size, wanted.max_length.value_or(size));
  if (!wanted.max_length) wanted.max_length = std::max(default_max_length * size, *wanted.min_length);
  return wanted;
}

std::vector<Error> mistakes_in(const Requirements& wanted) {
  std::vector<Error> found;
  const auto mistake = [&](const char* code, const char* place, const char* message) {
    found.push_back({code, place, message});
  };
  for (const LinkageType type : wanted.types)
    if (type == LinkageType::degenerate)
      mistake("degenerate_wanted", "requirements.types",
              "a degenerate linkage cannot be wanted; name some of the others");
  if (!(wanted.min_transmission_angle >= 0 && wanted.min_transmission_angle < pi / 2))
    mistake("transmission_angle_range", "requirements.min_transmission_angle_deg",
            "the transmission angle lies between 0 and 90 degrees, 90 itself is never kept; 30 to 50 is usual");
  if (wanted.min_transmission_angle > 0 && !wanted.no_defects)
    mistake("transmission_angle_of_defects", "requirements.min_transmission_angle_deg",
            "the transmission angle over the task is defined only where there is no defect; drop it or set no_defects "
            "to true");
  if (!(wanted.max_link_ratio >= 1))
    mistake("link_ratio_range", "requirements.max_link_ratio", "the longest over the shortest link is at least 1");
  if (wanted.max_length && !(*wanted.max_length > 0))
    mistake("max_length_range", "requirements.max_length", "the longest link must be allowed a positive length");
  if (wanted.min_length && !(*wanted.min_length >= 0 && std::isfinite(*wanted.min_length)))
    mistake("min_length_range", "requirements.min_length",
            "the shortest link must be a positive length; null lets any length pass");
  if (wanted.min_length && wanted.max_length && *wanted.min_length > *wanted.max_length)
    mistake("min_length_order", "requirements.min_length",
            "the shortest link is asked to be longer than max_length lets any be; lower it, or raise max_length");
  check_box(wanted.ground_pivots_within, "requirements.ground_pivots_within", found);
  check_box(wanted.moving_pivots_within, "requirements.moving_pivots_within", found);
  check_link_angles(wanted, found);
  check_cone(wanted.fixed_axes_within, "requirements.fixed_axes_within", found);
  check_cone(wanted.moving_axes_within, "requirements.moving_axes_within", found);
  if (!(wanted.min_stroke >= 0 && std::isfinite(wanted.min_stroke)))
    mistake("min_stroke_range", "requirements.min_stroke", "the least stroke must be a positive length, or 0 for any");
  if (!(wanted.max_deviation > 0))
    mistake("max_deviation_range", "requirements.max_deviation",
            "the largest deviation must be a positive length; null lets any pass");
  if (!(wanted.max_tolerance_error > 0))
    mistake("max_tolerance_error_range", "requirements.max_tolerance_error",
            "the largest error by tolerances must be above 0; null lets any pass");
  if (!(wanted.min_yield >= 0 && wanted.min_yield <= 1))
    mistake("min_yield_range", "requirements.min_yield",
            "a yield is a share between 0 and 1: 0.99 asks for 99 good linkages of 100; null lets any pass");
  return found;
}

}  // namespace linkwright
