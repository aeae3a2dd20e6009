#pragma once

#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace linkwright {

/// A number or a word in a sentence of ours.
struct NamedValue {
  NamedValue(std::string its_name, std::string_view word) : name(std::move(its_name)), value(std::string(word)) {}
  /// Integers beyond 2^53 are rounded.
  template <class Number>
  requires std::is_arithmetic_v<Number> NamedValue(std::string its_name, Number number)
      : name(std::move(its_name)), value(static_cast<double>(number)) {}

  std::string name;
  std::variant<double, std::string> value;
};

/// What a sentence says, in a form that others can word anew.
using Values = std::vector<NamedValue>;

}  // namespace linkwright
