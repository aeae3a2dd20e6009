#include "field_schema.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "analyses/analyses.hpp"
#include "field_writer.hpp"
#include "files/analysis_fields.hpp"
#include "files/json/json_writer.hpp"
#include "files/problem_fields.hpp"
#include "files/result_fields.hpp"

namespace linkwright {
namespace {

OrderedJson bound(double value) {
  constexpr double exact = 9007199254740992;  // 2^53
  if (std::abs(value) <= exact && value == std::floor(value)) return static_cast<std::int64_t>(value);
  return value;
}

OrderedJson list_of(std::size_t least, std::size_t most, OrderedJson element) {
  OrderedJson schema = {{"type", "array"}};
  if (least > 0) schema["minItems"] = least;
  if (most != List{.what = ""}.most) schema["maxItems"] = most;
  schema["items"] = std::move(element);
  return schema;
}

OrderedJson or_null(OrderedJson schema) {
  if (schema.size() == 1 && schema.contains("anyOf")) {
    schema["anyOf"].push_back({{"type", "null"}});
    return schema;
  }
  if (!schema.contains("type") || schema.contains("enum") || schema.contains("$ref"))
    return {{"anyOf", {std::move(schema), {{"type", "null"}}}}};
  schema["type"] = {schema["type"], "null"};
  return schema;
}

OrderedJson described(Sentence about, const OrderedJson& schema) {
  OrderedJson whole = OrderedJson::object();
  if (!about.words.empty()) whole["description"] = about.words;
  whole.update(schema);
  return whole;
}

/// As it is written; null where it is an object, or nothing in a list or a text.
OrderedJson written(Visit value) {
  const OrderedJson json = OrderedJson::parse(json_text_of([&](JsonWriter& to) {
    FieldWriter writer(to);
    value(writer);
  }));
  return json.is_object() || json.empty() || json == "" ? OrderedJson() : json;
}

}  // namespace

OrderedJson FieldSchema::take(const OrderedJson& rules) {
  OrderedJson whole = rules;
  whole.erase("$defs");
  whole.update(std::exchange(schema_, OrderedJson::object()));
  whole["$defs"] = std::exchange(definitions_, OrderedJson::object());
  whole.merge_patch(rules);
  return whole;
}

OrderedJson FieldSchema::of(Visit value) {
  const OrderedJson outer = std::exchange(schema_, OrderedJson::object());
  value(*this);
  return std::exchange(schema_, outer);
}

void FieldSchema::define(std::string_view name, Sentence about, OrderedJson schema) {
  const OrderedJson whole = described(about, schema);
  if (name.empty()) {
    schema_.update(whole);
    return;
  }
  definitions_[name] = whole;
  schema_["$ref"] = "#/$defs/" + std::string(name);
}

bool FieldSchema::member(const Field& field, bool is_required, Visit value) {
  const bool has_default = defaults_ == Defaults::told && !field.is_absent && !is_required;
  const OrderedJson default_value = has_default ? written(value) : OrderedJson();
  OrderedJson whole = described(field.about, of(value));
  if (!default_value.is_null()) whole["default"] = default_value;
  schema_["properties"][field.key] = whole;
  if (is_required) schema_["required"].push_back(field.key);
  return true;
}

void FieldSchema::constant(std::string_view key, std::string_view value) {
  schema_["properties"][key] = {{"const", value}};
  schema_["required"].push_back(key);
}

void FieldSchema::alternative(const Object& described_as, Visit members) {
  const OrderedJson own = of(members);
  alternatives_.push_back(of([&](FieldVisitor&) { define(described_as.name, described_as.about, own); }));
}

void FieldSchema::one_of(std::size_t /*current*/, std::span<const Alternative> alternatives, const OneOf& /*wrong*/) {
  for (const Alternative& each : alternatives) alternative(each.described, each.members);
}

void FieldSchema::switch_on(const Field& field, std::size_t /*current*/, std::span<const Case> cases) {
  for (const Case& each : cases)
    alternative(each.described, [&](FieldVisitor& to) {
      to.constant(field.key, each.name);
      each.members(to);
    });
}

void FieldSchema::orientation(GivenOrientation& /*orientation*/) {
  const OrderedJson vector = list_of(3, 3, {{"type", "number"}});
  const OrderedJson angle = {{"type", "number"}, {"minimum", bound(-1e12)}, {"maximum", bound(1e12)}};
  OrderedJson& members = schema_["properties"];
  members["matrix"] = list_of(3, 3, vector);
  members["nearest"] =
      described("Of a matrix: whether the nearest rotation is meant; without it, no.", {{"type", "boolean"}});
  members["axis"] = described("Of any length, not null.", vector);
  members["angle_deg"] = angle;
  members["quaternion"] = described("[w, x, y, z] of any length, not null.", list_of(4, 4, {{"type", "number"}}));
  members["rotation_vector"] = described("Along the axis, its length the angle in radians.", vector);
  members["euler_deg"] = list_of(3, 3, angle);
  members["sequence"] =
      described("Of the axes, as in \"zyx\", \"ZYX\" or \"3-2-1\"; capitals mean the same.", {{"type", "string"}});
  members["turning"] = described("About axes carried along, as without it, or about fixed ones.",
                                 {{"enum", {"intrinsic", "extrinsic"}}});
}

void FieldSchema::object(const Object& described_as, Visit members) {
  auto outer = std::exchange(alternatives_, {});
  OrderedJson whole = {{"type", "object"}};
  whole.update(of(members));
  if (!alternatives_.empty()) whole["oneOf"] = alternatives_;
  whole[alternatives_.empty() ? "additionalProperties" : "unevaluatedProperties"] = false;
  alternatives_ = std::move(outer);
  define(described_as.name, described_as.about, whole);
}

void FieldSchema::kinds(std::size_t /*current*/, std::span<const Kind> all) {
  OrderedJson any = OrderedJson::array();
  for (const Kind& each : all) any.push_back(of(each.task));
  define("task", "What the linkage is for.", {{"type", "object"}, {"required", {"kind", "mechanism"}}, {"oneOf", any}});
}

void FieldSchema::shapes(std::size_t /*current*/, std::span<const Shape> shapes, std::optional<Wanted> /*otherwise*/) {
  OrderedJson any = OrderedJson::array();
  for (const Shape& each : shapes) {
    OrderedJson shape = each.only.empty() ? of(each.value) : OrderedJson{{"const", each.only}};
    if (std::find(any.begin(), any.end(), shape) == any.end()) any.push_back(std::move(shape));
  }
  schema_["anyOf"] = any;
}

void FieldSchema::null_or(bool& /*is_there*/, Visit value) { schema_ = or_null(of(value)); }

void FieldSchema::list(const List& described_as, std::size_t count, VisitElement element) {
  const std::size_t least = described_as.is_of_length ? described_as.most : described_as.least;
  const OrderedJson item = of([&](FieldVisitor& to) { element(to, count == 0 ? 0 : count - 1); });
  define(described_as.name, described_as.about, list_of(least, described_as.most, item));
}

OrderedJson FieldSchema::of(const Number& number) const {
  if (number.least == number.most) return {{"const", bound(number.least)}};
  OrderedJson schema = {{"type", number.is_whole ? "integer" : "number"}};
  if (number.least != -Number::unlimited) schema[number.above ? "exclusiveMinimum" : "minimum"] = bound(number.least);
  if (number.most != Number::unlimited) schema[number.below ? "exclusiveMaximum" : "maximum"] = bound(number.most);
  return number.null ? or_null(schema) : schema;
}

void FieldSchema::number(double& /*value*/, const Number& number) { define(number.name, number.about, of(number)); }

void FieldSchema::whole(std::int64_t& /*value*/, const Whole& whole) {
  schema_ = {{"type", "integer"}, {"minimum", whole.least}};
  if (whole.most != std::numeric_limits<std::int64_t>::max()) schema_["maximum"] = whole.most;
}

void FieldSchema::flag(bool& /*value*/) { schema_["type"] = "boolean"; }
void FieldSchema::text(std::string& /*value*/) { schema_["type"] = "string"; }

void FieldSchema::name(std::size_t& /*chosen*/, std::span<const std::string_view> names) { schema_["enum"] = names; }

void FieldSchema::pair(std::array<double, 2>& /*value*/, const Pair& pair) {
  double each = 0;
  const OrderedJson item = of([&](FieldVisitor& to) { to.number(each, pair.each); });
  define(pair.name, pair.about, list_of(2, 2, item));
}

void FieldSchema::vector(Vector3& /*value*/, const Vector& vector) {
  double each = 0;
  const OrderedJson item = of([&](FieldVisitor& to) { to.number(each, vector.each); });
  define(vector.name, vector.about, list_of(3, 3, item));
}

void FieldSchema::foreign(std::string& /*object*/) { schema_["type"] = "object"; }

void FieldSchema::named(std::string_view name, Visit value) { define(name, "", of(value)); }
void FieldSchema::described_in(std::string_view where, Visit /*value*/) { schema_["$ref"] = where; }

void FieldSchema::keyed(const Keyed& described_as, std::span<const std::string> keys, VisitElement value) {
  const OrderedJson each = of([&](FieldVisitor& to) { value(to, keys.empty() ? 0 : keys.size() - 1); });
  schema_ = {
      {"type", "object"}, {"propertyNames", {{"pattern", described_as.pattern}}}, {"additionalProperties", each}};
}

void FieldSchema::bytes(std::size_t /*rows*/, BytesOfRow /*of_row*/) {
  define("base64", "", {{"type", "string"}, {"contentEncoding", "base64"}, {"pattern", "^[A-Za-z0-9+/]*={0,2}$"}});
}

namespace {

std::string on_a_line(const OrderedJson& json) {
  if (!json.is_structured()) return json.dump(-1, ' ', false);
  std::string text;
  for (const auto& item : json.items())
    text +=
        (text.empty() ? "" : ", ") + (json.is_object() ? json_text(item.key()) + ": " : "") + on_a_line(item.value());
  return json.is_object() ? "{" + text + "}" : "[" + text + "]";
}

}  // namespace

std::string readable(const OrderedJson& json, std::size_t indent, std::size_t beside) {
  constexpr std::size_t widest = 120;
  const std::string line = on_a_line(json);
  if (!json.is_structured() || indent + line.size() + beside <= widest) return line;
  const std::string inner(indent + 2, ' ');
  std::string text;
  for (const auto& item : json.items()) {
    const std::string key = json.is_object() ? json_text(item.key()) + ": " : "";
    text += (text.empty() ? "" : ",\n") + inner + key + readable(item.value(), indent + 2, key.size() + 1);
  }
  const auto [begin, end] = json.is_object() ? std::pair('{', '}') : std::pair('[', ']');
  return fmt::format("{}\n{}\n{}{}", begin, text, std::string(indent, ' '), end);
}

OrderedJson problem_schema(const OrderedJson& rules) {
  Problem problem;
  problem.requirements.min_link_angle = default_min_link_angle;
  FieldSchema visitor;
  fields(visitor, problem);
  return visitor.take(rules);
}

OrderedJson result_schema(const OrderedJson& rules) {
  FieldSchema visitor(FieldSchema::Defaults::left_out);
  fields(visitor, ResultRecord{Problem(), MotionAnswer()});
  return visitor.take(rules);
}

namespace {

template <class Document>
Shape document() {
  return {JsonType::object, [](FieldVisitor& to) { fields(to, Document{}); }};
}

}  // namespace

OrderedJson analysis_schema(const OrderedJson& rules) {
  FieldSchema visitor(FieldSchema::Defaults::left_out);
  std::vector<Shape> documents = {document<LinkageAnalysis>(), document<StoredSixBarAnalysis>(),
                                  document<StoredSphericalAnalysis>(), document<PrescribedInstant>()};
  for (Shape& study : study_documents()) documents.push_back(std::move(study));
  visitor.shapes(0, documents, std::nullopt);
  return visitor.take(rules);
}

}  // namespace linkwright
