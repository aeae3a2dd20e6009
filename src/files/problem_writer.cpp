#include "problem_writer.hpp"

#include <cmath>
#include <fmt/format.h>

#include "files/attitude/space_writer.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/number_text.hpp"
#include "tolerance_writer.hpp"

namespace linkwright {
namespace {

using Layout = JsonWriter::Layout;

void write_box(JsonWriter& json, std::string_view key, const std::optional<Box>& box) {
  json.key(key);
  box ? linkwright::write_box(json, *box) : json.null();
}

void write_cone(JsonWriter& json, std::string_view key, const std::optional<Cone>& cone) {
  json.key(key);
  cone ? linkwright::write_cone(json, *cone) : json.null();
}

void write_types(JsonWriter& json, const std::vector<LinkageType>& types) {
  json.key("types");
  json.begin_list(Layout::one_line);
  for (const LinkageType type : types) json.value(name(type));
  json.end_list();
}

// An angle that is not limited is null.
void write_angle(JsonWriter& json, std::string_view key, std::optional<double> angle) {
  json.key(key);
  angle ? json.value(degrees_for_files(*angle)) : json.null();
}

void write_requirement(JsonWriter& json, const Requirements& wanted, RequirementKind kind) {
  switch (kind) {
    case RequirementKind::types:
      return write_types(json, wanted.types);
    case RequirementKind::no_defects:
      return json.member(key(kind), wanted.no_defects);
    case RequirementKind::min_transmission_angle:
      return write_angle(json, key(kind), wanted.min_transmission_angle);
    case RequirementKind::max_link_ratio:
      return json.member(key(kind), wanted.max_link_ratio);  // unlimited: null
    case RequirementKind::max_length:
      return wanted.max_length ? json.member(key(kind), *wanted.max_length) : void();
    case RequirementKind::min_length:
      return wanted.min_length ? json.member(key(kind), *wanted.min_length) : void();
    case RequirementKind::ground_pivots_within:
      return write_box(json, key(kind), wanted.ground_pivots_within);
    case RequirementKind::moving_pivots_within:
      return write_box(json, key(kind), wanted.moving_pivots_within);
    case RequirementKind::min_link_angle:  // nothing: the default, which only an answer knows
      if (!wanted.min_link_angle) return;
      return write_angle(json, key(kind), *wanted.min_link_angle > 0 ? wanted.min_link_angle : std::nullopt);
    case RequirementKind::max_link_angle:
      return write_angle(json, key(kind), wanted.max_link_angle);
    case RequirementKind::fixed_axes_within:
      return write_cone(json, key(kind), wanted.fixed_axes_within);
    case RequirementKind::moving_axes_within:
      return write_cone(json, key(kind), wanted.moving_axes_within);
    case RequirementKind::min_stroke:
      return json.member(key(kind), wanted.min_stroke);
    case RequirementKind::max_deviation:
      return json.member(key(kind), wanted.max_deviation);  // unlimited: null
    // Of tolerances nothing is said where there are none.
    case RequirementKind::max_tolerance_error:
      return std::isfinite(wanted.max_tolerance_error) ? json.member(key(kind), wanted.max_tolerance_error) : void();
    case RequirementKind::min_yield:
      return wanted.min_yield > 0 ? json.member(key(kind), wanted.min_yield) : void();
  }
}

void write_measuring(JsonWriter& json, const LineMeasuring& line) {
  const auto length = [&](std::string_view key, std::optional<double> value) {
    json.key(key);
    value ? json.value(*value) : json.null();
  };
  length("deviation", line.deviation);
  length("stroke", line.stroke);
  json.member("measure", name(line.measure));
}

void write_options(JsonWriter& json, const SynthesisOptions& options, bool of_line) {
  json.begin_object();
  json.member("region_samples", options.region_samples);
  json.member("spacing", name(options.spacing));
  json.member("objective", name(options.objective));
  if (options.pareto) {
    json.key("pareto");
    json.begin_list(Layout::one_line);
    for (const Objective objective : *options.pareto) json.value(name(objective));
    json.end_list();
  }
  json.member("best", options.best);
  if (of_line) write_measuring(json, options.line);
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
  if (options.at) {
    json.key("at");
    write_interval(json, options.at->input, options.at->output);
  }
  json.end_object();
}

/// The outline, and what else the workbench keeps.
std::string view_text(const Problem& problem) {
  if (problem.outline.empty()) return problem.view;
  std::string text = R"({"outline": [)";
  for (const Point& p : problem.outline)
    text +=
        fmt::format("{}[{}, {}]", &p == problem.outline.data() ? "" : ", ", exact_text(p.real()), exact_text(p.imag()));
  const std::string_view rest = problem.view;
  return text + (rest.size() > 2 ? fmt::format("], {}", rest.substr(1)) : "]}");
}

}  // namespace

void write_requirements(JsonWriter& json, const Requirements& requirements, const LinkageClass& asked) {
  json.begin_object();
  for (const RequirementKind kind : asked.requirements) write_requirement(json, requirements, kind);
  json.member("respect_direction", requirements.respect_direction);
  json.end_object();
}

void write_cone(JsonWriter& json, const Cone& cone) {
  json.begin_object(Layout::one_line);
  write_vector(json, "axis", cone.axis);
  json.member("half_angle_deg", degrees_for_files(cone.half_angle));
  json.end_object();
}

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

void write_problem(JsonWriter& json, const Problem& problem) {
  json.begin_object();
  json.member("linkwright", file_version);
  json.member("title", problem.title);
  json.member("length_unit", problem.length_unit);
  json.key("task");
  write_task(json, problem.task);
  json.key("requirements");
  write_requirements(json, problem.requirements, linkages(problem.task));
  if (problem.options.tolerances) {
    json.key("tolerances");
    write_tolerances(json, *problem.options.tolerances);
  }
  json.key("options");
  write_options(json, problem.options, std::holds_alternative<StraightLineTask>(problem.task));
  if (!problem.view.empty() || !problem.outline.empty()) {
    json.key("view");
    json.json(view_text(problem));
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
