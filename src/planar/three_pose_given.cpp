#include "linkwright/planar/three_pose_given.hpp"

#include <cmath>
#include <fmt/format.h>
#include <string>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/count_text.hpp"
#include "linkwright/core/number_check.hpp"
#include "linkwright/core/tolerance.hpp"
#include "linkwright/planar/motion_task.hpp"

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
  if (!(std::abs(degrees(given.angle)) <= largest_coordinate))
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

}  // namespace

std::vector<Error> mistakes_in(const ThreePoseGiven& given) {
  std::vector<Error> found;
  std::visit([&](const auto& kind) { check(kind, found); }, given);
  return found;
}

}  // namespace linkwright
