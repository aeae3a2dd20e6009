#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "files/four_bar/four_bar_kind.hpp"
#include "files/four_bar/pose_reader.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/nearest_name.hpp"

namespace linkwright {
namespace {

/// A number that may be missing; false where it is there and none.
bool read_number(const JsonObject& object, std::string_view key, std::optional<double>& number) {
  const auto found = object.find(key);
  if (!found || found->is_null()) return true;
  number = found->as_number();
  return number.has_value();
}

bool read_task_flag(const JsonObject& object, std::string_view key, bool& flag) {
  const auto found = object.find(key);
  if (!found) return true;
  const auto read = found->as_flag();
  flag = read.value_or(flag);
  return read.has_value();
}

std::optional<ThreePoseGiven> read_side_angle(const JsonObject& object) {
  const auto angle = object.require_number("side_angle_deg");
  SideAngle given;
  if (!read_task_flag(object, "directed", given.directed) || !read_number(object, "input_length", given.input_length) ||
      !angle)
    return std::nullopt;
  given.angle = radians(*angle);
  return given;
}

std::optional<ThreePoseGiven> read_instant_center(const JsonObject& object) {
  const auto point = object.require_point("instant_center");
  InstantCenter given;
  if (!read_task_flag(object, "at_infinity", given.at_infinity) || !point) return std::nullopt;
  given.point = *point;
  return given;
}

constexpr std::array<std::string_view, 4> forms_of_given = {"side_lengths", "side_length", "side_angle_deg",
                                                            "instant_center"};

std::optional<ThreePoseGiven> read_given(const JsonValue& value, Mistakes& mistakes) {
  const JsonObject any(value, mistakes, {});
  if (!value.is_object()) return std::nullopt;
  std::vector<std::string_view> there;
  for (const std::string_view form : forms_of_given)
    if (any.find(form)) there.push_back(form);
  if (there.size() > 1) {
    const std::string first = in_quotes(there[0]), second = in_quotes(there[1]);
    value.mistake("two_given", fmt::format("{} and {} are two ways to say what is given; keep one", first, second),
                  {{"first", first}, {"second", second}});
    return std::nullopt;
  }
  if (const auto lengths = any.find("side_lengths")) {
    const JsonObject object(value, mistakes, {"side_lengths"});
    const auto pair = lengths->as_pair({"input_output", "[input, output]"});
    return pair ? std::optional<ThreePoseGiven>(SideLengths{pair->real(), pair->imag()}) : std::nullopt;
  }
  if (const auto length = any.find("side_length")) {
    const JsonObject object(value, mistakes, {"side_length"});
    const auto input = length->as_number();
    return input ? std::optional<ThreePoseGiven>(SideLengths{*input, std::nullopt}) : std::nullopt;
  }
  if (any.find("side_angle_deg"))
    return read_side_angle(JsonObject(value, mistakes, {"side_angle_deg", "directed", "input_length"}));
  if (any.find("instant_center"))
    return read_instant_center(JsonObject(value, mistakes, {"instant_center", "at_infinity"}));
  const std::size_t before = mistakes.size();
  const JsonObject misspelled(
      value, mistakes,
      {"side_lengths", "side_length", "side_angle_deg", "directed", "input_length", "instant_center", "at_infinity"});
  if (mistakes.size() == before)
    value.mistake("no_given",
                  "one of \"side_lengths\": [input, output], \"side_length\", \"side_angle_deg\" and "
                  "\"instant_center\": [x, y] belongs here");
  return std::nullopt;
}

}  // namespace

Task read_motion(const JsonValue& value, const std::optional<Box>& /*options_box*/, Mistakes& mistakes) {
  const JsonObject object(value, mistakes, {"kind", "mechanism", "poses", "given", "freed_pose"});
  MotionTask task;
  bool complete = read_poses(object, mistakes, task.poses);
  if (const auto given = object.find("given"); given && !given->is_null()) {
    task.given = read_given(*given, mistakes);
    complete = complete && task.given;
  }
  if (const auto relaxed = object.find("freed_pose"); relaxed && !relaxed->is_null()) {
    const auto number = relaxed->as_whole_number();
    if (number) task.relaxed = static_cast<std::size_t>(std::max(*number, 0)) - 1;  // 0 and below: out of range
    complete = complete && number;
  }
  if (complete) mistakes.add(mistakes_in(task));
  return task;
}

}  // namespace linkwright
