#include "files/function/wanted_function_writer.hpp"

#include "files/task_writer.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/number_text.hpp"

namespace linkwright {
namespace {

using Layout = JsonWriter::Layout;

void write_pair(JsonWriter& json, const AnglePair& pair) {
  json.begin_object(Layout::one_line);
  json.member("input_deg", degrees_for_files(pair.input));
  json.member("output_deg", degrees_for_files(pair.output));
  if (!pair.derivatives.empty()) {
    json.key("derivatives");
    json.begin_list(Layout::one_line);
    for (const AngleDerivative& derivative : pair.derivatives) {
      json.begin_object(Layout::one_line);
      json.member("input", derivative.input);
      json.member("output", derivative.output);
      json.end_object();
    }
    json.end_list();
  }
  json.end_object();
}

void write_range(JsonWriter& json, std::string_view key, const std::array<double, 2>& range) {
  json.key(key);
  write_interval(json, range[0], range[1]);
}

void write_dial(JsonWriter& json, std::string_view key, const std::array<double, 2>& range) {
  write_range(json, key, {degrees_for_files(range[0]), degrees_for_files(range[1])});
}

void write_spacing(JsonWriter& json, const NamedFunction& function) {
  json.key("spacing");
  if (function.spacing != PointSpacing::given) return json.value(name(function.spacing));
  json.begin_list(Layout::one_line);
  for (const double x : function.given_points) json.value(x);
  json.end_list();
}

void write_function(JsonWriter& json, const NamedFunction& function) {
  json.begin_object();
  if (function.table.empty()) {
    json.member("expression", std::string_view(function.expression));
  } else {
    json.key("table");
    json.begin_list(Layout::one_line);
    for (const auto& [x, y] : function.table) write_interval(json, x, y);
    json.end_list();
    json.member("interpolation", name(function.interpolation));
  }
  if (function.x) write_range(json, "x", *function.x);
  if (function.y) write_range(json, "y", *function.y);
  write_dial(json, "input_range_deg", function.input_range);
  write_dial(json, "output_range_deg", function.output_range);
  json.member("points", function.points);
  write_spacing(json, function);
  json.end_object();
}

void write_free(JsonWriter& json, const FreeParameter& free) {
  json.begin_object(Layout::one_line);
  json.member("number", name(free.kind));
  if (free.kind != FreeParameter::Kind::output_scale) json.member("pair", static_cast<int>(free.pair) + 1);
  free.kind == FreeParameter::Kind::pair_output ? write_dial(json, "range", free.range)
                                                : write_range(json, "range", free.range);
  json.end_object();
}

void write_degrees_or_null(JsonWriter& json, std::optional<double> radians) {
  radians ? json.value(degrees(*radians)) : json.null();
}

/// For a plot: columns by rising input.
void write_error_curve(JsonWriter& json, const std::vector<ErrorSample>& samples) {
  json.begin_object();
  const auto column = [&](std::string_view key, auto&& value_of) {
    json.key(key);
    json.begin_list(Layout::one_line);
    for (const ErrorSample& sample : samples) write_degrees_or_null(json, value_of(sample));
    json.end_list();
  };
  column("input_deg", [](const ErrorSample& sample) { return std::optional(sample.input); });
  column("wanted_output_deg", [](const ErrorSample& sample) { return std::optional(sample.wanted); });
  column("error_deg", [](const ErrorSample& sample) {
    return sample.generated ? std::optional(*sample.generated - sample.wanted) : std::nullopt;
  });
  json.end_object();
}

}  // namespace

void write_pairs_or_function(JsonWriter& json, const WantedFunction& wanted) {
  if (wanted.function) {
    json.key("function");
    write_function(json, *wanted.function);
  } else {
    json.key("pairs");
    json.begin_list();
    for (const AnglePair& pair : wanted.pairs) write_pair(json, pair);
    json.end_list();
  }
}

void write_free_parameter(JsonWriter& json, const WantedFunction& wanted) {
  if (!wanted.free) return;
  json.key("free");
  write_free(json, *wanted.free);
}

void write_function_error(JsonWriter& json, const FunctionError& error) {
  json.member("precision_error_deg", degrees(error.precision_error));
  json.key("errors_at_pairs_deg");
  json.begin_list(Layout::one_line);
  for (const auto& at_pair : error.at_pairs) write_degrees_or_null(json, at_pair);
  json.end_list();
  json.key("max_structural_error_deg");
  write_degrees_or_null(json, error.max_structural_error);
  if (error.max_structural_error) json.member("worst_input_deg", degrees(error.worst_input));
  json.key("unreached_deg");
  json.begin_list(Layout::one_line);
  for (const AngleRange& gap : error.unreached) write_interval(json, degrees(gap.from), degrees(gap.to));
  json.end_list();
  if (error.samples.empty()) return;
  json.key("error_curve");
  write_error_curve(json, error.samples);
}

}  // namespace linkwright
