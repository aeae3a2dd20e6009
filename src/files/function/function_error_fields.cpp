#include "files/function/function_error_fields.hpp"

#include "files/fields/result_forms.hpp"

namespace linkwright {
namespace {

using Column = std::vector<std::optional<double>>;

template <class ValueOf>
Column column_deg(const std::vector<ErrorSample>& samples, const ValueOf& value_of) {
  Column column;
  for (const ErrorSample& sample : samples) column.push_back(forms::degrees_of(value_of(sample)));
  return column;
}

/// For a plot.
void visit_error_curve(FieldVisitor& v, const std::vector<ErrorSample>& samples) {
  const auto at = [&](double ErrorSample::*which) {
    std::vector<double> column;
    for (const ErrorSample& sample : samples) column.push_back(degrees(sample.*which));
    return column;
  };
  const auto error = [](const ErrorSample& sample) {
    return sample.generated ? std::optional(*sample.generated - sample.wanted) : std::nullopt;
  };
  v.object({.name = "error_curve", .on_lines = true}, [&](FieldVisitor& to) {
    to.shown("input_deg", at(&ErrorSample::input), forms::numbers, Number{});
    to.shown("wanted_output_deg", at(&ErrorSample::wanted), forms::numbers, Number{});
    to.shown(Field("error_deg", "Generated less wanted output; null where the drive does not get there."),
             column_deg(samples, error), forms::on_a_line, Number{});
  });
}

std::vector<std::array<double, 2>> intervals_deg(const std::vector<AngleRange>& ranges) {
  std::vector<std::array<double, 2>> intervals;
  for (const AngleRange& range : ranges) intervals.push_back({degrees(range.from), degrees(range.to)});
  return intervals;
}

Column degrees_of_each(const std::vector<std::optional<double>>& radians) {
  Column column;
  for (const auto& each : radians) column.push_back(forms::degrees_of(each));
  return column;
}

void max_error_fields(FieldVisitor& v, const FunctionError& error, bool is) {
  const Field field("max_structural_error_deg",
                    "Named functions: largest magnitude over the range of inputs that is reached; null where only "
                    "pairs are given or nothing is reached.");
  std::optional<double> largest = forms::degrees_of(error.max_structural_error);
  v.optional(field.null_for_none().written(is), largest, forms::not_negative);
  v.shown_if_any(Field("worst_input_deg", "Where that is."),
                 forms::where(error.max_structural_error.has_value(), degrees(error.worst_input)), Number{});
}

}  // namespace

void function_error_fields(FieldVisitor& v, const std::optional<FunctionError>& of) {
  const FunctionError none;
  const FunctionError& error = of ? *of : none;
  const bool is = of.has_value();
  v.shown_if_any(Field("precision_error_deg", "Functions: largest error of the output at the pairs that are reached."),
                 forms::where(is, degrees(error.precision_error)), forms::not_negative);
  v.shown_if_any(
      Field("errors_at_pairs_deg",
            "Functions: generated less wanted output at each pair; null where the drive does not get there."),
      forms::where(is, degrees_of_each(error.at_pairs)), forms::on_a_line, Number{});
  max_error_fields(v, error, is);
  v.shown_if_any(
      Field("unreached_deg", "Named functions: parts [from, to] of the range of inputs where the drive does not get."),
      forms::where(is, intervals_deg(error.unreached)), forms::on_a_line, forms::two_numbers);
  v.member(Field("error_curve", "Named functions: columns by rising input.").written(!error.samples.empty()), false,
           [&](FieldVisitor& to) { visit_error_curve(to, error.samples); });
}

}  // namespace linkwright
