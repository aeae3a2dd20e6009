#include "problem_writer.hpp"

#include "files/fields/field_writer.hpp"
#include "linkwright/files/problem_file.hpp"
#include "problem_fields.hpp"

namespace linkwright {

using Layout = JsonWriter::Layout;

void write_requirements(JsonWriter& json, Requirements requirements, const LinkageClass& asked) {
  write_fields(json, RequirementsOf{requirements, asked});
}

void write_point(JsonWriter& json, Point point) { write_interval(json, point.real(), point.imag()); }

void write_interval(JsonWriter& json, double low, double high) {
  json.begin_list(Layout::one_line);
  json.value(low);
  json.value(high);
  json.end_list();
}

void write_lengths(JsonWriter& json, const LinkLengths& lengths) {
  json.begin_object(Layout::one_line);
  json.member("ground", lengths.ground);
  json.member("input", lengths.input);
  json.member("coupler", lengths.coupler);
  json.member("output", lengths.output);
  json.end_object();
}

void write_defects(JsonWriter& json, Defects defects) {
  json.begin_object(Layout::one_line);
  json.member("order", defects.order());
  json.member("branch", defects.branch());
  json.member("circuit", defects.circuit());
  json.end_object();
}

void write_pivots(JsonWriter& json, const FourBar& four_bar) {
  json.begin_object();
  json.key("input_center");
  write_point(json, four_bar.input_center);
  json.key("input_circle");
  write_point(json, four_bar.input_circle);
  json.key("output_center");
  write_point(json, four_bar.output_center);
  json.key("output_circle");
  write_point(json, four_bar.output_circle);
  json.end_object();
}

void write_pivots(JsonWriter& json, const TracingFourBar& linkage) {
  json.begin_object();
  const auto pivot = [&](std::string_view key, Point at) {
    json.key(key);
    write_point(json, at);
  };
  pivot("input_fixed", linkage.bars.input_center);
  pivot("input_moving", linkage.bars.input_circle);
  pivot("output_moving", linkage.bars.output_circle);
  pivot("output_fixed", linkage.bars.output_center);
  pivot("point", linkage.point);
  json.end_object();
}

std::string write_problem(const Problem& problem) {
  return json_text_of([&](JsonWriter& json) { write_fields(json, problem); });
}

}  // namespace linkwright
