#pragma once

#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "linkwright/core/precondition.hpp"

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

/// The caller's mistake: what is wrong, where, and the way out.
struct Error {
  std::string code;     ///< stable identifier, one to a sentence, e.g. `repeated_pose`
  std::string place;    ///< where, e.g. `task.poses[2].theta_deg`; empty when it is the whole input
  std::string message;  ///< one sentence: what is wrong and the way out
  Values values{};      ///< the numbers and words in the message
};

/// A value, or the caller's mistakes (at least one). Mathematics that says "no" is a value, not an error.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : content_(std::move(value)) {}
  Result(Error error) : content_(std::vector<Error>{std::move(error)}) {}
  /// At least one: asserted.
  Result(std::vector<Error> errors) : content_(std::move(errors)) {
    require(!this->errors().empty(), "a result without a value says why");
  }

  /// There is a value, and so there are no errors.
  [[nodiscard]] bool ok() const { return std::holds_alternative<T>(content_); }
  explicit operator bool() const { return ok(); }

  /// Ends the program where there are errors instead: ask ok() first.
  [[nodiscard]] const T& value() const& { return *checked(std::get_if<T>(&content_), no_value); }
  [[nodiscard]] T& value() & { return *checked(std::get_if<T>(&content_), no_value); }
  [[nodiscard]] T&& value() && { return std::move(*checked(std::get_if<T>(&content_), no_value)); }
  [[nodiscard]] const T& operator*() const& { return value(); }
  [[nodiscard]] T& operator*() & { return value(); }
  [[nodiscard]] const T* operator->() const { return &value(); }
  [[nodiscard]] T* operator->() { return &value(); }
  /// Ends the program where there is a value.
  [[nodiscard]] const std::vector<Error>& errors() const {
    return *checked(std::get_if<std::vector<Error>>(&content_), "a result with a value has no errors");
  }

 private:
  static constexpr const char* no_value = "the value of a result is asked for that has errors";

  template <class P>
  static P* checked(P* pointer, const char* sentence) {
    require(pointer != nullptr, sentence);
    return pointer;
  }

  std::variant<T, std::vector<Error>> content_;
};

/// Something to tell the user about an answer: a sentence, and what it says in a form that others can word anew.
struct Notice {
  std::string code;     ///< stable identifier, e.g. ill_conditioned
  std::string message;  ///< one sentence or two, with the way out
  Values values;        ///< the numbers and words in the message
};

}  // namespace linkwright
