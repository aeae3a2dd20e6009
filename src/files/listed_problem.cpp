#include "listed_problem.hpp"

#include <fmt/format.h>
#include <optional>

#include "file_header.hpp"
#include "files/json/json.hpp"
#include "files/json/json_document.hpp"
#include "files/json/json_object.hpp"
#include "files/json/mistakes.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/files/result_file.hpp"
#include "linkwright/planar/chain_family.hpp"

namespace linkwright {
namespace {

std::optional<double> coordinate_of(const Json& part) {
  if (!part.is_object() || !part.contains("coordinate") || !part["coordinate"].is_number()) return std::nullopt;
  return part["coordinate"].get<double>();
}

std::optional<Json> place_of_sides(const Json& linkage) {
  if (!linkage.contains("input") || !linkage.contains("output")) return std::nullopt;
  const auto input = coordinate_of(linkage["input"]), output = coordinate_of(linkage["output"]);
  return input && output ? std::optional(Json{*input, *output}) : std::nullopt;
}

// The coordinates are those of both added links, not yet of the map.
std::optional<Json> place_of_added(const Json& linkage, Json& task) {
  if (!linkage.contains("chain") || !linkage.contains("added") || linkage["added"].size() != 2) return std::nullopt;
  task["chain"] = linkage["chain"];
  task["added"] = Json::array();
  Json coordinates;
  for (const Json& link : linkage["added"]) {
    const auto coordinate = coordinate_of(link);
    if (!coordinate || !link.contains("between")) return std::nullopt;
    task["added"].push_back(link["between"]);
    coordinates.push_back(*coordinate);
  }
  return coordinates;
}

std::optional<Json> place_of_line(const Json& linkage, Json& task) {
  if (!linkage.contains("place")) return std::nullopt;
  if (linkage.contains("task")) task = linkage["task"];
  return linkage["place"];
}

// A ground pivot that was searched for is given then.
void keep_pivot(const Json& linkage, Json& task) {
  const Json input = linkage.value("input", Json());
  if (!task.contains("kind") || task["kind"] != "path" || task.contains("given") || !input.is_object()) return;
  task["given"] = {{"ground_pivots", {{"input", input.value("center_point", Json())}}}};
}

// Of a six-bar's second link the map may have the share of its curve.
void put_on_map(Problem& problem) {
  const auto* task = std::get_if<SixBarTask>(&problem.task);
  const auto family = task ? ChainFamily::of(*task) : nullptr;
  if (!family) return;
  const auto first = family->six_bars().with_first(problem.options.at->input);
  if (first) problem.options.at->output = family->six_bars().second_coordinate(*first, problem.options.at->output);
}

bool is_result(const Json& file) {
  if (!file.is_object() || !file.contains("problem") || !file.contains("linkages")) return false;
  const Json& problem = file["problem"];
  const bool has_task = problem.is_object() && problem.contains("task") && problem["task"].is_object();
  const bool has_options = has_task && problem.contains("options") && problem["options"].is_object();
  return has_options && file["linkages"].is_array();
}

Error no_place() {
  return {"no_place", "linkages", "this linkage stands at no place of a map; solve its problem anew"};
}

}  // namespace

Result<ListedProblem> read_listed_problem(std::string_view text, int linkage) {
  const auto tree = parse_json(text, {.max_bytes = max_result_bytes,
                                      .deepest_nesting = deepest_nesting,
                                      .kept = {"linkwright", "problem", "linkages", "task"}});
  if (!tree) return tree.errors();
  Mistakes mistakes;
  const JsonValue root(*tree, "", mistakes);
  if (const auto refusal = refuse_version(root)) return *refusal;
  if (!is_result(*tree))
    return Error{"no_result", "",
                 "this is not a result file; make one with: linkwright solve PROBLEM.json -o RESULT.json"};
  const Json& linkages = (*tree)["linkages"];
  const auto count = static_cast<int>(linkages.size());
  if (linkage < 1 || linkage > count)
    return Error{"no_such_linkage", "--linkage",
                 count == 0 ? "this result holds no linkages; its \"reason\" says why"
                            : fmt::format("there is no linkage {}; this result holds 1 to {}", linkage, count)};
  const Json& element = linkages[static_cast<std::size_t>(linkage - 1)];
  if (!element.is_object()) return no_place();
  Json problem = (*tree)["problem"];
  Json& task = problem["task"];
  auto place = place_of_sides(element);
  if (!place) place = place_of_added(element, task);
  if (!place) place = place_of_line(element, task);
  if (!place) return no_place();
  problem["options"]["at"] = *place;
  if (problem["options"].erase("box") > 0) keep_pivot(element, task);
  auto read = read_problem(problem.dump());
  if (!read) return read.errors();
  put_on_map(*read);
  const bool has_layer = element.contains("layer") && element["layer"].is_number_integer();
  return ListedProblem{*std::move(read), has_layer ? element["layer"].get<int>() : 0};
}

}  // namespace linkwright
