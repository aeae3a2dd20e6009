#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "file_header.hpp"
#include "files/attitude/space_reader.hpp"
#include "files/json/json_document.hpp"
#include "files/json/json_object.hpp"
#include "files/json/mistakes.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/nearest_name.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/files/text_file.hpp"
#include "task_reader.hpp"

namespace linkwright {
namespace {

/// A limit that is a number, or null for none.
void read_limit(const JsonObject& object, std::string_view key, double off, const std::function<void(double)>& set) {
  const auto found = object.find(key);
  if (!found) return;
  if (found->is_null()) return set(off);
  if (const auto number = found->as_number()) set(*number);
}

void read_flag(const JsonObject& object, std::string_view key, bool& flag) {
  const auto found = object.find(key);
  if (!found) return;
  if (const auto read = found->as_flag()) flag = *read;
}

void read_text(const JsonObject& object, std::string_view key, std::string& text) {
  const auto found = object.find(key);
  if (!found) return;
  if (auto read = found->as_text()) text = *std::move(read);
}

void read_whole_number(const JsonObject& object, std::string_view key, int& number) {
  const auto found = object.find(key);
  if (!found) return;
  if (const auto read = found->as_whole_number()) number = *read;
}

void read_box(const JsonObject& object, std::string_view key, Mistakes& mistakes, std::optional<Box>& box) {
  const auto found = object.find(key);
  if (!found) return;
  box = found->is_null() ? std::nullopt : read_box(*found, mistakes);
}

void read_cone(const JsonObject& object, std::string_view key, Mistakes& mistakes, std::optional<Cone>& cone) {
  const auto found = object.find(key);
  if (!found || found->is_null()) return;
  const JsonObject members(*found, mistakes, {"axis", "half_angle_deg"});
  const auto axis = members.require("axis", {"three_coordinates", "three numbers [x, y, z]"});
  const auto vector = axis ? read_bounded_vector(*axis) : std::nullopt;
  const auto half_angle = members.require_number("half_angle_deg");
  if (vector && half_angle) cone = Cone{*vector, radians(*half_angle)};
}

void read_types(const JsonObject& object, std::vector<LinkageType>& types) {
  const auto found = object.find("types");
  if (!found || found->is_null()) return;
  found->for_each({"types", "a list of linkage types"}, [&](const JsonValue& item) {
    const auto written = item.as_one_of(linkage_type_names);
    if (!written) return;
    const LinkageType type = *linkage_type_named(*written);
    if (std::find(types.begin(), types.end(), type) != types.end()) {
      item.mistake("repeated_type", fmt::format("{} is listed twice; keep one", in_quotes(*written)),
                   {{"given", in_quotes(*written)}});
    } else {
      types.push_back(type);
    }
  });
}

void read_number(const JsonObject& object, const Criterion& asked, Requirements& requirements) {
  const auto found = object.find(asked.key);
  if (!found) return;
  const auto number = found->is_null() ? std::nullopt : found->as_number();
  if (!number && !found->is_null()) return;
  const double limit = !number ? asked.any : asked.is_angle() ? radians(*number) : *number;
  if (const auto* plain = std::get_if<double Requirements::*>(&asked.asked)) requirements.** plain = limit;
  if (const auto* open = std::get_if<std::optional<double> Requirements::*>(&asked.asked))
    if (number || asked.has_default) requirements.** open = limit;
}

void read_criterion(const JsonObject& object, const Criterion& asked, Mistakes& mistakes, Requirements& wanted) {
  if (asked.is_number()) return read_number(object, asked, wanted);
  if (const auto* types = std::get_if<std::vector<LinkageType> Requirements::*>(&asked.asked))
    return read_types(object, wanted.**types);
  if (const auto* flag = std::get_if<bool Requirements::*>(&asked.asked))
    return read_flag(object, asked.key, wanted.**flag);
  if (const auto* box = std::get_if<std::optional<Box> Requirements::*>(&asked.asked))
    return read_box(object, asked.key, mistakes, wanted.**box);
  read_cone(object, asked.key, mistakes, wanted.*std::get<std::optional<Cone> Requirements::*>(asked.asked));
}

void read_requirements(const JsonValue& value, Mistakes& mistakes, Requirements& requirements) {
  constexpr std::string_view direction = "respect_direction";
  const std::size_t before = mistakes.size();
  std::vector<std::string_view> known;
  for (const Criterion& asked : criteria()) known.push_back(asked.key);
  known.push_back(direction);
  const JsonObject object(value, mistakes, known);
  for (const Criterion& asked : criteria()) read_criterion(object, asked, mistakes, requirements);
  read_flag(object, direction, requirements.respect_direction);
  if (mistakes.size() == before) mistakes.add(mistakes_in(requirements));
}

/// What is asked for although linkages of the class do not have it, the defaults of other classes included.
void refuse_foreign_requirements(const JsonValue& value, const Requirements& requirements, const LinkageClass& asked,
                                 Mistakes& mistakes) {
  std::vector<Error> found = mistakes_in(requirements, asked);
  const JsonObject object(value, mistakes, {});
  for (const Criterion& one : criteria()) {
    const auto written = object.find(one.key);
    if (!written || written->is_null() || place_among(asked.requirements, one.kind) < asked.requirements.size())
      continue;
    const Error foreign = foreign_requirement(one.kind, asked);
    if (std::none_of(found.begin(), found.end(), [&](const Error& known) { return known.place == foreign.place; }))
      found.push_back(foreign);
  }
  mistakes.add(found);
}

/// One of the enumerators by its name.
template <class Enumerator>
void read_name(const JsonObject& object, std::string_view key, std::span<const Enumerator> choices,
               Enumerator& target) {
  const auto found = object.find(key);
  if (!found) return;
  std::vector<std::string_view> names;
  for (const Enumerator choice : choices) names.push_back(name(choice));
  const auto written = found->as_one_of(names);
  for (const Enumerator choice : choices) {
    if (written && *written == name(choice)) target = choice;
  }
}

template <class Enumerator>
void read_name(const JsonObject& object, std::string_view key, std::initializer_list<Enumerator> choices,
               Enumerator& target) {
  read_name(object, key, std::span<const Enumerator>(choices.begin(), choices.size()), target);
}

/// Null and what is not there: nothing.
void read_length(const JsonObject& object, std::string_view key, std::optional<double>& length) {
  const auto found = object.find(key);
  if (found && !found->is_null()) length = found->as_number();
}

std::optional<MapWindow> read_window(const JsonValue& value) {
  std::vector<Point> intervals;
  if (!value.json().is_array() || value.json().size() != 2) {
    value.wrong_type({"intervals", "a pair of intervals [[low, high], [low, high]]"});
    return std::nullopt;
  }
  value.for_each({"intervals", "a pair of intervals"}, [&](const JsonValue& item) {
    if (const auto interval = item.as_pair({"low_high", "[low, high]"})) intervals.push_back(*interval);
  });
  if (intervals.size() != 2) return std::nullopt;
  return MapWindow{{intervals[0].real(), intervals[0].imag()}, {intervals[1].real(), intervals[1].imag()}};
}

constexpr std::array all_objectives = {Objective::min_transmission_angle,
                                       Objective::link_ratio,
                                       Objective::size,
                                       Objective::structural_error,
                                       Objective::link_angle,
                                       Objective::stroke,
                                       Objective::deviation,
                                       Objective::velocity_uniformity,
                                       Objective::tolerance_error,
                                       Objective::yield};

void read_pareto(const JsonValue& value, std::optional<std::array<Objective, 2>>& pareto) {
  if (value.is_null()) return;
  std::vector<std::string_view> names;
  for (const Objective objective : all_objectives) names.push_back(name(objective));
  std::vector<Objective> read;
  const bool is_list = value.for_each({"two_objectives", "two objectives"}, [&](const JsonValue& item) {
    const auto written = item.as_one_of(names);
    for (const Objective objective : all_objectives)
      if (written && *written == name(objective)) read.push_back(objective);
  });
  if (is_list && value.json().size() != 2)
    value.mistake("pareto_two", "a front is of two objectives: [\"min_transmission_angle\", \"tolerance_error\"]");
  else if (read.size() == 2)
    pareto = {read[0], read[1]};
}

void read_options(const JsonValue& value, Mistakes& mistakes, SynthesisOptions& options) {
  const std::size_t before = mistakes.size();
  const JsonObject object(value, mistakes,
                          {"region_samples", "spacing", "objective", "best", "window", "at", "box", "seed", "effort",
                           "deviation", "stroke", "measure", "pareto"});
  read_whole_number(object, "region_samples", options.region_samples);
  read_name(object, "spacing", {Spacing::coordinate, Spacing::arc_length}, options.spacing);
  read_name(object, "objective", std::span<const Objective>(all_objectives), options.objective);
  if (const auto pareto = object.find("pareto")) read_pareto(*pareto, options.pareto);
  read_length(object, "deviation", options.line.deviation);
  read_length(object, "stroke", options.line.stroke);
  read_name(object, "measure", {LineMeasure::tangent, LineMeasure::strip}, options.line.measure);
  read_whole_number(object, "best", options.best);
  read_box(object, "box", mistakes, options.box);
  read_whole_number(object, "seed", options.seed);
  read_whole_number(object, "effort", options.effort);
  const auto window = object.find("window");
  if (window && !window->is_null()) options.window = read_window(*window);
  const auto at = object.find("at");
  if (at && !at->is_null())
    if (const auto place = at->as_pair({"[u, v]"})) options.at = MapPoint{place->real(), place->imag()};
  if (mistakes.size() == before) mistakes.add_new(mistakes_in(options));
}

void read_half_tolerance(const JsonObject& object, std::string_view key, double& tolerance) {
  read_limit(object, key, 0, [&](double half) { tolerance = half; });
}

void read_lengths(const JsonValue& value, Mistakes& mistakes, LengthTolerances& lengths) {
  if (!value.is_object()) {
    if (const auto all = value.as_number()) lengths = LengthTolerances::all(*all);
    return;
  }
  const JsonObject object(value, mistakes, {"input", "coupler", "output", "ground_pivots", "point"});
  read_half_tolerance(object, "input", lengths.input);
  read_half_tolerance(object, "coupler", lengths.coupler);
  read_half_tolerance(object, "output", lengths.output);
  read_half_tolerance(object, "ground_pivots", lengths.ground_pivots);
  read_half_tolerance(object, "point", lengths.point);
}

void read_tolerance_limit(const JsonValue& value, Mistakes& mistakes, std::optional<ToleranceLimit>& limit) {
  const JsonObject object(value, mistakes, {"position", "angle_deg", "deviation"});
  int given = 0;
  const auto read = [&](std::string_view key, ToleranceLimit::Kind kind, double unit) {
    const auto found = object.find(key);
    if (!found) return;
    ++given;
    if (const auto number = found->as_number()) limit = ToleranceLimit{kind, unit * *number};
  };
  read("position", ToleranceLimit::Kind::position, 1);
  read("angle_deg", ToleranceLimit::Kind::angle, radians(1));
  read("deviation", ToleranceLimit::Kind::deviation, 1);
  if (value.is_object() && given != 1)
    value.mistake("one_limit", "a limit is exactly one of \"position\", \"angle_deg\" and \"deviation\"");
}

// Larger than other whole numbers of a file.
void read_seed(const JsonObject& object, std::uint64_t& seed) {
  const auto found = object.find("seed");
  const auto number = found ? found->as_number() : std::nullopt;
  if (!number) return;
  const bool fits = *number >= 0 && *number <= static_cast<double>(largest_seed) && *number == std::floor(*number);
  seed = fits ? static_cast<std::uint64_t>(*number) : largest_seed + 1;
}

void read_tolerances(const JsonValue& value, Mistakes& mistakes, std::optional<Tolerances>& tolerances) {
  if (value.is_null()) return;
  if (!value.is_object()) return value.wrong_type({"object_in_braces", "an object { … }"});
  const std::size_t before = mistakes.size();
  const JsonObject object(value, mistakes,
                          {"length", "clearance", "driver_deg", "link_angle_deg", "distribution", "turning_length",
                           "limit", "cost", "samples", "seed"});
  Tolerances& read = tolerances.emplace();
  if (const auto length = object.find("length"); length && !length->is_null())
    read_lengths(*length, mistakes, read.length);
  read_half_tolerance(object, "clearance", read.clearance);
  read_limit(object, "driver_deg", 0, [&](double half) { read.driver = radians(half); });
  read_limit(object, "link_angle_deg", 0, [&](double half) { read.link_angle = radians(half); });
  read_name(object, "distribution",
            {ToleranceDistribution::normal, ToleranceDistribution::truncated_normal, ToleranceDistribution::uniform},
            read.distribution);
  read_length(object, "turning_length", read.turning_length);
  if (const auto limit = object.find("limit"); limit && !limit->is_null())
    read_tolerance_limit(*limit, mistakes, read.limit);
  if (const auto cost = object.find("cost"); cost && !cost->is_null())
    read.cost_exponent = JsonObject(*cost, mistakes, {"exponent"}).require_number("exponent");
  read_whole_number(object, "samples", read.samples);
  read_seed(object, read.seed);
  if (mistakes.size() == before) mistakes.add(mistakes_in(read));
}

/// Three points [x, y] or more; none of another list, which is the workbench's business.
std::vector<Point> outline_of(const nlohmann::json& list) {
  std::vector<Point> outline;
  if (!list.is_array()) return outline;
  for (const nlohmann::json& point : list) {
    if (!point.is_array() || point.size() != 2 || !point[0].is_number() || !point[1].is_number()) return {};
    outline.emplace_back(point[0].get<double>(), point[1].get<double>());
  }
  return outline.size() < 3 ? std::vector<Point>() : outline;
}

void read_view(const JsonValue& value, Problem& problem) {
  if (!value.is_object()) return value.wrong_type({"object_in_braces", "an object { … }"});
  nlohmann::json rest = value.json();
  if (const auto outline = rest.find("outline"); outline != rest.end()) problem.outline = outline_of(*outline);
  if (!problem.outline.empty()) rest.erase("outline");
  if (problem.outline.empty() || !rest.empty()) problem.view = rest.dump();
}

void read_problem_members(const JsonObject& file, Mistakes& mistakes, Problem& problem) {
  read_text(file, "title", problem.title);
  read_text(file, "length_unit", problem.length_unit);
  if (const auto requirements = file.find("requirements")) {
    read_requirements(*requirements, mistakes, problem.requirements);
  }
  if (const auto tolerances = file.find("tolerances"))
    read_tolerances(*tolerances, mistakes, problem.options.tolerances);
  if (const auto options = file.find("options")) read_options(*options, mistakes, problem.options);
  if (const auto task = file.require("task", {"task", "the task: \"task\": {\"kind\": \"motion\", …}"}))
    problem.task = read_task(*task, problem.options.box, mistakes);
  const auto options = file.find("options");
  if (!options || !options->is_object() || !options->json().contains("objective"))
    problem.options.objective = linkages(problem.task).objectives.front();
  if (mistakes.empty()) {
    mistakes.add(mistakes_in(problem.task, problem.requirements, problem.options));
    if (const auto requirements = file.find("requirements"))
      refuse_foreign_requirements(*requirements, problem.requirements, linkages(problem.task), mistakes);
  }
  if (const auto view = file.find("view")) read_view(*view, problem);
}

}  // namespace

Result<Problem> read_problem(std::string_view text) {
  const auto tree = parse_json(text, {.max_bytes = max_file_bytes, .deepest_nesting = deepest_nesting, .kept = {}});
  if (!tree) return tree.errors();

  Mistakes mistakes;
  const JsonValue root(*tree, "", mistakes);
  if (const auto refusal = refuse_version(root)) return *refusal;
  Problem problem;
  const JsonObject file(
      root, mistakes, {"linkwright", "title", "length_unit", "task", "requirements", "tolerances", "options", "view"});
  if (root.is_object()) {
    check_version(file);
    read_problem_members(file, mistakes, problem);
  }
  if (!mistakes.empty()) return mistakes.take();
  return problem;
}

Result<Problem> read_problem_file(const std::filesystem::path& path) {
  const auto text = read_text_file(path, max_file_bytes);
  return text ? read_problem(*text) : Result<Problem>(text.errors());
}

}  // namespace linkwright
