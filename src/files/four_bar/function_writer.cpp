#include "files/four_bar/four_bar_kind.hpp"
#include "files/task_writer.hpp"
#include "linkwright/files/number_text.hpp"

namespace linkwright {
namespace {

void write_pair(JsonWriter& json, const AnglePair& pair) {
  json.begin_object(JsonWriter::Layout::one_line);
  json.member("input_deg", degrees_for_files(pair.input));
  json.member("output_deg", degrees_for_files(pair.output));
  if (!pair.derivatives.empty()) {
    json.key("derivatives");
    json.begin_list(JsonWriter::Layout::one_line);
    for (const AngleDerivative& derivative : pair.derivatives) {
      json.begin_object(JsonWriter::Layout::one_line);
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
  json.begin_list(JsonWriter::Layout::one_line);
  for (const double x : function.given_points) json.value(x);
  json.end_list();
}

void write_function(JsonWriter& json, const NamedFunction& function) {
  json.begin_object();
  if (function.table.empty()) {
    json.member("expression", std::string_view(function.expression));
  } else {
    json.key("table");
    json.begin_list(JsonWriter::Layout::one_line);
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
  json.begin_object(JsonWriter::Layout::one_line);
  json.member("number", name(free.kind));
  if (free.kind != FreeParameter::Kind::output_scale) json.member("pair", static_cast<int>(free.pair) + 1);
  free.kind == FreeParameter::Kind::pair_output ? write_dial(json, "range", free.range)
                                                : write_range(json, "range", free.range);
  json.end_object();
}

}  // namespace

void write_of_kind(JsonWriter& json, const FunctionTask& task) {
  json.member("kind", "function");
  json.member("mechanism", "four_bar");
  if (task.function) {
    json.key("function");
    write_function(json, *task.function);
  } else {
    json.key("pairs");
    json.begin_list();
    for (const AnglePair& pair : task.pairs) write_pair(json, pair);
    json.end_list();
  }
  json.key("ground_pivots");
  json.begin_object(JsonWriter::Layout::one_line);
  json.key("input");
  write_point(json, task.input_pivot);
  json.key("output");
  write_point(json, task.output_pivot);
  json.end_object();
  if (!task.free) return;
  json.key("free");
  write_free(json, *task.free);
}

}  // namespace linkwright
