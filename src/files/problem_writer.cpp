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

std::string write_problem(const Problem& problem) {
  return json_text_of([&](JsonWriter& json) { write_fields(json, problem); });
}

}  // namespace linkwright
