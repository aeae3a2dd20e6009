#include "linkwright/region/requirements.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <string>

#include "linkwright/core/angle.hpp"
#include "linkwright/region/criterion.hpp"

namespace linkwright {
namespace {

void check(const Box& box, const std::string& place, std::vector<Error>& found) {
  const auto check_limits = [&](double low, double high, const char* axis) {
    const std::string where = place + "." + axis;
    if (!std::isfinite(low) || !std::isfinite(high))
      found.push_back({"limits_finite", where, "the limits must be finite numbers"});
    else if (low > high)
      found.push_back({"limits_order", where, "the lower limit is above the upper one; write them as [low, high]"});
  };
  check_limits(box.x_low, box.x_high, "x");
  check_limits(box.y_low, box.y_high, "y");
}

void check(const Cone& cone, const std::string& place, std::vector<Error>& found) {
  if (!is_finite(cone.axis))
    found.push_back({"axis_finite", place + ".axis", "the coordinates of the axis must be finite numbers"});
  else if (cone.axis == Vector3{})
    found.push_back({"axis_null", place + ".axis", "a null vector has no direction; give the axis of the cone"});
  if (!(cone.half_angle > 0 && cone.half_angle <= pi / 2))
    found.push_back({"half_angle_range", place + ".half_angle_deg",
                     "the half-angle of the cone lies above 0 and is at most 90 degrees, which leaves no line out"});
}

bool is_above(const std::optional<double>& least, const std::optional<double>& largest) {
  return least && largest && *least > *largest;
}

// Beside its range: what contradicts another.
std::optional<Error> contradiction(const Criterion& asked, const Requirements& wanted, const std::string& place) {
  if (asked.kind == RequirementKind::types &&
      std::find(wanted.types.begin(), wanted.types.end(), LinkageType::degenerate) != wanted.types.end())
    return Error{"degenerate_wanted", place, "a degenerate linkage cannot be wanted; name some of the others"};
  if (asked.kind == RequirementKind::min_transmission_angle && wanted.min_transmission_angle > 0 && !wanted.no_defects)
    return Error{"transmission_angle_of_defects", place,
                 "the transmission angle over the task is defined only where there is no defect; drop it or set "
                 "no_defects to true"};
  if (asked.kind == RequirementKind::min_length && is_above(wanted.min_length, wanted.max_length))
    return Error{"min_length_order", place,
                 "the shortest link is asked to be longer than max_length lets any be; lower it, or raise max_length"};
  if (asked.kind == RequirementKind::max_link_angle && is_above(wanted.min_link_angle, wanted.max_link_angle))
    return Error{"min_link_angle_order", fmt::format("requirements.{}", key(RequirementKind::min_link_angle)),
                 "the least link angle is above the largest; lower it, or raise the largest"};
  return std::nullopt;
}

}  // namespace

Requirements with_default_lengths(Requirements wanted, double size) {
  if (!wanted.min_length) wanted.min_length = default_min_length * std::min(size, wanted.max_length.value_or(size));
  if (!wanted.max_length) wanted.max_length = std::max(default_max_length * size, *wanted.min_length);
  return wanted;
}

std::vector<Error> mistakes_in(const Requirements& wanted) {
  std::vector<Error> found;
  for (const Criterion& asked : criteria()) {
    const std::string place = fmt::format("requirements.{}", asked.key);
    if (const auto given = asked.given(wanted); given && !asked.range.contains(*given))
      found.push_back({std::string(asked.range_code), place, std::string(asked.range_sentence)});
    if (const auto window = asked.window(wanted))
      std::visit([&](const auto& of_shape) { check(of_shape, place, found); }, *window);
    if (auto mistake = contradiction(asked, wanted, place)) found.push_back(*std::move(mistake));
  }
  return found;
}

}  // namespace linkwright
