#pragma once

#include <functional>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "fields/field_visitor.hpp"
#include "files/json/json_fwd.hpp"
#include "linkwright/algebra/point.hpp"
#include "mistakes.hpp"

namespace linkwright {

/// A value of the file being read, where it stands, and where its mistakes go. Every `as_…` gives the value, or notes a
/// mistake and gives nothing.
class JsonValue {
 public:
  JsonValue(const Json& value, std::string place, Mistakes& mistakes)
      : value_(&value), place_(std::move(place)), mistakes_(&mistakes) {}

  [[nodiscard]] const Json& json() const { return *value_; }
  [[nodiscard]] const std::string& place() const { return place_; }
  [[nodiscard]] bool is_null() const;
  [[nodiscard]] bool is_object() const;

  [[nodiscard]] std::optional<double> as_number() const;
  [[nodiscard]] std::optional<int> as_whole_number()
      const;  ///< held to ±1e9, so that range checks see what is too large
  [[nodiscard]] std::optional<bool> as_flag() const;
  [[nodiscard]] std::optional<std::string> as_text() const;
  [[nodiscard]] std::optional<std::string_view> as_one_of(std::span<const std::string_view> names) const;
  /// Calls `element` for each element; false, with a mistake, when it is no array.
  bool for_each(Wanted what, const std::function<void(const JsonValue&)>& element) const;
  /// [a, b]; `form` shows the two: "[x, y]".
  [[nodiscard]] std::optional<Point> as_pair(Wanted form) const;

  void mistake(std::string code, std::string message, Values values = {}) const;
  /// "… belongs here, not …".
  void wrong_type(Wanted wanted) const;

 private:
  const Json* value_;
  std::string place_;
  Mistakes* mistakes_;
};

/// An object of the file being read. Members are looked up by key; those nobody knows are mistakes.
class JsonObject {
 public:
  /// Notes a mistake when `value` is no object; then it has no members. `known`: all keys allowed; empty: any.
  JsonObject(const JsonValue& value, Mistakes& mistakes, std::span<const std::string_view> known);
  JsonObject(const JsonValue& value, Mistakes& mistakes, std::initializer_list<std::string_view> known)
      : JsonObject(value, mistakes, std::span(known.begin(), known.size())) {}

  [[nodiscard]] std::optional<JsonValue> find(std::string_view key) const;
  /// As find(), but notes a mistake when the key is missing; `what` says what belongs there ("a number").
  [[nodiscard]] std::optional<JsonValue> require(std::string_view key, Wanted what) const;
  [[nodiscard]] std::optional<Point> require_point(std::string_view key) const;

 private:
  JsonValue value_;
  Mistakes* mistakes_;
};

}  // namespace linkwright
