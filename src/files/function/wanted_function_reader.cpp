#include "files/function/wanted_function_reader.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "files/vocabulary.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/nearest_name.hpp"

namespace linkwright {
namespace {

std::optional<AngleDerivative> read_rates(const JsonValue& value, Mistakes& mistakes) {
  const JsonObject object(value, mistakes, {"input", "output"});
  const auto input = object.require_number("input"), output = object.require_number("output");
  if (!input || !output) return std::nullopt;
  return AngleDerivative{*input, *output};
}

std::optional<AnglePair> read_pair(const JsonValue& value, Mistakes& mistakes) {
  constexpr std::size_t max_derivatives = 4;
  const JsonObject object(value, mistakes, {"input_deg", "output_deg", "derivatives"});
  const auto input = object.require_number("input_deg"), output = object.require_number("output_deg");
  AnglePair pair;
  bool complete = input && output;
  if (const auto derivatives = object.find("derivatives")) {
    if (derivatives->json().is_array() && derivatives->json().size() > max_derivatives) {
      derivatives->mistake("derivative_count_of_pair",
                           fmt::format("{} derivatives are given; a pair has at most {}, remove the others",
                                       derivatives->json().size(), max_derivatives),
                           {{"count", derivatives->json().size()}, {"most", max_derivatives}});
      return std::nullopt;
    }
    complete = derivatives->for_each({"rates", "a list of derivatives [{\"input\": …, \"output\": …}, …]"},
                                     [&](const JsonValue& item) {
                                       const auto rates = read_rates(item, mistakes);
                                       if (rates) pair.derivatives.push_back(*rates);
                                       complete = complete && rates;
                                     }) &&
               complete;
  }
  if (!complete) return std::nullopt;
  pair.input = radians(*input);
  pair.output = radians(*output);
  return pair;
}

bool read_pairs(const JsonValue& value, Mistakes& mistakes, std::vector<AnglePair>& pairs) {
  bool complete = true;
  if (value.json().is_array() && value.json().size() > most_positions_looked_at) {
    value.mistake("pair_count",
                  fmt::format("{} pairs are given; five are the most that can be solved, remove the others, or give "
                              "them as \"function\": {{\"table\": …}}",
                              value.json().size()),
                  {{"count", value.json().size()}});
    return false;
  }
  const bool is_list =
      value.for_each({"pairs", "a list of pairs {\"input_deg\": …, \"output_deg\": …}"}, [&](const JsonValue& item) {
        const auto pair = read_pair(item, mistakes);
        if (pair) pairs.push_back(*pair);
        complete = complete && pair;
      });
  return is_list && complete;
}

/// [low, high] that may be missing; false where it is there and none.
bool read_range(const JsonObject& object, std::string_view key, std::optional<std::array<double, 2>>& range) {
  const auto found = object.find(key);
  if (!found || found->is_null()) return true;
  const auto pair = found->as_pair({"low_high", "[low, high]"});
  if (pair) range = {pair->real(), pair->imag()};
  return pair.has_value();
}

bool read_dial(const JsonObject& object, std::string_view key, std::array<double, 2>& range) {
  const auto found = object.require(key, {"two_angles", "two angles [first, last]"});
  const auto pair = found ? found->as_pair({"first_last", "[first, last]"}) : std::nullopt;
  if (pair) range = {radians(pair->real()), radians(pair->imag())};
  return pair.has_value();
}

bool read_table(const JsonValue& value, std::vector<std::array<double, 2>>& table) {
  bool complete = true;
  const bool is_list = value.for_each({"rows", "a list of rows [x, y]"}, [&](const JsonValue& item) {
    const auto row = item.as_pair({"[x, y]"});
    if (row) table.push_back({row->real(), row->imag()});
    complete = complete && row;
  });
  return is_list && complete;
}

bool read_what_it_is(const JsonObject& object, const JsonValue& value, NamedFunction& function) {
  const auto expression = object.find("expression"), table = object.find("table");
  if (!expression && !table) {
    value.mistake("missing_function",
                  "no function is given; add \"expression\" (\"x^2\", \"sqrt\", \"log\", \"sin\", …) or \"table\": "
                  "[[x, y], …]");
    return false;
  }
  if (expression && table) {
    value.mistake("two_functions", "give an expression or a table, not both");
    return false;
  }
  if (table) return read_table(*table, function.table);
  auto text = expression->as_text();
  if (!text) return false;
  if (text->empty() || presentable(*text) != *text) {  // no line breaks in messages
    expression->mistake(
        "no_expression",
        fmt::format("{} is no expression; write \"x^2\", \"sqrt\", \"log\", \"sin\", …", in_quotes(*text)),
        {{"given", in_quotes(*text)}});
    return false;
  }
  function.expression = *std::move(text);
  return true;
}

bool read_interpolation(const JsonObject& object, NamedFunction& function) {
  constexpr std::array names = {std::string_view("monotone_cubic"), std::string_view("linear")};
  const auto found = object.find("interpolation");
  if (!found) return true;
  const auto written = found->as_one_of(names);
  if (written) function.interpolation = table_interpolation_named(*written).value_or(function.interpolation);
  return written.has_value();
}

bool read_spacing(const JsonObject& object, NamedFunction& function) {
  constexpr std::array names = {std::string_view("chebyshev"), std::string_view("even")};
  const auto found = object.find("spacing");
  if (!found) return true;
  if (!found->json().is_array()) {
    const auto written = found->as_one_of(names);
    if (written) function.spacing = point_spacing_named(*written).value_or(function.spacing);
    return written.has_value();
  }
  function.spacing = PointSpacing::given;
  bool complete = true;
  found->for_each({"list_of_x", "a list of x"}, [&](const JsonValue& item) {
    const auto x = item.as_number();
    if (x) function.given_points.push_back(*x);
    complete = complete && x;
  });
  return complete;
}

/// How many precision points; where there is a list of them, as many as it has. After read_spacing().
bool read_count(const JsonObject& object, NamedFunction& function) {
  const auto found = object.find("points");
  if (!found && function.spacing == PointSpacing::given)
    function.points = static_cast<int>(std::min<std::size_t>(function.given_points.size(), most_positions_looked_at));
  if (!found) return true;
  const auto count = found->as_whole_number();
  function.points = count.value_or(function.points);
  return count.has_value();
}

std::optional<NamedFunction> read_function(const JsonValue& value, Mistakes& mistakes) {
  const JsonObject object(
      value, mistakes,
      {"expression", "table", "interpolation", "x", "y", "input_range_deg", "output_range_deg", "points", "spacing"});
  if (!value.is_object()) return std::nullopt;
  NamedFunction function;
  const std::array complete = {read_what_it_is(object, value, function),
                               read_interpolation(object, function),
                               read_range(object, "x", function.x),
                               read_range(object, "y", function.y),
                               read_dial(object, "input_range_deg", function.input_range),
                               read_dial(object, "output_range_deg", function.output_range),
                               read_spacing(object, function),
                               read_count(object, function)};
  for (const bool part : complete)
    if (!part) return std::nullopt;
  return function;
}

/// Pairs count from 1 in files.
bool read_pair_number(const JsonValue& value, FreeParameter& free) {
  const auto number = value.as_whole_number();
  if (!number) return false;
  if (*number < 1) {
    value.mistake("pair_number", "pairs count from 1");
    return false;
  }
  free.pair = static_cast<std::size_t>(*number) - 1;
  return true;
}

std::optional<FreeParameter> read_free(const JsonValue& value, Mistakes& mistakes) {
  constexpr std::array names = {std::string_view("output_scale"), std::string_view("pair_output")};
  const JsonObject object(value, mistakes, {"number", "pair", "range"});
  const auto written = object.require("number", {"\"number\": \"output_scale\""});
  const auto kind = written ? written->as_one_of(names) : std::nullopt;
  if (!kind) return std::nullopt;
  FreeParameter free;
  free.kind = free_parameter_named(*kind).value_or(free.kind);
  if (free.kind == FreeParameter::Kind::pair_output) {
    const auto pair = object.require("pair", {"pair_number", "which pair it is, counted from 1"});
    const bool ranged = read_dial(object, "range", free.range);
    return pair && read_pair_number(*pair, free) && ranged ? std::optional(free) : std::nullopt;
  }
  std::optional<std::array<double, 2>> range;
  if (const auto pair = object.find("pair"))
    pair->mistake("unneeded_pair", "the output's scale is of all pairs; leave \"pair\" out");
  if (object.find("pair") || !read_range(object, "range", range)) return std::nullopt;
  if (range) free.range = *range;
  return free;
}

/// The pairs themselves, or those of a named function.
bool read_pairs_or_function(const JsonObject& object, const JsonValue& value, Mistakes& mistakes,
                            WantedFunction& wanted) {
  const auto pairs = object.find("pairs"), function = object.find("function");
  if (!pairs && !function) {
    value.mistake(
        "missing_pairs",
        "neither pairs nor a function are given; add \"pairs\": [{\"input_deg\": …, \"output_deg\": …}, …] or "
        "\"function\": {\"expression\": …}");
    return false;
  }
  if (pairs && function) {
    value.mistake("pairs_and_function", "\"pairs\" and \"function\" are two ways to say what is wanted; keep one");
    return false;
  }
  if (pairs) return read_pairs(*pairs, mistakes, wanted.pairs);
  wanted.function = read_function(*function, mistakes);
  if (!wanted.function) return false;
  const std::vector<Error> wrong = mistakes_in(*wanted.function);
  mistakes.add(wrong);
  if (wrong.empty()) wanted.pairs = precision_pairs(*wanted.function);
  return wrong.empty();
}

}  // namespace

bool read_wanted_function(const JsonObject& object, const JsonValue& value, Mistakes& mistakes,
                          WantedFunction& wanted) {
  bool complete = read_pairs_or_function(object, value, mistakes, wanted);
  if (const auto free = object.find("free"); free && !free->is_null()) {
    wanted.free = read_free(*free, mistakes);
    complete = complete && wanted.free;
  }
  return complete;
}

}  // namespace linkwright
