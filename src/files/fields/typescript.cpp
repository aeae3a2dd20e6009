#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <string>

#include "field_schema.hpp"

namespace linkwright {
namespace {

/// "motion_task": MotionTask.
std::string type_name(std::string_view definition) {
  std::string name;
  bool starts = true;
  for (const char letter : definition) {
    if (letter != '_') name += starts ? static_cast<char>(std::toupper(static_cast<unsigned char>(letter))) : letter;
    starts = letter == '_';
  }
  return name;
}

/// "axis_quantity": axis_quantities.
std::string plural(std::string_view definition) {
  const bool ends_in_y = definition.ends_with("ty");
  return std::string(definition.substr(0, definition.size() - (ends_in_y ? 1 : 0))) + (ends_in_y ? "ies" : "s");
}

/// Where a reference leads: of "problem.schema.json#/$defs/pose" "pose", of "problem.schema.json" "problem".
std::string_view target_of(std::string_view reference) {
  constexpr std::string_view definitions = "#/$defs/";
  const std::size_t at = reference.find(definitions);
  return at == std::string_view::npos ? reference.substr(0, reference.find('.'))
                                      : reference.substr(at + definitions.size());
}

struct TypeScript {
  const OrderedJson& definitions;

  /// What has no members is told where it stands.
  [[nodiscard]] static bool has_name(const OrderedJson& schema) {
    return schema.contains("properties") || schema.contains("oneOf") || schema.contains("enum");
  }

  [[nodiscard]] std::string reference(const std::string& to) const {
    const std::string name(target_of(to));
    if (!to.starts_with('#') || has_name(definitions.at(name))) return type_name(name);
    return type(definitions.at(name));
  }

  [[nodiscard]] std::string any(const OrderedJson& schemas) const {
    std::string text;
    for (const OrderedJson& each : schemas) text += (text.empty() ? "" : " | ") + type(each);
    return text;
  }

  [[nodiscard]] std::string list(const OrderedJson& schema) const {
    const std::string item = type(schema.at("items"));
    const auto count = schema.value("minItems", std::size_t{0});
    constexpr std::size_t longest_tuple = 4;
    if (count == 0 || count != schema.value("maxItems", std::size_t{0}) || count > longest_tuple)
      return item.find_first_of(" |{") == std::string::npos ? fmt::format("readonly {}[]", item)
                                                            : fmt::format("readonly ({})[]", item);
    std::string items = item;
    for (std::size_t i = 1; i < count; ++i) items += ", " + item;
    return fmt::format("readonly [{}]", items);
  }

  [[nodiscard]] std::string members(const OrderedJson& schema) const {
    std::string text;
    const OrderedJson required = schema.value("required", OrderedJson::array());
    for (const auto& [key, member] : schema.at("properties").items()) {
      if (member.contains("description"))
        text += fmt::format("/** {} */\n", member.at("description").get_ref<const std::string&>());
      const bool is_required = std::find(required.begin(), required.end(), key) != required.end();
      text += fmt::format("{}{}: {};\n", key, is_required ? "" : "?", type(member));
    }
    return fmt::format("{{\n{}}}", text);
  }

  [[nodiscard]] std::string object(const OrderedJson& schema) const {
    const bool has_members = schema.contains("properties");
    if (schema.contains("propertyNames"))
      return fmt::format("Readonly<Record<string, {}>>", type(schema.at("additionalProperties")));
    if (!schema.contains("oneOf")) return has_members ? members(schema) : "object";
    const std::string alternatives = any(schema.at("oneOf"));
    return has_members ? fmt::format("{} & ({})", members(schema), alternatives) : alternatives;
  }

  [[nodiscard]] std::string type(const OrderedJson& schema) const {
    if (schema.contains("$ref")) return reference(schema.at("$ref").get_ref<const std::string&>());
    if (schema.contains("const")) return schema.at("const").dump();
    if (schema.contains("enum")) {
      std::string names;
      for (const OrderedJson& each : schema.at("enum")) names += (names.empty() ? "" : " | ") + each.dump();
      return names;
    }
    if (schema.contains("anyOf")) return any(schema.at("anyOf"));
    if (!schema.contains("type")) return object(schema);
    return type(schema, schema.at("type"));
  }

  [[nodiscard]] std::string type(const OrderedJson& schema, const OrderedJson& kind) const {
    if (kind.is_array()) return fmt::format("{} | null", type(schema, kind.front()));
    if (kind == "array") return list(schema);
    if (kind == "object") return object(schema);
    return kind == "integer" ? "number" : kind.get<std::string>();
  }
};

/// Two blanks to each brace.
std::string indented(std::string_view text) {
  std::string lines;
  std::size_t depth = 0;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(line.size() + 1);
    if (line.starts_with('}')) --depth;
    lines += fmt::format("{}{}\n", std::string(2 * depth, ' '), line);
    if (line.ends_with('{')) ++depth;
  }
  return lines;
}

}  // namespace

std::string typescript(const OrderedJson& schema, std::string_view name) {
  const TypeScript types{schema.at("$defs")};
  std::string text;
  const auto define = [&](std::string_view type, const OrderedJson& definition) {
    const std::string written = types.type(definition);
    const bool is_interface = written.starts_with('{') && !definition.contains("oneOf");
    if (definition.contains("description"))
      text += fmt::format("/** {} */\n", definition.at("description").get_ref<const std::string&>());
    text += fmt::format("export {} {}{} {}\n", is_interface ? "interface" : "type", type, is_interface ? "" : " =",
                        is_interface ? written : written + ";");
  };
  define(name, schema);
  for (const auto& [key, definition] : schema.at("$defs").items()) {
    if (definition.contains("enum"))
      text += fmt::format("export const {0} = {1} as const;\nexport type {2} = (typeof {0})[number];\n", plural(key),
                          definition.at("enum").dump(), type_name(key));
    else if (TypeScript::has_name(definition))
      define(type_name(key), definition);
  }
  return indented(text);
}

}  // namespace linkwright
