#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>

#include "file_header.hpp"
#include "files/fields/field_reader.hpp"
#include "files/json/json.hpp"
#include "files/json/json_document.hpp"
#include "files/json/json_object.hpp"
#include "files/json/mistakes.hpp"
#include "kinds/kinds.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/count_text.hpp"
#include "linkwright/files/linkage_file.hpp"
#include "linkwright/files/nearest_name.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/files/result_file.hpp"
#include "linkwright/files/six_bar_file.hpp"
#include "linkwright/mechanism/linkage_type.hpp"
#include "linkwright/mechanism/position.hpp"
#include "problem_fields.hpp"
#include "vocabulary.hpp"

namespace linkwright {
namespace {

constexpr std::size_t max_poses = 5;  // what find_defects judges

/// What stands beside a linkage, or in a result's problem.
struct Surroundings {
  std::string title, length_unit;
  std::vector<PrescribedPose> poses;
  std::vector<PrescribedOrientation> orientations;
};

struct TracedBars {
  FourBar bars;
  std::optional<Point> point;
};
/// With the point that stands beside the links, if any.
std::optional<TracedBars> with_point(const std::optional<FourBar>& bars, const JsonObject& element) {
  std::optional<Point> point;
  if (const auto given = element.find("point")) point = given->as_pair({"[x, y]"});
  return bars ? std::optional(TracedBars{*bars, point}) : std::nullopt;
}

/// Only a planar four-bar carries a point of its own: of others the body's frame is told.
void refuse_point(const JsonValue& value, Mistakes& mistakes) {
  const auto point = JsonObject(value, mistakes, {}).find("point");
  if (!point) return;
  const bool is_planar = says_six_bar(value);
  point->mistake(is_planar ? "point_of_a_six_bar" : "point_of_a_sphere",
                 is_planar ? "no point of a six-bar is traced, but the origin of its guided body is: give it as "
                             "\"poses\": [{\"x\": …, \"y\": …, \"theta_deg\": 0}], and leave \"point\" out"
                           : "no point of a spherical four-bar is traced, but the orientation of its body is told; "
                             "leave \"point\" out");
}

bool has_tracing_pivots(const Json& element) {
  return element.contains("pivots") && element["pivots"].is_object() && element["pivots"].contains("input_fixed");
}

bool in_range(Point point) {
  return std::abs(point.real()) <= largest_number && std::abs(point.imag()) <= largest_number;
}

/// A linkage whose four pivots are known: in range, no link without length.
std::optional<FourBar> checked(const FourBar& four_bar, const JsonValue& value) {
  for (const Point pivot :
       {four_bar.input_fixed, four_bar.input_moving, four_bar.output_fixed, four_bar.output_moving}) {
    if (in_range(pivot)) continue;
    value.mistake("pivot_range", fmt::format("the coordinates of a pivot lie between ±{}", limit_text(largest_number)),
                  {{"most", limit_text(largest_number)}});
    return std::nullopt;
  }
  if (linkage_type(four_bar.lengths()) != LinkageType::degenerate) return four_bar;
  value.mistake("degenerate_four_bar", "two pivots joined by a link coincide; every link of a four-bar has a length");
  return std::nullopt;
}

/// With a point of the coupler, as linkages of straight lines have them.
std::optional<TracedBars> read_tracing_pivots(const JsonValue& value, Mistakes& mistakes) {
  const JsonObject object(value, mistakes, {"input_fixed", "input_moving", "output_moving", "output_fixed", "point"});
  const auto input_fixed = object.require_point("input_fixed"), input_moving = object.require_point("input_moving"),
             output_moving = object.require_point("output_moving"), output_fixed = object.require_point("output_fixed");
  std::optional<Point> point;
  if (const auto given = object.find("point")) point = given->as_pair({"[x, y]"});
  if (!input_fixed || !input_moving || !output_moving || !output_fixed) return std::nullopt;
  const auto bars = checked({*input_fixed, *input_moving, *output_fixed, *output_moving}, value);
  return bars ? std::optional(TracedBars{*bars, point}) : std::nullopt;
}

std::optional<FourBar> read_pivots(const JsonValue& value, Mistakes& mistakes) {
  const JsonObject object(value, mistakes, {"input_center", "input_circle", "output_center", "output_circle"});
  const auto input_fixed = object.require_point("input_center");
  const auto input_moving = object.require_point("input_circle");
  const auto output_fixed = object.require_point("output_center");
  const auto output_moving = object.require_point("output_circle");
  if (!input_fixed || !input_moving || !output_fixed || !output_moving) return std::nullopt;
  return checked({*input_fixed, *input_moving, *output_fixed, *output_moving}, value);
}

/// Input angle in the middle of its first range, at right angles to the ground link where it turns fully.
FourBar laid_out(const LinkLengths& lengths, const AngleRange& range) {
  const double input_angle = range.is_full_turn() ? pi / 2 : (range.from + range.to) / 2;
  const FourBar frame{0, lengths.input, lengths.ground, lengths.ground + lengths.output};
  const auto configuration = assemble(lengths, input_angle, Assembly::positive);
  if (!configuration) return frame;  // does not happen inside a range; pivots in one line otherwise
  return {0, std::polar(lengths.input, configuration->input_angle), lengths.ground,
          lengths.ground + std::polar(lengths.output, configuration->output_angle)};
}

std::optional<FourBar> read_lengths(const JsonValue& value, Mistakes& mistakes) {
  const JsonObject object(value, mistakes, {"ground", "input", "coupler", "output"});
  const auto length = [&](std::string_view key) -> std::optional<double> {
    const auto found = object.require(key, {"length", "a length"});
    const auto number = found ? found->as_number() : std::nullopt;
    if (!number || (*number > 0 && *number <= largest_number)) return number;
    found->mistake("length_range", fmt::format("a length is greater than 0 and at most {}", limit_text(largest_number)),
                   {{"most", limit_text(largest_number)}});
    return std::nullopt;
  };
  const auto ground = length("ground"), input = length("input"), coupler = length("coupler"), output = length("output");
  if (!ground || !input || !coupler || !output) return std::nullopt;
  const LinkLengths lengths{*ground, *input, *coupler, *output};
  const auto ranges = input_ranges(lengths);
  if (ranges.empty()) {
    const double longest = lengths.longest(), others = lengths.perimeter() - longest;
    value.mistake("cannot_be_assembled",
                  fmt::format("the longest link ({:g}) is longer than the other three together ({:g}), so "
                              "they do not close; shorten it or lengthen another",
                              longest, others),
                  {{"longest", longest}, {"others", others}});
    return std::nullopt;
  }
  return checked(laid_out(lengths, ranges.front()), value);
}

std::optional<Point> read_dyad_point(const JsonObject& dyad, std::string_view key) {
  const auto found = dyad.require(key, {"two_coordinates", "two numbers [x, y]"});
  if (!found) return std::nullopt;
  if (!found->is_null()) return found->as_pair({"[x, y]"});
  found->mistake("slider",
                 "this pivot lies at infinity (a slider); only linkages with four pivots can be drawn or analysed");
  return std::nullopt;
}

std::optional<FourBar> read_dyads(const JsonObject& element, const JsonValue& value, Mistakes& mistakes) {
  std::vector<Point> points;
  for (const std::string_view side : {"input", "output"}) {
    const auto found =
        element.require(side, {"side_link", "a grounded link {\"center_point\": [x, y], \"circle_point\": [x, y]}"});
    if (!found) continue;
    const JsonObject dyad(*found, mistakes, {});
    for (const std::string_view key : {"center_point", "circle_point"}) {
      if (const auto point = read_dyad_point(dyad, key)) points.push_back(*point);
    }
  }
  if (points.size() != 4) return std::nullopt;
  return checked({points[0], points[1], points[2], points[3]}, value);
}

/// An element of `linkages`, or pivots, or lengths.
std::optional<TracedBars> read_four_bar(const JsonValue& value, Mistakes& mistakes) {
  const JsonObject element(value, mistakes, {});
  if (!value.is_object()) return std::nullopt;
  if (const auto mechanism = element.find("mechanism")) {
    const auto name = mechanism->as_text();
    if (name && *name != "four_bar") {
      mechanism->mistake("other_mechanism",
                         fmt::format("only a \"four_bar\", a \"six_bar\" and a \"spherical_four_bar\" can be analysed "
                                     "and exported; this is a {}",
                                     in_quotes(*name)),
                         {{"given", in_quotes(*name)}});
      return std::nullopt;
    }
  }
  if (const auto pivots = element.find("pivots"))
    return has_tracing_pivots(value.json()) ? read_tracing_pivots(*pivots, mistakes)
                                            : with_point(read_pivots(*pivots, mistakes), element);
  if (element.find("input") || element.find("output")) return with_point(read_dyads(element, value, mistakes), element);
  if (const auto lengths = element.find("lengths")) return with_point(read_lengths(*lengths, mistakes), element);
  value.mistake("no_linkage", "no linkage is given here; add \"pivots\", \"lengths\", or the linkage of a result file");
  return std::nullopt;
}

/// A pose of a task that linkages are not to pass exactly.
bool is_near(const Json& pose) { return pose.is_object() && pose.value("near", Json(false)) == Json(true); }

void read_linkage_poses(const JsonValue& value, Mistakes& mistakes, std::vector<PrescribedPose>& poses) {
  const Json& all = value.json();
  const auto near = all.is_array() ? std::count_if(all.begin(), all.end(), is_near) : 0;
  if (all.is_array() && all.size() > max_poses + static_cast<std::size_t>(near)) {
    value.mistake("poses_read", fmt::format("at most {} poses are read; remove the others", max_poses),
                  {{"most", max_poses}});
    return;
  }
  value.for_each({"poses", "a list of poses"}, [&](const JsonValue& item) {
    if (is_near(item.json())) return;
    if (auto pose = read_fields<PrescribedPose>(item, mistakes, OtherMembers::ignored))
      poses.push_back(*std::move(pose));
  });
}

void read_linkage_orientations(const JsonObject& around, Mistakes& mistakes, Surroundings& surroundings) {
  const auto found = around.find("orientations");
  if (!found) return;
  if (found->json().is_array() && found->json().size() > max_poses) {
    found->mistake("orientations_read", fmt::format("at most {} orientations are read; remove the others", max_poses),
                   {{"most", max_poses}});
    return;
  }
  surroundings.orientations =
      read_fields<std::vector<PrescribedOrientation>>(*found, mistakes, OtherMembers::ignored, orientation_list())
          .value_or(std::vector<PrescribedOrientation>());
}

void read_positions(const JsonObject& around, Mistakes& mistakes, Surroundings& surroundings) {
  if (const auto poses = around.find("poses")) read_linkage_poses(*poses, mistakes, surroundings.poses);
  read_linkage_orientations(around, mistakes, surroundings);
}

/// The poses that a linkage brings along: of functions, and of what passes a part of the task, they are not the task's.
void read_own_poses(const JsonValue& element, Mistakes& mistakes, Surroundings& surroundings) {
  const auto own = element.is_object() ? JsonObject(element, mistakes, {}).find("poses") : std::nullopt;
  if (!own) return;
  surroundings.poses.clear();
  read_linkage_poses(*own, mistakes, surroundings.poses);
}

/// Title, unit and positions from beside a linkage or from a result's problem.
Surroundings read_surroundings(const JsonObject& object, Mistakes& mistakes) {
  Surroundings surroundings;
  if (const auto title = object.find("title")) surroundings.title = title->as_text().value_or("");
  if (const auto unit = object.find("length_unit")) surroundings.length_unit = unit->as_text().value_or("");
  read_positions(object, mistakes, surroundings);
  return surroundings;
}

Surroundings read_problem_echo(const JsonObject& file, Mistakes& mistakes) {
  const auto problem = file.find("problem");
  if (!problem) return {};
  const JsonObject object(*problem, mistakes, {});
  Surroundings surroundings = read_surroundings(object, mistakes);
  const auto task = object.find("task");
  if (task && task->is_object()) read_positions(JsonObject(*task, mistakes, {}), mistakes, surroundings);
  return surroundings;
}

std::optional<AnyStoredLinkage> read_stored_six_bar(const JsonValue& element, const Surroundings& around,
                                                    Mistakes& mistakes) {
  auto six_bar = read_six_bar(element, mistakes);
  if (!six_bar) return std::nullopt;
  six_bar->title = around.title;
  six_bar->length_unit = around.length_unit;
  six_bar->poses = around.poses;
  six_bar->record = element.json().dump();
  return *std::move(six_bar);
}

std::optional<AnyStoredLinkage> read_stored_spherical(const JsonValue& element, const Surroundings& around,
                                                      Mistakes& mistakes) {
  const auto bars = read_spherical_four_bar(element, mistakes);
  if (!bars) return std::nullopt;
  const std::string record = element.json().contains("axes") ? "" : element.json().dump();
  return StoredSphericalFourBar{*bars, around.title, around.length_unit, around.orientations, record};
}

/// What `element` holds, with what stands around it.
std::optional<AnyStoredLinkage> read_element(const JsonValue& element, const Surroundings& around, Mistakes& mistakes) {
  if (says_six_bar(element) || says_spherical_four_bar(element)) refuse_point(element, mistakes);
  if (says_six_bar(element)) return read_stored_six_bar(element, around, mistakes);
  if (says_spherical_four_bar(element)) return read_stored_spherical(element, around, mistakes);
  const auto traced = read_four_bar(element, mistakes);
  if (!traced) return std::nullopt;
  const bool is_bare = element.json().contains("pivots") && !element.json().contains("case");
  const std::string record = is_bare ? "" : element.json().dump();
  return StoredLinkage{traced->bars, around.title, around.length_unit, around.poses, record, traced->point};
}

/// The one linkage of a file that is no result, with what stands beside it.
std::optional<AnyStoredLinkage> read_lone_linkage(const JsonValue& root, const JsonObject& file, Mistakes& mistakes) {
  if (!root.is_object()) return std::nullopt;
  Surroundings surroundings = read_surroundings(file, mistakes);
  const auto held = file.find("linkage");
  if (held) read_own_poses(*held, mistakes, surroundings);
  auto linkage = read_element(held.value_or(root), surroundings, mistakes);
  if (linkage && !held) std::visit([](auto& of_kind) { of_kind.record.clear(); }, *linkage);
  return linkage;
}

std::vector<AnyStoredLinkage> read_listed_linkages(const JsonValue& list, const JsonObject& file, Mistakes& mistakes) {
  std::vector<AnyStoredLinkage> linkages;
  const Surroundings of_the_problem = read_problem_echo(file, mistakes);
  list.for_each({"linkages", "a list of linkages"}, [&](const JsonValue& item) {
    Surroundings surroundings = of_the_problem;
    read_own_poses(item, mistakes, surroundings);
    auto linkage = read_element(item, surroundings, mistakes);
    if (!linkage) return;
    std::visit([&](auto& of_kind) { of_kind.record = item.json().dump(); }, *linkage);
    linkages.push_back(*std::move(linkage));
  });
  return linkages;
}

Error problem_for_a_result() {
  return {"problem_file", "task",
          "this is a problem file, not a result; solve it first: linkwright solve PROBLEM.json -o RESULT.json"};
}

/// The four-bar among all linkages; nothing where it is another one.
Result<StoredLinkage> as_four_bar(AnyStoredLinkage linkage) {
  if (auto* four_bar = std::get_if<StoredLinkage>(&linkage)) return std::move(*four_bar);
  return Error{"not_a_four_bar", "mechanism",
               fmt::format("this is a {}; only a \"four_bar\" belongs here",
                           std::holds_alternative<StoredSixBar>(linkage) ? "six-bar" : "spherical four-bar")};
}

}  // namespace

Result<AnyStoredLinkage> read_any_linkage(std::string_view text) {
  const auto tree = parse_json(text, {.max_bytes = max_result_bytes, .deepest_nesting = deepest_nesting, .kept = {}});
  if (!tree) return tree.errors();
  Mistakes mistakes;
  const JsonValue root(*tree, "", mistakes);
  if (const auto refusal = refuse_version(root)) return *refusal;
  const JsonObject file(root, mistakes, {});
  std::optional<AnyStoredLinkage> linkage;
  if (const auto list = file.find("linkages")) {
    list->mistake("result_file",
                  "this is a result file with many linkages; take one out with: linkwright export RESULT.json "
                  "--linkage 1 --format json -o LINKAGE.json");
  } else if (file.find("task")) {
    return Error{
        "problem_without_linkage", "task",
        "this is a problem file, which has no linkage yet; solve it: linkwright solve PROBLEM.json -o RESULT.json, "
        "then take one out: linkwright export RESULT.json --format json -o LINKAGE.json"};
  } else {
    linkage = read_lone_linkage(root, file, mistakes);
  }
  if (!mistakes.empty()) return mistakes.take();
  return *std::move(linkage);
}

Result<StoredLinkage> read_linkage(std::string_view text) {
  auto linkage = read_any_linkage(text);
  return linkage ? as_four_bar(std::move(*linkage)) : Result<StoredLinkage>(linkage.errors());
}

Result<std::vector<AnyStoredLinkage>> read_any_result_linkages(std::string_view text) {
  const auto tree = parse_json(text, {.max_bytes = max_result_bytes,
                                      .deepest_nesting = deepest_nesting,
                                      .kept = {"linkwright", "problem", "linkages", "task"}});
  if (!tree) return tree.errors();
  Mistakes mistakes;
  const JsonValue root(*tree, "", mistakes);
  if (const auto refusal = refuse_version(root)) return *refusal;
  const JsonObject file(root, mistakes, {});
  if (file.find("task")) return problem_for_a_result();
  std::vector<AnyStoredLinkage> linkages;
  if (const auto list = file.require("linkages", {"linkages_of_result", "the list of linkages of a result file"}))
    linkages = read_listed_linkages(*list, file, mistakes);
  if (!mistakes.empty()) return mistakes.take();
  return linkages;
}

Result<LinkagesOfFile> read_linkages_of_file(std::string_view text) {
  const auto tree =
      parse_json(text, {.max_bytes = max_result_bytes,
                        .deepest_nesting = deepest_nesting,
                        .kept = {"linkwright",   "problem", "linkages",  "task",  "title",  "length_unit", "poses",
                                 "orientations", "linkage", "mechanism", "case",  "pivots", "lengths",     "input",
                                 "output",       "point",   "chain",     "added", "axes",   "angles_deg"}});
  if (!tree) return tree.errors();
  Mistakes mistakes;
  const JsonValue root(*tree, "", mistakes);
  if (const auto refusal = refuse_version(root)) return *refusal;
  const JsonObject file(root, mistakes, {});
  if (file.find("task")) return problem_for_a_result();
  LinkagesOfFile found;
  if (const auto list = file.find("linkages")) {
    found.is_result = true;
    found.linkages = read_listed_linkages(*list, file, mistakes);
  } else if (auto lone = read_lone_linkage(root, file, mistakes)) {
    found.linkages.push_back(*std::move(lone));
  }
  if (!mistakes.empty()) return mistakes.take();
  return found;
}

Result<std::vector<StoredLinkage>> read_result_linkages(std::string_view text) {
  auto linkages = read_any_result_linkages(text);
  if (!linkages) return linkages.errors();
  std::vector<StoredLinkage> four_bars;
  for (AnyStoredLinkage& linkage : *linkages) {
    auto four_bar = as_four_bar(std::move(linkage));
    if (!four_bar) return four_bar.errors();
    four_bars.push_back(*std::move(four_bar));
  }
  return four_bars;
}

}  // namespace linkwright
