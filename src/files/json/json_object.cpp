#include "json_object.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <vector>

#include "files/json/json.hpp"
#include "linkwright/files/nearest_name.hpp"

namespace linkwright {
namespace {

Wanted type_of(const Json& value) {
  if (value.is_number()) return {"number", "a number"};
  if (value.is_string()) return {"text", "a text"};
  if (value.is_boolean()) return {value.get<bool>() ? "true" : "false"};
  if (value.is_array()) return {"list", "a list"};
  return value.is_object() ? Wanted{"object", "an object"} : Wanted{"null"};
}

std::string member_place(const std::string& place, std::string_view key) {
  return place.empty() ? presentable(key) : place + "." + presentable(key);
}

std::string all_in_quotes(std::span<const std::string_view> names) {
  std::string text;
  for (const std::string_view name : names) text += (text.empty() ? "" : ", ") + in_quotes(name);
  return text;
}

}  // namespace

bool JsonValue::is_null() const { return value_->is_null(); }
bool JsonValue::is_object() const { return value_->is_object(); }

void JsonValue::mistake(std::string code, std::string message, Values values) const {
  mistakes_->add(std::move(code), place_, std::move(message), std::move(values));
}

void JsonValue::wrong_type(Wanted wanted) const {
  const Wanted found = type_of(*value_);
  mistake("wrong_type", fmt::format("{} belongs here, not {}", wanted.words, found.words),
          {{"wanted", wanted.name}, {"found", found.name}});
}

std::optional<double> JsonValue::as_number() const {
  if (value_->is_number()) return value_->get<double>();
  wrong_type({"number", "a number"});
  return std::nullopt;
}

std::optional<int> JsonValue::as_whole_number() const {
  constexpr double most = 1e9;
  if (!value_->is_number()) {
    wrong_type({"whole_number", "a whole number"});
    return std::nullopt;
  }
  const double number = value_->get<double>();
  if (number == std::floor(number)) return static_cast<int>(std::clamp(number, -most, most));
  mistake("not_whole", fmt::format("a whole number belongs here, not {}", number), {{"found", number}});
  return std::nullopt;
}

std::optional<bool> JsonValue::as_flag() const {
  if (value_->is_boolean()) return value_->get<bool>();
  wrong_type({"flag", "true or false"});
  return std::nullopt;
}

std::optional<std::string> JsonValue::as_text() const {
  if (value_->is_string()) return value_->get<std::string>();
  wrong_type({"quoted_text", "a text in double quotes"});
  return std::nullopt;
}

std::optional<std::string_view> JsonValue::as_one_of(std::span<const std::string_view> names) const {
  const auto text = as_text();
  if (!text) return std::nullopt;
  const auto found = std::find(names.begin(), names.end(), *text);
  if (found != names.end()) return *found;
  const std::string given = in_quotes(*text);
  if (const std::string_view near = nearest_name(*text, names); !near.empty())
    mistake("unknown_name", fmt::format("{} is not known here; the nearest known name is {}", given, in_quotes(near)),
            {{"given", given}, {"name", in_quotes(near)}});
  else
    mistake("foreign_name", fmt::format("{} is not known here; known are {}", given, all_in_quotes(names)),
            {{"given", given}, {"names", all_in_quotes(names)}});
  return std::nullopt;
}

bool JsonValue::for_each(Wanted what, const std::function<void(const JsonValue&)>& element) const {
  if (!value_->is_array()) {
    wrong_type(what);
    return false;
  }
  std::size_t index = 0;
  for (const Json& item : *value_) element({item, fmt::format("{}[{}]", place_, index++), *mistakes_});
  return true;
}

std::optional<Point> JsonValue::as_pair(Wanted form) const {
  const auto is_number = [](const Json& item) { return item.is_number(); };
  if (!value_->is_array() || value_->size() != 2 || std::none_of(value_->begin(), value_->end(), is_number)) {
    mistake("two_numbers", fmt::format("two numbers {} belong here", form.words), {{"form", form.name}});
    return std::nullopt;
  }
  std::vector<double> numbers;
  for_each(form, [&](const JsonValue& item) {
    if (const auto number = item.as_number()) numbers.push_back(*number);
  });
  if (numbers.size() != 2) return std::nullopt;
  return Point{numbers[0], numbers[1]};
}

JsonObject::JsonObject(const JsonValue& value, Mistakes& mistakes, std::span<const std::string_view> known)
    : value_(value), mistakes_(&mistakes) {
  if (!value.is_object()) {
    value.wrong_type({"object_in_braces", "an object { … }"});
    return;
  }
  if (known.size() == 0) return;
  for (const auto& member : value.json().items()) {
    if (std::find(known.begin(), known.end(), member.key()) != known.end()) continue;
    const std::string place = member_place(value.place(), member.key());
    if (const std::string_view near = nearest_name(member.key(), known); !near.empty())
      mistakes.add("unknown_key", place,
                   fmt::format("this key is not known here; the nearest known one is {}", in_quotes(near)),
                   {{"name", in_quotes(near)}});
    else
      mistakes.add("foreign_key", place, fmt::format("this key is not known here; known are {}", all_in_quotes(known)),
                   {{"names", all_in_quotes(known)}});
  }
}

std::optional<JsonValue> JsonObject::find(std::string_view key) const {
  if (!value_.is_object()) return std::nullopt;
  const auto found = value_.json().find(std::string(key));
  if (found == value_.json().end()) return std::nullopt;
  return JsonValue(*found, member_place(value_.place(), key), *mistakes_);
}

std::optional<JsonValue> JsonObject::require(std::string_view key, Wanted what) const {
  auto found = find(key);
  if (!found && value_.is_object()) {
    mistakes_->add("missing_key", member_place(value_.place(), key), fmt::format("this is missing; add {}", what.words),
                   {{"what", what.name}});
  }
  return found;
}

std::optional<Point> JsonObject::require_point(std::string_view key) const {
  const auto found = require(key, {"two_coordinates", "two numbers [x, y]"});
  return found ? found->as_pair({"[x, y]"}) : std::nullopt;
}

}  // namespace linkwright
