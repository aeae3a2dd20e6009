#include <algorithm>
#include <fmt/format.h>
#include <string>
#include <vector>

#include "field_reader.hpp"
#include "files/json/json.hpp"
#include "linkwright/files/nearest_name.hpp"

namespace linkwright {
namespace {

std::vector<std::string_view> names(std::span<const Kind> kinds, std::string_view Kind::*part) {
  std::vector<std::string_view> all;
  for (const Kind& each : kinds)
    if (std::find(all.begin(), all.end(), each.*part) == all.end()) all.push_back(each.*part);
  return all;
}

std::string in_words(const std::vector<std::string>& all, std::string_view last) {
  std::string text;
  for (std::size_t i = 0; i < all.size(); ++i)
    text += fmt::format("{}{}", i == 0 ? "" : i + 1 == all.size() ? last : ", ", all[i]);
  return text;
}

/// "there are motion by a four_bar or a six_bar, and …"
std::string what_is_available(std::span<const Kind> all) {
  std::vector<std::string> tasks;
  for (const std::string_view kind : names(all, &Kind::kind)) {
    std::vector<std::string> mechanisms;
    for (const Kind& each : all)
      if (each.kind == kind) mechanisms.push_back(fmt::format("a {}", each.mechanism));
    tasks.push_back(fmt::format("{} by {}", kind, in_words(mechanisms, " or ")));
  }
  return "there are " + in_words(tasks, ", and ");
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
      ->mistake("no_such_task", fmt::format("{} is not available in this version; {}", wanted, what_is_available(all)),
                {{"wanted", wanted}});
}

}  // namespace linkwright
