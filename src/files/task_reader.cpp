#include "task_reader.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "files/four_bar/pose_reader.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/nearest_name.hpp"
#include "vocabulary.hpp"

namespace linkwright {
namespace {

constexpr std::string_view what_is_available =
    "there are motion by a four_bar or a six_bar, and function by a four_bar";
constexpr std::size_t most_poses_looked_at =
    100;  // any more than five are a mistake; comparing pairs of thousands is slow

std::optional<std::string_view> required_name(const JsonObject& task, std::string_view key,
                                              std::span<const std::string_view> names) {
  const auto found = task.require(key, {fmt::format("\"{}\": \"{}\"", key, names.front())});
  return found ? found->as_one_of(names) : std::nullopt;
}

void not_available(const JsonObject& task, std::string_view key, std::string_view name) {
  if (const auto found = task.find(key))
    found->mistake("not_available",
                   fmt::format("{} is not available in this version; {}", in_quotes(name), what_is_available),
                   {{"name", in_quotes(name)}});
}

/// The poses, and whether every one could be read.
bool read_poses(const JsonValue& value, Mistakes& mistakes, std::vector<PrescribedPose>& poses) {
  if (value.json().is_array() && value.json().size() > most_poses_looked_at) {
    value.mistake("pose_count",
                  fmt::format("{} poses are given; five positions are the most that can be solved, remove the others",
                              value.json().size()),
                  {{"count", value.json().size()}});
    return false;
  }
  bool complete = true;
  const bool is_list = value.for_each({"poses", "a list of poses"}, [&](const JsonValue& item) {
    const auto pose = read_pose(item, mistakes, OtherMembers::refused);
    if (pose) poses.push_back(*pose);
    complete = complete && pose.has_value();
  });
  return is_list && complete;
}

bool read_poses(const JsonObject& task, Mistakes& mistakes, std::vector<PrescribedPose>& poses) {
  const auto found = task.require(
      "poses",
      {"poses_in_full", "a list of poses {\"x\": …, \"y\": …, \"theta_deg\": …}, some of them with \"derivatives\""});
  return found && read_poses(*found, mistakes, poses);
}

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

Task read_motion(const JsonValue& value, Mistakes& mistakes) {
  const JsonObject object(value, mistakes, {"kind", "mechanism", "poses", "given", "freed_pose"});
  MotionTask task;
  bool complete = read_poses(object, mistakes, task.poses);
  if (const auto given = object.find("given"); given && !given->is_null()) {
    task.given = read_given(*given, mistakes);
    complete = complete && task.given;
  }
  if (const auto freed = object.find("freed_pose"); freed && !freed->is_null()) {
    const auto number = freed->as_whole_number();
    if (number) task.freed = static_cast<std::size_t>(std::max(*number, 0)) - 1;  // 0 and below: out of range
    complete = complete && number;
  }
  if (complete) mistakes.add(mistakes_in(task));
  return task;
}

std::optional<AngleDerivative> read_rates(const JsonValue& value, Mistakes& mistakes) {
  const JsonObject object(value, mistakes, {"input", "output"});
  const auto input = object.require_number("input"), output = object.require_number("output");
  if (!input || !output) return std::nullopt;
  return AngleDerivative{*input, *output};
}

std::optional<AnglePair> read_pair(const JsonValue& value, Mistakes& mistakes) {
  constexpr std::size_t most_derivatives = 4;
  const JsonObject object(value, mistakes, {"input_deg", "output_deg", "derivatives"});
  const auto input = object.require_number("input_deg"), output = object.require_number("output_deg");
  AnglePair pair;
  bool complete = input && output;
  if (const auto derivatives = object.find("derivatives")) {
    if (derivatives->json().is_array() && derivatives->json().size() > most_derivatives) {
      derivatives->mistake("derivative_count_of_pair",
                           fmt::format("{} derivatives are given; a pair has at most {}, remove the others",
                                       derivatives->json().size(), most_derivatives),
                           {{"count", derivatives->json().size()}, {"most", most_derivatives}});
      return std::nullopt;
    }
    complete = derivatives->for_each({"rates", "a list of derivatives [{\"input\": …, \"output\": …}, …]"},
                                     [&](const JsonValue& item) {
                                       const auto rates = read_rates(item, mistakes);
                                       if (rates) pair.derivatives.push_back(*rates);
                                       complete = complete && rates;
                                     }) &&
               complete;
  }
  if (!complete) return std::nullopt;
  pair.input = radians(*input);
  pair.output = radians(*output);
  return pair;
}

bool read_pairs(const JsonValue& value, Mistakes& mistakes, std::vector<AnglePair>& pairs) {
  bool complete = true;
  if (value.json().is_array() && value.json().size() > most_poses_looked_at) {
    value.mistake("pair_count",
                  fmt::format("{} pairs are given; five are the most that can be solved, remove the others, or give "
                              "them as \"function\": {{\"table\": …}}",
                              value.json().size()),
                  {{"count", value.json().size()}});
    return false;
  }
  const bool is_list =
      value.for_each({"pairs", "a list of pairs {\"input_deg\": …, \"output_deg\": …}"}, [&](const JsonValue& item) {
        const auto pair = read_pair(item, mistakes);
        if (pair) pairs.push_back(*pair);
        complete = complete && pair;
      });
  return is_list && complete;
}

/// [low, high] that may be missing; false where it is there and none.
bool read_range(const JsonObject& object, std::string_view key, std::optional<std::array<double, 2>>& range) {
  const auto found = object.find(key);
  if (!found || found->is_null()) return true;
  const auto pair = found->as_pair({"low_high", "[low, high]"});
  if (pair) range = {pair->real(), pair->imag()};
  return pair.has_value();
}

bool read_dial(const JsonObject& object, std::string_view key, std::array<double, 2>& range) {
  const auto found = object.require(key, {"two_angles", "two angles [first, last]"});
  const auto pair = found ? found->as_pair({"first_last", "[first, last]"}) : std::nullopt;
  if (pair) range = {radians(pair->real()), radians(pair->imag())};
  return pair.has_value();
}

bool read_table(const JsonValue& value, std::vector<std::array<double, 2>>& table) {
  bool complete = true;
  const bool is_list = value.for_each({"rows", "a list of rows [x, y]"}, [&](const JsonValue& item) {
    const auto row = item.as_pair({"[x, y]"});
    if (row) table.push_back({row->real(), row->imag()});
    complete = complete && row;
  });
  return is_list && complete;
}

bool read_what_it_is(const JsonObject& object, const JsonValue& value, NamedFunction& function) {
  const auto expression = object.find("expression"), table = object.find("table");
  if (expression.has_value() == table.has_value()) {
    value.mistake("missing_function",
                  "either \"expression\" (\"x^2\", \"sqrt\", \"log\", \"sin\", …) or \"table\": [[x, y], …] belongs "
                  "here, not both");
    return false;
  }
  if (table) return read_table(*table, function.table);
  auto text = expression->as_text();
  if (!text) return false;
  if (text->empty() || presentable(*text) != *text) {  // no line breaks in messages
    expression->mistake(
        "no_expression",
        fmt::format("{} is no expression; write \"x^2\", \"sqrt\", \"log\", \"sin\", …", in_quotes(*text)),
        {{"given", in_quotes(*text)}});
    return false;
  }
  function.expression = *std::move(text);
  return true;
}

bool read_interpolation(const JsonObject& object, NamedFunction& function) {
  constexpr std::array names = {std::string_view("monotone_cubic"), std::string_view("linear")};
  const auto found = object.find("interpolation");
  if (!found) return true;
  const auto written = found->as_one_of(names);
  if (written) function.interpolation = table_interpolation_named(*written).value_or(function.interpolation);
  return written.has_value();
}

bool read_spacing(const JsonObject& object, NamedFunction& function) {
  constexpr std::array names = {std::string_view("chebyshev"), std::string_view("even")};
  const auto found = object.find("spacing");
  if (!found) return true;
  if (!found->json().is_array()) {
    const auto written = found->as_one_of(names);
    if (written) function.spacing = point_spacing_named(*written).value_or(function.spacing);
    return written.has_value();
  }
  function.spacing = PointSpacing::given;
  bool complete = true;
  found->for_each({"list_of_x", "a list of x"}, [&](const JsonValue& item) {
    const auto x = item.as_number();
    if (x) function.given_points.push_back(*x);
    complete = complete && x;
  });
  return complete;
}

/// How many precision points; where there is a list of them, as many as it has. After read_spacing().
bool read_count(const JsonObject& object, NamedFunction& function) {
  const auto found = object.find("points");
  if (!found && function.spacing == PointSpacing::given)
    function.points = static_cast<int>(std::min<std::size_t>(function.given_points.size(), most_poses_looked_at));
  if (!found) return true;
  const auto count = found->as_whole_number();
  function.points = count.value_or(function.points);
  return count.has_value();
}

std::optional<NamedFunction> read_function(const JsonValue& value, Mistakes& mistakes) {
  const JsonObject object(
      value, mistakes,
      {"expression", "table", "interpolation", "x", "y", "input_range_deg", "output_range_deg", "points", "spacing"});
  if (!value.is_object()) return std::nullopt;
  NamedFunction function;
  const std::array complete = {read_what_it_is(object, value, function),
                               read_interpolation(object, function),
                               read_range(object, "x", function.x),
                               read_range(object, "y", function.y),
                               read_dial(object, "input_range_deg", function.input_range),
                               read_dial(object, "output_range_deg", function.output_range),
                               read_spacing(object, function),
                               read_count(object, function)};
  for (const bool part : complete)
    if (!part) return std::nullopt;
  return function;
}

/// Pairs count from 1 in files.
bool read_pair_number(const JsonValue& value, FreeNumber& free) {
  const auto number = value.as_whole_number();
  if (!number) return false;
  if (*number < 1) {
    value.mistake("pair_number", "pairs count from 1");
    return false;
  }
  free.pair = static_cast<std::size_t>(*number) - 1;
  return true;
}

std::optional<FreeNumber> read_free(const JsonValue& value, Mistakes& mistakes) {
  constexpr std::array names = {std::string_view("output_scale"), std::string_view("pair_output")};
  const JsonObject object(value, mistakes, {"number", "pair", "range"});
  const auto written = object.require("number", {"\"number\": \"output_scale\""});
  const auto kind = written ? written->as_one_of(names) : std::nullopt;
  if (!kind) return std::nullopt;
  FreeNumber free;
  free.kind = free_number_named(*kind).value_or(free.kind);
  if (free.kind == FreeNumber::Kind::pair_output) {
    const auto pair = object.require("pair", {"pair_number", "which pair it is, counted from 1"});
    const bool ranged = read_dial(object, "range", free.range);
    return pair && read_pair_number(*pair, free) && ranged ? std::optional(free) : std::nullopt;
  }
  std::optional<std::array<double, 2>> range;
  if (const auto pair = object.find("pair"))
    pair->mistake("unneeded_pair", "the output's scale is of all pairs; leave \"pair\" out");
  if (object.find("pair") || !read_range(object, "range", range)) return std::nullopt;
  if (range) free.range = *range;
  return free;
}

bool read_pivots(const JsonObject& object, Mistakes& mistakes, FunctionTask& task) {
  const auto found = object.find("ground_pivots");
  if (!found) return true;
  const JsonObject pivots(*found, mistakes, {"input", "output"});
  const auto input = pivots.require_point("input"), output = pivots.require_point("output");
  if (!input || !output) return false;
  task.input_pivot = *input;
  task.output_pivot = *output;
  return true;
}

/// The pairs themselves, or those of a named function.
bool read_what_is_wanted(const JsonObject& object, const JsonValue& value, Mistakes& mistakes, FunctionTask& task) {
  const auto pairs = object.find("pairs"), function = object.find("function");
  if (pairs.has_value() == function.has_value()) {
    value.mistake("missing_pairs",
                  "either \"pairs\": [{\"input_deg\": …, \"output_deg\": …}, …] or \"function\": {\"expression\": …} "
                  "belongs here, not both");
    return false;
  }
  if (pairs) return read_pairs(*pairs, mistakes, task.pairs);
  task.function = read_function(*function, mistakes);
  if (!task.function) return false;
  const std::vector<Error> wrong = mistakes_in(*task.function);
  mistakes.add(wrong);
  if (wrong.empty()) task.pairs = precision_pairs(*task.function);
  return wrong.empty();
}

Task read_function_task(const JsonValue& value, Mistakes& mistakes) {
  const JsonObject object(value, mistakes, {"kind", "mechanism", "pairs", "function", "ground_pivots", "free"});
  FunctionTask task;
  bool complete = read_what_is_wanted(object, value, mistakes, task);
  complete = read_pivots(object, mistakes, task) && complete;
  if (const auto free = object.find("free"); free && !free->is_null()) {
    task.free = read_free(*free, mistakes);
    complete = complete && task.free;
  }
  if (complete) mistakes.add(mistakes_in(task));
  return task;
}

bool read_elbows(const JsonObject& object, std::array<int, 4>& elbow) {
  const auto found = object.find("elbow");
  if (!found) return true;
  std::size_t count = 0;
  bool complete = true;
  const bool is_list = found->for_each({"signs", "a list of four signs"}, [&](const JsonValue& item) {
    const auto sign = item.as_whole_number();
    if (sign && count < elbow.size()) elbow[count] = *sign;
    complete = complete && sign;
    ++count;
  });
  if (is_list && complete && count != elbow.size()) {
    found->mistake("elbow_count", fmt::format("{} signs are given; one to each of the four poses belongs here", count),
                   {{"count", count}});
    return false;
  }
  return is_list && complete;
}

bool read_added(const JsonObject& object, std::array<BodyPair, 2>& added) {
  const auto found = object.require("added", {"\"added\": [\"0-2\", \"0-3\"]"});
  if (!found) return false;
  std::vector<BodyPair> pairs;
  bool complete = true;
  const bool is_list = found->for_each({"bodies", "two pairs of bodies"}, [&](const JsonValue& item) {
    const auto text = item.as_text();
    const auto pair = text ? body_pair_from(*text) : std::nullopt;
    if (text && !pair)
      item.mistake("unknown_bodies", fmt::format("{} names no two bodies; write them as in \"0-2\"", in_quotes(*text)),
                   {{"given", in_quotes(*text)}});
    if (pair) pairs.push_back(*pair);
    complete = complete && pair;
  });
  if (!is_list || !complete) return false;
  if (pairs.size() != added.size()) {
    found->mistake("added_count",
                   fmt::format("{} added links are given; a six-bar has two beside the chain", pairs.size()),
                   {{"count", pairs.size()}});
    return false;
  }
  added = {pairs[0], pairs[1]};
  return true;
}

Task read_six_bar(const JsonValue& value, const std::optional<Box>& box, Mistakes& mistakes) {
  const JsonObject object(value, mistakes, {"kind", "mechanism", "poses", "chain", "added"});
  SixBarTask task;
  task.box = box;
  bool complete = read_poses(object, mistakes, task.poses);
  complete = read_added(object, task.added) && complete;
  if (const auto chain = object.find("chain"); chain && !chain->is_null()) {
    task.chain = read_chain(*chain, mistakes);
    complete = complete && task.chain;
  }
  if (complete) mistakes.add_new(mistakes_in(task));  // the box is also the options'
  return task;
}

}  // namespace

Task read_task(const JsonValue& value, const std::optional<Box>& options_box, Mistakes& mistakes) {
  const JsonObject any(value, mistakes, {});
  if (!value.is_object()) return MotionTask{};
  const auto kind = required_name(any, "kind", task_kinds);
  const auto mechanism = required_name(any, "mechanism", mechanism_names);
  if (!kind || !mechanism) return MotionTask{};
  if (*kind == "straight_line") {
    not_available(any, "kind", *kind);
  } else if (*mechanism == "spherical_four_bar") {
    not_available(any, "mechanism", *mechanism);
  } else if (*mechanism == "four_bar") {
    return *kind == "motion" ? read_motion(value, mistakes) : read_function_task(value, mistakes);
  } else if (*kind == "motion") {
    return read_six_bar(value, options_box, mistakes);
  } else {
    any.find("mechanism")
        ->mistake(
            "no_six_bar_function",
            fmt::format("function generation by a six_bar is not available in this version; {}", what_is_available));
  }
  return MotionTask{};  // other kinds have other keys
}

std::optional<ThreeLinkChain> read_chain(const JsonValue& value, Mistakes& mistakes) {
  const JsonObject object(value, mistakes, {"a", "b", "d", "elbow"});
  const auto a = object.require_point("a"), b = object.require_point("b"), d = object.require_point("d");
  ThreeLinkChain chain;
  if (!read_elbows(object, chain.elbow) || !a || !b || !d) return std::nullopt;
  chain.a = *a;
  chain.b = *b;
  chain.d = *d;
  return chain;
}

std::optional<Box> read_box(const JsonValue& value, Mistakes& mistakes) {
  const JsonObject object(value, mistakes, {"x", "y"});
  const auto interval = [&](std::string_view key) {
    const auto found = object.require(key, {"two_limits", "two numbers [low, high]"});
    return found ? found->as_pair({"low_high", "[low, high]"}) : std::nullopt;
  };
  const auto x = interval("x");
  const auto y = interval("y");
  if (!x || !y) return std::nullopt;
  return Box{x->real(), x->imag(), y->real(), y->imag()};
}

}  // namespace linkwright
