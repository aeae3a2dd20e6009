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

void write_types(JsonWriter& json, const std::vector<LinkageType>& types) {
  json.key("types");
  json.begin_list(Layout::one_line);
  for (const LinkageType type : types) json.value(name(type));
  json.end_list();
}

// What is not limited is null; an angle that is always given is a number all the same.
void write_number(JsonWriter& json, const Criterion& asked, const Requirements& wanted) {
  if (asked.is_of_tolerances && !asked.has_limit(wanted)) return;
  const auto* open = std::get_if<std::optional<double> Requirements::*>(&asked.asked);
  if (open && asked.has_default && !(wanted.**open)) return;  // only an answer knows it
  const double limit = asked.limit(wanted);
  if (!asked.is_angle()) return json.member(asked.key, limit);
  json.key(asked.key);
  const bool is_free = open != nullptr && limit == asked.any;
  is_free ? json.null() : json.value(degrees_for_files(limit));
}

void write_criterion(JsonWriter& json, const Criterion& asked, const Requirements& wanted) {
  if (asked.is_number()) return write_number(json, asked, wanted);
  if (asked.rule == Criterion::Rule::one_of_types) return write_types(json, wanted.types);
  if (asked.rule == Criterion::Rule::without_defects) return json.member(asked.key, wanted.no_defects);
  json.key(asked.key);
  const auto window = asked.window(wanted);
  if (!window) return json.null();
  if (const auto* box = std::get_if<Box>(&*window)) return linkwright::write_box(json, *box);
  linkwright::write_cone(json, std::get<Cone>(*window));
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
  for (const RequirementKind kind : asked.requirements) write_criterion(json, criterion(kind), requirements);
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
  write_options(json, problem.options, output_kind(problem.task) == OutputKind::line);
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
