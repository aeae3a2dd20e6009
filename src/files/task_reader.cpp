#include "task_reader.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <string>

#include "kinds.hpp"
#include "linkwright/files/nearest_name.hpp"
#include "vocabulary.hpp"

namespace linkwright {
namespace {

constexpr std::string_view what_is_available =
    "there are motion by a four_bar, a six_bar or a spherical_four_bar, function by a four_bar or a "
    "spherical_four_bar, and straight_line by a four_bar";

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

/// The kind and the mechanism each may be there, but not together.
void refuse(const JsonObject& task, std::string_view kind, std::string_view mechanism) {
  const auto has = [&](std::string_view TaskForm::*what, std::string_view name) {
    return std::any_of(task_forms.begin(), task_forms.end(), [&](const TaskForm& form) { return form.*what == name; });
  };
  if (!has(&TaskForm::kind, kind)) return not_available(task, "kind", kind);
  if (!has(&TaskForm::mechanism, mechanism)) return not_available(task, "mechanism", mechanism);
  const std::string wanted = fmt::format("{} by a {}", kind, mechanism);
  task.find("mechanism")
      ->mistake("no_such_task", fmt::format("{} is not available in this version; {}", wanted, what_is_available),
                {{"wanted", wanted}});
}

}  // namespace

Task read_task(const JsonValue& value, const std::optional<Box>& options_box, Mistakes& mistakes) {
  const JsonObject any(value, mistakes, {});
  if (!value.is_object()) return MotionTask{};
  if (const auto kind = any.find("kind"); kind && kind->json() == "attitude") {
    kind->mistake(
        "attitude_is_no_linkage",
        "an attitude is no linkage to be solved for: open this file in the workbench, or give its orientation "
        "to linkwright attitude convert");
    return MotionTask{};
  }
  const auto kind = required_name(any, "kind", task_kinds);
  const auto mechanism = required_name(any, "mechanism", mechanism_names);
  if (!kind || !mechanism) return MotionTask{};
  for (const TaskForm& form : task_forms)
    if (form.kind == *kind && form.mechanism == *mechanism) return form.read(value, options_box, mistakes);
  refuse(any, *kind, *mechanism);
  return MotionTask{};  // other kinds have other keys
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
