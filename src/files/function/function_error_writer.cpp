#include "files/function/function_error_writer.hpp"

#include "files/problem_writer.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/number_text.hpp"

namespace linkwright {
namespace {

using Layout = JsonWriter::Layout;

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
