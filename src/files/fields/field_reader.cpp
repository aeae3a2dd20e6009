#include "field_reader.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "files/attitude/space_reader.hpp"
#include "files/json/json.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/nearest_name.hpp"

namespace linkwright {
namespace {

bool is_of(JsonType type, const Json& json) {
  switch (type) {
    case JsonType::number:
      return json.is_number();
    case JsonType::text:
      return json.is_string();
    case JsonType::list:
      return json.is_array();
    default:
      return json.is_object();
  }
}

}  // namespace

bool FieldReader::has(std::string_view key) const { return at_.json().contains(std::string(key)); }

bool FieldReader::read_at(JsonValue place, Visit value) {
  const std::size_t before = mistakes_.size();
  std::swap(at_, place);
  const bool was_listing = std::exchange(is_listing_, false);
  value(*this);
  is_listing_ = was_listing;
  std::swap(at_, place);
  return mistakes_.size() == before;
}

bool FieldReader::member(const Field& field, bool is_required, Visit value) {
  if (is_listing_) {
    known_.push_back(field.key);
    return true;
  }
  const JsonObject object(at_, mistakes_, {});
  auto found = is_required ? object.require(field.key, field.wanted.value_or("…")) : object.find(field.key);
  return found ? read_at(*std::move(found), value) : !is_required;
}

void FieldReader::constant(std::string_view key, std::string_view /*value*/) {
  if (is_listing_) known_.push_back(key);
}

void FieldReader::refuse(std::string_view key, std::string_view code, const std::string& message,
                         const Values& values) {
  member(key, false, [&](FieldVisitor& to) { to.mistake(code, message, values); });
}

void FieldReader::keys(std::span<const std::string_view> in_order) {
  if (is_listing_) known_.assign(in_order.begin(), in_order.end());
  told_ = in_order.size();
}

void FieldReader::list_keys_of(std::span<const Alternative> alternatives) {
  for (const Alternative& each : alternatives) each.members(*this);
}

bool FieldReader::misspells_one_of(std::span<const Alternative> alternatives) const {
  if (mistakes_.size() == mistakes_before_) return false;
  std::vector<std::string_view> keys;
  for (const Alternative& each : alternatives) keys.insert(keys.end(), each.keys.begin(), each.keys.end());
  for (const auto& [key, value] : at_.json().items())
    if (std::find(known_.begin(), known_.end(), key) == known_.end() && !nearest_name(key, keys).empty()) return true;
  return false;
}

void FieldReader::one_of(std::size_t /*current*/, std::span<const Alternative> alternatives, const OneOf& wrong) {
  std::vector<std::pair<const Alternative*, std::string_view>> there;
  for (const Alternative& each : alternatives)
    for (const std::string_view key : each.keys)
      if (has(key) && (there.empty() || there.back().first != &each)) there.emplace_back(&each, key);
  if (there.empty() && wrong.none_code.empty()) there.emplace_back(&alternatives.back(), "");
  if (there.size() == 1 || (there.size() > 1 && wrong.two_code.empty())) return there[0].first->members(*this);
  if (is_listing_) return list_keys_of(alternatives);
  if (there.empty() && misspells_one_of(alternatives)) return;
  if (there.empty()) return at_.mistake(std::string(wrong.none_code), std::string(wrong.none));
  const bool tells = wrong.two.find('{') != std::string_view::npos;
  const std::string first = in_quotes(there[0].second), second = in_quotes(there[1].second);
  const std::string message =
      fmt::format(fmt::runtime(wrong.two), fmt::arg("first", first), fmt::arg("second", second));
  at_.mistake(std::string(wrong.two_code), message, tells ? Values{{"first", first}, {"second", second}} : Values{});
}

void FieldReader::switch_on(const Field& field, std::size_t /*current*/, std::span<const Case> cases) {
  std::vector<std::string_view> names;
  for (const Case& each : cases)
    if (std::find(names.begin(), names.end(), each.name) == names.end()) names.push_back(each.name);
  std::optional<std::string_view> chosen;
  if (is_listing_) {
    known_.push_back(field.key);
    if (has(field.key) && at_.json()[std::string(field.key)].is_string())
      chosen = at_.json()[std::string(field.key)].get_ref<const std::string&>();
  } else if (const auto found = JsonObject(at_, mistakes_, {}).require(field.key, field.wanted.value_or("…"))) {
    chosen = found->as_one_of(names);
  }
  for (const Case& each : cases)
    if (chosen == each.name && (each.with.empty() || has(each.with))) return each.members(*this);
  for (const Case& each : cases)
    if (is_listing_) each.members(*this);  // one of them is meant
}

void FieldReader::orientation(GivenOrientation& orientation) {
  static constexpr std::array<const char*, 9> keys = {
      "matrix", "nearest", "axis", "angle_deg", "quaternion", "rotation_vector", "euler_deg", "sequence", "turning"};
  if (is_listing_) {
    known_.insert(known_.end(), keys.begin(), keys.end());
    return;
  }
  if (mistakes_.size() != mistakes_before_) return;
  Json form = Json::object();
  for (const char* key : keys)
    if (has(key)) form[key] = at_.json()[key];
  const auto read = read_orientation(JsonValue(form, at_.place(), mistakes_), mistakes_);
  if (!read) return;
  // As it stood there, but for the sequence, which is written in one way.
  if (read->euler) form["sequence"] = read->euler->sequence.name();
  std::string members;
  for (const char* key : keys)
    if (form.contains(key)) members += fmt::format("{}\"{}\": {}", members.empty() ? "" : ", ", key, form[key].dump());
  orientation = {read->quaternion, members};
}

void FieldReader::look_for_foreign_keys(Visit members) {
  is_listing_ = true;
  known_.clear();
  told_ = 0;
  members(*this);
  if (told_ > 0) known_.resize(told_);
  is_listing_ = false;
  if (others_ == OtherMembers::refused) (void)JsonObject(at_, mistakes_, std::span<const std::string_view>(known_));
}

void FieldReader::object(const Object& /*described*/, Visit members) {
  if (!at_.is_object()) return at_.wrong_type({"object_in_braces", "an object { … }"});
  const std::size_t before = std::exchange(mistakes_before_, mistakes_.size());
  look_for_foreign_keys(members);
  members(*this);
  mistakes_before_ = before;
}

void FieldReader::shapes(std::size_t /*current*/, std::span<const Shape> shapes, std::optional<Wanted> otherwise) {
  for (const Shape& shape : shapes)
    if (is_of(shape.type, at_.json()) && (shape.only.empty() || at_.json() == shape.only)) return shape.value(*this);
  otherwise ? at_.wrong_type(*otherwise) : shapes.back().value(*this);
}

void FieldReader::null_or(bool& is_there, Visit value) { is_there = !at_.is_null() && read_at(at_, value); }

namespace {

/// With {count} and {most}, which are told where the sentence has them.
void refuse_length(const JsonValue& list, std::string_view code, std::string_view sentence, std::size_t most) {
  const auto has = [&](std::string_view word) { return sentence.find(word) != std::string_view::npos; };
  const std::size_t count = list.json().size();
  Values values;
  if (has("{count}")) values.push_back({"count", count});
  if (has("{most}")) values.push_back({"most", most});
  list.mistake(std::string(code), fmt::format(fmt::runtime(sentence), fmt::arg("count", count), fmt::arg("most", most)),
               values);
}

}  // namespace

void FieldReader::list(const List& described, std::size_t /*count*/, VisitElement element) {
  const Json& json = at_.json();
  if (json.is_array() && json.size() > described.most_read)
    return refuse_length(at_, described.code, described.sentence, described.most_read);
  if (described.is_of_length && (!json.is_array() || json.size() != described.most))
    return at_.wrong_type(described.what);
  const std::size_t before = mistakes_.size();
  std::size_t index = 0;
  at_.for_each(described.what, [&](const JsonValue& item) {
    read_at(item, [&](FieldVisitor& to) { element(to, index); });
    ++index;
  });
  if (!described.length_code.empty() && index != described.most && mistakes_.size() == before)
    refuse_length(
        at_, described.length_code,
        index == 1 && !described.sentence_of_one.empty() ? described.sentence_of_one : described.length_sentence,
        described.most);
}

void FieldReader::number(double& value, const Number& described) {
  if (described.null && at_.is_null()) {
    value = *described.null;
  } else if (const auto read = at_.as_number()) {
    value = described.is_angle ? radians(*read) : *read;
  }
}

void FieldReader::whole(std::int64_t& value, const Whole& described) {
  if (!described.refused) {
    if (const auto read = at_.as_whole_number()) value = *read;
  } else if (const auto read = at_.as_number()) {
    const bool fits = *read >= static_cast<double>(described.least) && *read <= static_cast<double>(described.most) &&
                      *read == std::floor(*read);
    value = fits ? static_cast<std::int64_t>(*read) : *described.refused;
  }
}

void FieldReader::flag(bool& value) {
  if (const auto read = at_.as_flag()) value = *read;
}

void FieldReader::text(std::string& value) {
  if (auto read = at_.as_text()) value = *std::move(read);
}

void FieldReader::name(std::size_t& chosen, std::span<const std::string_view> names) {
  if (const auto read = at_.as_one_of(names))
    chosen = static_cast<std::size_t>(std::find(names.begin(), names.end(), *read) - names.begin());
}

void FieldReader::pair(std::array<double, 2>& value, const Pair& described) {
  const auto read = at_.as_pair(described.form);
  if (!read) return;
  value = {read->real(), read->imag()};
  if (described.each.is_angle) value = {radians(value[0]), radians(value[1])};
}

void FieldReader::vector(Vector3& value, const Vector& described) {
  const auto read = described.is_bounded ? read_bounded_vector(at_) : read_vector(at_);
  if (read) value = *read;
}

void FieldReader::foreign(std::string& object) {
  at_.is_object() ? void(object = at_.json().dump()) : at_.wrong_type({"object_in_braces", "an object { … }"});
}

void FieldReader::mistake(std::string_view code, const std::string& message, const Values& values) {
  if (!is_listing_) at_.mistake(std::string(code), message, values);
}

void FieldReader::check(FunctionRef<std::vector<Error>()> mistakes) {
  if (!is_listing_ && mistakes_.size() == mistakes_before_) mistakes_.add_new(mistakes());
}

}  // namespace linkwright
