#include "problem_writer.hpp"

#include "linkwright/core/angle.hpp"
#include "linkwright/files/number_text.hpp"

namespace linkwright {
namespace {

using Layout = JsonWriter::Layout;

void write_box(JsonWriter& json, std::string_view key, const std::optional<Box>& box) {
  json.key(key);
  box ? linkwright::write_box(json, *box) : json.null();
}

void write_requirements(JsonWriter& json, const Requirements& requirements) {
  json.begin_object();
  json.key("types");
  json.begin_list(Layout::one_line);
  for (const LinkageType type : requirements.types) json.value(name(type));
  json.end_list();
  json.member("no_defects", requirements.no_defects);
  json.member("min_transmission_angle_deg", degrees_for_files(requirements.min_transmission_angle));
  json.member("max_link_ratio", requirements.max_link_ratio);  // unlimited: null
  if (requirements.max_length) json.member("max_length", *requirements.max_length);
  if (requirements.min_length) json.member("min_length", *requirements.min_length);
  write_box(json, "ground_pivots_within", requirements.ground_pivots_within);
  write_box(json, "moving_pivots_within", requirements.moving_pivots_within);
  json.member("respect_direction", requirements.respect_direction);
  json.end_object();
}

void write_options(JsonWriter& json, const SynthesisOptions& options) {
  json.begin_object();
  json.member("region_samples", options.region_samples);
  json.member("spacing", name(options.spacing));
  json.member("objective", name(options.objective));
  json.member("best", options.best);
  if (options.box) write_box(json, "box", options.box);
  if (options.seed != SynthesisOptions{}.seed) json.member("seed", options.seed);
  if (options.effort != SynthesisOptions{}.effort) json.member("effort", options.effort);
  if (options.window) {
    json.key("window");
    json.begin_list(Layout::one_line);
    write_interval(json, options.window->input[0], options.window->input[1]);
    write_interval(json, options.window->output[0], options.window->output[1]);
    json.end_list();
  }
  json.end_object();
}

}  // namespace

void write_box(JsonWriter& json, const Box& box) {
  json.begin_object(Layout::one_line);
  json.key("x");
  write_interval(json, box.x_low, box.x_high);
  json.key("y");
  write_interval(json, box.y_low, box.y_high);
  json.end_object();
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

void write_problem(JsonWriter& json, const Problem& problem) {
  json.begin_object();
  json.member("linkwright", file_version);
  json.member("title", problem.title);
  json.member("length_unit", problem.length_unit);
  json.key("task");
  write_task(json, problem.task);
  json.key("requirements");
  write_requirements(json, problem.requirements);
  json.key("options");
  write_options(json, problem.options);
  if (!problem.view.empty()) {
    json.key("view");
    json.json(problem.view);
  }
  json.end_object();
}

std::string write_problem(const Problem& problem) {
  std::string text;
  {
    JsonWriter json([&text](std::string_view piece) { text += piece; });
    write_problem(json, problem);
  }
  return text;
}

}  // namespace linkwright
