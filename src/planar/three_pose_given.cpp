#include "linkwright/planar/three_pose_given.hpp"

#include <cmath>
#include <fmt/format.h>
#include <string>
#include <string_view>

#include "core/number_check.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/count_text.hpp"
#include "linkwright/core/precondition.hpp"
#include "linkwright/core/tolerance.hpp"
#include "linkwright/planar/motion_task.hpp"
#include "planar/line_check.hpp"

namespace linkwright {
namespace {

void check_length(double length, const std::string& place, std::vector<Error>& found) {
  if (length > 0 && length <= largest_coordinate) return;
  found.push_back(
      {"side_length_range",
       place,
       fmt::format(
           "the length of a grounded link is a number above 0 and up to {}; give the distance from its fixed to "
           "its moving pivot",
           limit_text(largest_coordinate)),
       {{"most", limit_text(largest_coordinate)}}});
}

void check(const SideLengths& given, std::vector<Error>& found) {
  check_length(given.input, given.output ? "task.given.side_lengths[0]" : "task.given.side_length", found);
  if (given.output) check_length(*given.output, "task.given.side_lengths[1]", found);
}

void check(const SideAngle& given, std::vector<Error>& found) {
  if (!(std::abs(given.angle) <= radians(largest_coordinate)))
    found.push_back({"side_angle_range",
                     "task.given.side_angle_deg",
                     fmt::format("the angle between the grounded links is a number between −{0} and {0} degrees",
                                 limit_text(largest_coordinate)),
                     {{"most", limit_text(largest_coordinate)}}});
  if (given.input_length) check_length(*given.input_length, "task.given.input_length", found);
}

void check(const InstantCenter& given, std::vector<Error>& found) {
  if (!(std::abs(given.point.real()) <= largest_coordinate && std::abs(given.point.imag()) <= largest_coordinate))
    found.push_back({"center_range",
                     "task.given.instant_center",
                     fmt::format("coordinates lie between −{0} and {0}; a centre at infinity is given by the "
                                 "direction in which it lies",
                                 limit_text(largest_coordinate)),
                     {{"most", limit_text(largest_coordinate)}}});
  else if (given.at_infinity && std::abs(given.point) < tolerance::smallest_direction)
    found.push_back({"center_direction", "task.given.instant_center",
                     "a centre at infinity needs a direction; give two numbers that are not both zero"});
}

void check_point(Point point, const std::string& place, std::vector<Error>& found) {
  check_number(point.real(), "x", place + "[0]", found);
  check_number(point.imag(), "y", place + "[1]", found);
}

void check(const GivenPivots& given, std::vector<Error>& found) {
  require(given.input || given.output, "a pivot is given");
  const bool are_alike = given.input && given.output && given.input->kind == given.output->kind;
  const auto check_side = [&](const std::optional<GivenPivot>& pivot, std::string_view side) {
    if (!pivot) return;
    check_point(pivot->point,
                are_alike ? fmt::format("task.given.{}_pivots.{}", name(pivot->kind), side)
                          : fmt::format("task.given.{}_{}_pivot", side, name(pivot->kind)),
                found);
  };
  check_side(given.input, "input");
  check_side(given.output, "output");
  if (are_alike && given.input->point == given.output->point)
    found.push_back({"same_given_pivots", fmt::format("task.given.{}_pivots", name(given.input->kind)),
                     "both pivots lie at one place, which makes a link of no length; move one of them"});
}

void check(const PivotLines& given, std::vector<Error>& found) {
  require(given.ground || given.moving, "a line is given");
  if (given.ground) check_line(*given.ground, "task.given.ground_pivot_on", found);
  if (given.moving) check_line(*given.moving, "task.given.moving_pivot_on", found);
}

}  // namespace

void check_line(const LineAtAngle& line, const std::string& place, std::vector<Error>& found) {
  check_point(line.point, place + ".point", found);
  check_angle(line.angle, "direction_deg", place + ".direction_deg", found);
}

std::vector<Error> mistakes_in(const ThreePoseGiven& given) {
  std::vector<Error> found;
  std::visit([&](const auto& kind) { check(kind, found); }, given);
  return found;
}

}  // namespace linkwright
