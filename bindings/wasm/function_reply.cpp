#include "function_reply.hpp"

#include <array>
#include <optional>

#include "linkwright/core/angle.hpp"
#include "reply_json.hpp"

namespace linkwright::wasm {
namespace {

using Layout = JsonWriter::Layout;

constexpr int steps_of_a_curve = 90;

void write_angle(JsonWriter& json, std::optional<double> angle) { angle ? json.value(degrees(*angle)) : json.null(); }

}  // namespace

void write_wanted_function(JsonWriter& json, const WantedFunction& wanted) {
  json.begin_object();
  json.key("pairs");
  json.begin_list(Layout::one_line);
  for (const AnglePair& pair : wanted.pairs) write_numbers(json, std::array{degrees(pair.input), degrees(pair.output)});
  json.end_list();
  json.key("curve");
  json.begin_list(Layout::one_line);
  if (wanted.function) {
    const ScaledFunction scaled(*wanted.function);
    const auto [from, to] = scaled.input_range();
    for (int i = 0; i <= steps_of_a_curve; ++i) {
      const double input = from + (to - from) * i / steps_of_a_curve;
      write_numbers(json, std::array{degrees(input), degrees(scaled.output_at(input))});
    }
  }
  json.end_list();
  json.end_object();
}

void write_generated_function(JsonWriter& json, const WantedFunction& wanted, const FunctionError& error) {
  json.begin_object();
  json.key("pairs");
  json.begin_list();
  for (std::size_t j = 0; j < wanted.pairs.size(); ++j) {
    json.begin_list(Layout::one_line);
    write_angle(json, wanted.pairs[j].input);
    write_angle(json, wanted.pairs[j].output);
    write_angle(json, error.at_pairs[j]);
    json.end_list();
  }
  json.end_list();
  json.member("precision_error_deg", degrees(error.precision_error));
  json.member("reaches_pairs", error.reaches_pairs);
  json.key("max_structural_error_deg");
  write_angle(json, error.max_structural_error);
  json.key("worst_input_deg");
  write_angle(json, error.max_structural_error ? std::optional(error.worst_input) : std::nullopt);
  json.key("unreached_deg");
  json.begin_list(Layout::one_line);
  for (const AngleRange& gap : error.unreached) write_numbers(json, std::array{degrees(gap.from), degrees(gap.to)});
  json.end_list();
  json.key("curve");
  json.begin_list(Layout::one_line);
  for (const ErrorSample& sample : error.samples) {
    json.begin_list(Layout::one_line);
    write_angle(json, sample.input);
    write_angle(json, sample.wanted);
    write_angle(json, sample.generated);
    json.end_list();
  }
  json.end_list();
  json.end_object();
}

}  // namespace linkwright::wasm
