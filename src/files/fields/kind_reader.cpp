#include <algorithm>
#include <fmt/format.h>
#include <string>
#include <vector>

#include "field_reader.hpp"
#include "files/json/json.hpp"
#include "linkwright/files/nearest_name.hpp"

namespace linkwright {
namespace {

constexpr std::string_view what_is_available =
    "there are motion by a four_bar, a six_bar or a spherical_four_bar, function by a four_bar or a "
    "spherical_four_bar, and straight_line by a four_bar";

std::vector<std::string_view> names(std::span<const Kind> kinds, std::string_view Kind::*part) {
  std::vector<std::string_view> all;
  for (const Kind& each : kinds)
    if (std::find(all.begin(), all.end(), each.*part) == all.end()) all.push_back(each.*part);
  return all;
}

std::optional<std::string_view> required_name(const JsonObject& task, std::string_view key,
                                              std::span<const std::string_view> known) {
  const std::string example = fmt::format("\"{}\": \"{}\"", key, known.front());
  const auto found = task.require(key, {std::string_view(example)});
  return found ? found->as_one_of(known) : std::nullopt;
}

bool is_attitude(const JsonObject& task) {
  const auto kind = task.find("kind");
  if (!kind || kind->json() != "attitude") return false;
  kind->mistake("attitude_is_no_linkage",
                "an attitude is no linkage to be solved for: open this file in the workbench, or give its orientation "
                "to linkwright attitude convert");
  return true;
}

}  // namespace

void FieldReader::kinds(std::size_t /*current*/, std::span<const Kind> all) {
  const JsonObject task(at_, mistakes_, {});
  if (!at_.is_object() || is_attitude(task)) return;
  const auto kind = required_name(task, "kind", names(all, &Kind::kind));
  const auto mechanism = required_name(task, "mechanism", names(all, &Kind::mechanism));
  if (!kind || !mechanism) return;
  for (const Kind& each : all)
    if (each.kind == *kind && each.mechanism == *mechanism) return each.task(*this);
  const std::string wanted = fmt::format("{} by a {}", *kind, *mechanism);
  task.find("mechanism")
      ->mistake("no_such_task", fmt::format("{} is not available in this version; {}", wanted, what_is_available),
                {{"wanted", wanted}});
}

}  // namespace linkwright
