#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "files/four_bar/four_bar_kind.hpp"
#include "files/four_bar/pose_reader.hpp"
#include "files/line_reader.hpp"
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

constexpr std::array both_sides = {Side::input, Side::output};
constexpr std::array both_kinds = {PivotKind::ground, PivotKind::moving};

constexpr std::array<std::string_view, 2> keys_of_both_pivots = {"ground_pivots", "moving_pivots"};
constexpr std::array<std::string_view, 4> keys_of_one_pivot = {"input_ground_pivot", "input_moving_pivot",
                                                               "output_ground_pivot", "output_moving_pivot"};
constexpr std::array<std::string_view, 2> keys_of_lines = {"ground_pivot_on", "moving_pivot_on"};

/// Both pivots as `{"input": [x, y], "output": [x, y]}` or as a list, the input's first.
std::optional<ThreePoseGiven> read_both_pivots(const JsonValue& value, Mistakes& mistakes, PivotKind kind) {
  const Wanted form{"given_pivots", "both pivots {\"input\": [x, y], \"output\": [x, y]}"};
  std::vector<std::optional<Point>> points;
  if (value.json().is_array()) {
    if (value.json().size() != 2) {
      value.wrong_type(form);
      return std::nullopt;
    }
    value.for_each(form, [&](const JsonValue& item) { points.push_back(item.as_pair({"[x, y]"})); });
  } else if (value.is_object()) {
    const JsonObject object(value, mistakes, {"input", "output"});
    for (const Side side : both_sides) points.push_back(object.require_point(name(side)));
  } else {
    value.wrong_type(form);
    return std::nullopt;
  }
  if (!points[0] || !points[1]) return std::nullopt;
  return GivenPivots{GivenPivot{kind, *points[0]}, GivenPivot{kind, *points[1]}};
}

std::optional<ThreePoseGiven> read_single_pivots(const JsonObject& object, const JsonValue& value) {
  GivenPivots given;
  for (const Side side : both_sides)
    for (const PivotKind kind : both_kinds) {
      const std::string key = fmt::format("{}_{}_pivot", name(side), name(kind));
      const auto found = object.find(key);
      if (!found) continue;
      auto& pivot = side == Side::input ? given.input : given.output;
      if (pivot) {
        const std::string first = in_quotes(fmt::format("{}_{}_pivot", name(side), name(pivot->kind))),
                          second = in_quotes(key);
        value.mistake("both_pivots_of_link",
                      fmt::format("{} and {} are both pivots of one link, and few tasks have a link between two given "
                                  "ones; keep one",
                                  first, second),
                      {{"first", first}, {"second", second}});
        return std::nullopt;
      }
      const auto point = found->as_pair({"[x, y]"});
      if (!point) return std::nullopt;
      pivot = GivenPivot{kind, *point};
    }
  return given;
}

std::optional<ThreePoseGiven> read_lines(const JsonObject& object, Mistakes& mistakes) {
  PivotLines given;
  for (const PivotKind kind : both_kinds) {
    const auto found = object.find(fmt::format("{}_pivot_on", name(kind)));
    if (!found) continue;
    const auto line = read_line(*found, mistakes);
    if (!line) return std::nullopt;
    (kind == PivotKind::ground ? given.ground : given.moving) = *line;
  }
  return given;
}

/// One way to say what is given: its keys, any of which may be there, and those that go with them.
struct FormOfGiven {
  std::vector<std::string_view> keys, others;
};

const std::vector<FormOfGiven>& forms_of_given() {
  static const std::vector<FormOfGiven> forms = {
      {{"side_lengths"}, {}},
      {{"side_length"}, {}},
      {{"side_angle_deg"}, {"directed", "input_length"}},
      {{"instant_center"}, {"at_infinity"}},
      {{keys_of_both_pivots[0]}, {}},
      {{keys_of_both_pivots[1]}, {}},
      {{keys_of_one_pivot.begin(), keys_of_one_pivot.end()}, {}},
      {{keys_of_lines.begin(), keys_of_lines.end()}, {}},
  };
  return forms;
}

std::vector<std::string_view> known_keys(const FormOfGiven& form) {
  std::vector<std::string_view> keys = form.keys;
  keys.insert(keys.end(), form.others.begin(), form.others.end());
  return keys;
}

std::optional<ThreePoseGiven> read_form(const FormOfGiven& form, const JsonValue& value, Mistakes& mistakes) {
  const JsonObject object(value, mistakes, known_keys(form));
  const std::string_view key = form.keys.front();
  if (key == "side_lengths") {
    const auto pair = object.find(key)->as_pair({"input_output", "[input, output]"});
    return pair ? std::optional<ThreePoseGiven>(SideLengths{pair->real(), pair->imag()}) : std::nullopt;
  }
  if (key == "side_length") {
    const auto input = object.find(key)->as_number();
    return input ? std::optional<ThreePoseGiven>(SideLengths{*input, std::nullopt}) : std::nullopt;
  }
  if (key == "side_angle_deg") return read_side_angle(object);
  if (key == "instant_center") return read_instant_center(object);
  for (const PivotKind kind : both_kinds)
    if (key == keys_of_both_pivots[static_cast<std::size_t>(kind)])
      return read_both_pivots(*object.find(key), mistakes, kind);
  return key == keys_of_lines.front() ? read_lines(object, mistakes) : read_single_pivots(object, value);
}

std::optional<ThreePoseGiven> read_given(const JsonValue& value, Mistakes& mistakes) {
  const JsonObject any(value, mistakes, {});
  if (!value.is_object()) return std::nullopt;
  std::vector<std::pair<const FormOfGiven*, std::string_view>> there;
  for (const FormOfGiven& form : forms_of_given()) {
    const auto key =
        std::find_if(form.keys.begin(), form.keys.end(), [&](std::string_view k) { return any.find(k).has_value(); });
    if (key != form.keys.end()) there.emplace_back(&form, *key);
  }
  if (there.size() > 1) {
    const std::string first = in_quotes(there[0].second), second = in_quotes(there[1].second);
    value.mistake("two_given", fmt::format("{} and {} are two ways to say what is given; keep one", first, second),
                  {{"first", first}, {"second", second}});
    return std::nullopt;
  }
  if (there.size() == 1) return read_form(*there[0].first, value, mistakes);
  const std::size_t before = mistakes.size();
  std::vector<std::string_view> all;
  for (const FormOfGiven& form : forms_of_given())
    for (const std::string_view key : known_keys(form)) all.push_back(key);
  const JsonObject misspelled(value, mistakes, all);
  if (mistakes.size() == before)
    value.mistake(
        "no_given",
        "one of \"side_lengths\": [input, output], \"side_length\", \"side_angle_deg\", "
        "\"instant_center\": [x, y], \"ground_pivots\", \"moving_pivots\", \"input_ground_pivot\" (or another "
        "pivot) and \"ground_pivot_on\", \"moving_pivot_on\" belongs here");
  return std::nullopt;
}

std::optional<PivotOnLine> read_pivot_on(const JsonValue& value, Mistakes& mistakes) {
  constexpr std::array<std::string_view, 2> sides = {"input", "output"}, kinds = {"ground", "moving"};
  const JsonObject object(value, mistakes, {"which", "pivot", "line"});
  const auto which = object.require("which", {"which_link", "\"input\" or \"output\""});
  const auto pivot = object.require("pivot", {"which_pivot", "\"ground\" or \"moving\""});
  const auto line = object.require("line", {"line", "the line {\"point\": [x, y], \"direction_deg\": …}"});
  const auto side = which ? which->as_one_of(sides) : std::nullopt;
  const auto kind = pivot ? pivot->as_one_of(kinds) : std::nullopt;
  const auto along = line ? read_line(*line, mistakes) : std::nullopt;
  if (!side || !kind || !along) return std::nullopt;
  return PivotOnLine{*side == "input" ? Side::input : Side::output,
                     *kind == "ground" ? PivotKind::ground : PivotKind::moving, *along};
}

bool read_pivots_on(const JsonObject& task, Mistakes& mistakes, std::vector<PivotOnLine>& lines) {
  const auto found = task.find("pivot_on");
  if (!found || found->is_null()) return true;
  bool complete = true;
  const bool is_list =
      found->for_each({"pivots_on", "a list of pivots on lines [{\"which\": …, \"pivot\": …, \"line\": …}]"},
                      [&](const JsonValue& item) {
                        const auto asked = read_pivot_on(item, mistakes);
                        if (asked) lines.push_back(*asked);
                        complete = complete && asked;
                      });
  return is_list && complete;
}

}  // namespace

Task read_motion(const JsonValue& value, const std::optional<Box>& /*options_box*/, Mistakes& mistakes) {
  const JsonObject object(value, mistakes, {"kind", "mechanism", "poses", "given", "pivot_on", "freed_pose"});
  MotionTask task;
  bool complete = read_poses(object, mistakes, task.poses, task.points);
  complete = read_pivots_on(object, mistakes, task.pivots_on) && complete;
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
