#include "result_writer.hpp"

#include <array>
#include <cmath>
#include <span>

#include "json_writer.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/io/number_text.hpp"
#include "linkwright/io/result_file.hpp"
#include "problem_writer.hpp"
#include "region_arrays.hpp"

namespace linkwright {
namespace {

using Layout = JsonWriter::Layout;

void write_homogeneous(JsonWriter& json, Homogeneous point) {
  json.begin_list(Layout::one_line);
  json.value(point.w);
  json.value(point.x);
  json.value(point.y);
  json.end_list();
}

/// The finite point, or null where it is at infinity by the measure of the working frame.
void write_point_or_null(JsonWriter& json, Homogeneous point, const WorkingFrame& frame) {
  if (is_at_infinity(frame.to_working(point))) return json.null();
  write_point(json, Point{point.x / point.w, point.y / point.w});
}

void write_dyad(JsonWriter& json, const Dyad& dyad, double residual, const WorkingFrame& frame) {
  json.begin_object();
  json.key("center_point");
  write_point_or_null(json, dyad.center, frame);
  json.key("circle_point");
  write_point_or_null(json, dyad.circle, frame);
  json.member("coordinate", dyad.coordinate);
  json.key("center_homogeneous");
  write_homogeneous(json, dyad.center);
  json.key("circle_homogeneous");
  write_homogeneous(json, dyad.circle);
  json.member("residual", residual);
  json.end_object();
}

void write_defects(JsonWriter& json, Defects defects) {
  json.begin_object(Layout::one_line);
  json.member("order", defects.order());
  json.member("branch", defects.branch());
  json.member("circuit", defects.circuit());
  json.end_object();
}

double transmission_angle_deg(double worst_cosine) { return degrees(std::acos(std::min(std::abs(worst_cosine), 1.0))); }

/// Over the task; null where a defect leaves it undefined.
void write_task_transmission(JsonWriter& json, const DefectReport& report) {
  json.key("min_transmission_angle_deg");
  if (!report.defects.none()) return json.null();
  json.value(transmission_angle_deg(report.worst_transmission_cosine));
}

void write_swapped(JsonWriter& json, const DefectReport& report) {
  json.begin_object();
  json.member("type", name(report.type));
  json.key("defects");
  write_defects(json, report.defects);
  write_task_transmission(json, report);
  json.end_object();
}

void write_drive(JsonWriter& json, const DefectReport& report) {
  json.key("drive");
  report.sense == DriveSense::none ? json.null() : json.value(name(report.sense));
  json.key("driver_sweep_deg");
  report.defects.none() ? json.value(degrees(report.sweep)) : json.null();
}

void write_four_bar(JsonWriter& json, const FourBarSolution& found, const WorkingFrame& frame) {
  json.begin_object();
  json.member("mechanism", "four_bar");
  json.key("input");
  write_dyad(json, found.input, found.input_residual, frame);
  json.key("output");
  write_dyad(json, found.output, found.output_residual, frame);
  json.key("lengths");
  write_lengths(json, found.lengths);
  json.member("link_ratio", found.lengths.longest() / found.lengths.shortest());
  json.member("type", name(found.report.type));
  json.key("defects");
  write_defects(json, found.report.defects);
  write_drive(json, found.report);
  write_task_transmission(json, found.report);
  json.key("min_transmission_angle_full_turn_deg");
  input_is_crank(found.report.type)
      ? json.value(transmission_angle_deg(found.report.worst_transmission_cosine_full_turn))
      : json.null();
  json.member("residual", found.residual);
  if (found.residual_derivatives) json.member("residual_derivatives", *found.residual_derivatives);
  json.member("local_optimum", found.local_optimum);
  json.member("verified_by_driving", found.verified_by_driving);
  json.key("swapped");
  write_swapped(json, found.swapped);
  json.end_object();
}

void write_warnings(JsonWriter& json, const std::vector<Notice>& warnings) {
  json.begin_list();
  for (const Notice& warning : warnings) {
    json.begin_object(Layout::one_line);
    json.member("code", std::string_view(warning.code));
    json.member("message", std::string_view(warning.message));
    json.end_object();
  }
  json.end_list();
}

void write_numbers(JsonWriter& json, std::string_view key, std::span<const double> numbers) {
  json.key(key);
  json.begin_list(Layout::one_line);
  for (const double number : numbers) json.value(number);
  json.end_list();
}

void write_coordinates(JsonWriter& json, std::string_view key, std::span<const Dyad> dyads) {
  json.key(key);
  json.begin_list(Layout::one_line);
  for (const Dyad& dyad : dyads) json.value(dyad.coordinate);
  json.end_list();
}

void write_points(JsonWriter& json, std::string_view key, std::span<const Dyad> dyads, Homogeneous Dyad::*point) {
  json.key(key);
  json.begin_list(Layout::one_line);
  for (const Dyad& dyad : dyads) write_homogeneous(json, dyad.*point);
  json.end_list();
}

void write_curve(JsonWriter& json, const Solution& solution) {
  const BurmesterCurve* curve = solution.given.curve.get();
  json.begin_object();
  json.member("kind", name(curve ? curve->kind() : CubicKind::every_point));
  json.member("center_kind", name(curve ? curve->center_kind() : CubicKind::every_point));
  const auto kappa = curve ? curve->kappa() : std::nullopt;
  json.key("kappa");
  kappa ? json.value(*kappa) : json.null();
  json.key("branches");
  write_branches(json, curve ? curve->branches() : std::vector<CurveBranch>{});
  json.key("samples");
  json.begin_object();
  write_coordinates(json, "coordinate", solution.samples);
  write_points(json, "center_homogeneous", solution.samples, &Dyad::center);
  write_points(json, "circle_homogeneous", solution.samples, &Dyad::circle);
  json.end_object();
  json.end_object();
}

void write_counts(JsonWriter& json, const RegionCounts& counts) {
  json.begin_object();
  for (std::size_t type = 0; type < counts.types.size(); ++type)
    json.member(linkage_type_names[type], counts.types[type]);
  json.member("order", counts.order);
  json.member("branch", counts.branch);
  json.member("circuit", counts.circuit);
  json.member("defect_free", counts.defect_free);
  json.member("pairs", counts.pairs);
  json.end_object();
}

void write_axes(JsonWriter& json) {
  json.begin_list();
  for (const std::string_view axis : {"input side link, place on its curve", "output side link, place on its curve"}) {
    json.begin_object(Layout::one_line);
    json.member("name", axis);
    json.member("unit", "tau");
    json.end_object();
  }
  json.end_list();
}

void write_region(JsonWriter& json, const Solution& solution, bool with_arrays) {
  const RegionMap& region = solution.region;
  json.begin_object();
  json.member("samples", static_cast<std::int64_t>(region.rows()));
  write_numbers(json, "input_coordinate", region.input_coordinates());
  write_numbers(json, "output_coordinate", region.output_coordinates());
  json.key("axes");
  write_axes(json);
  json.key("counts");
  write_counts(json, solution.counts);
  json.member("meeting_requirements", solution.meeting_requirements);
  if (with_arrays) write_region_arrays(json, region);
  json.end_object();
}

void write_relaxations(JsonWriter& json, const std::vector<Relaxation>& relaxations) {
  json.begin_list();
  for (const Relaxation& relaxation : relaxations) {
    json.begin_object(Layout::one_line);
    const bool is_angle = relaxation.requirement == RequirementKind::min_transmission_angle;
    json.member("requirement", key(relaxation.requirement));
    json.member("only_this", relaxation.only_this);
    json.key("value");  // as the problem file wants it
    relaxation.value ? json.value(is_angle ? degrees_for_files(*relaxation.value) : *relaxation.value) : json.null();
    json.member("leaves", relaxation.leaves);
    json.end_object();
  }
  json.end_list();
}

Problem as_solved(const Problem& problem, const Solution& solution) {
  Problem used = problem;
  used.requirements = solution.requirements;
  used.options = solution.options;
  return used;
}

void write_answer(JsonWriter& json, const Solution& solution, bool with_region) {
  json.member("status", name(solution.status));
  json.member("reason", std::string_view(solution.reason.message));
  json.member("pattern", std::string_view(solution.given.pattern));
  json.member("condition", solution.given.conditions.condition());
  json.member("characteristic_length", solution.given.frame().scale);
  json.key("warnings");
  write_warnings(json, solution.given.warnings);
  json.key("curve");
  write_curve(json, solution);
  json.key("dyads");
  json.begin_list();  // five positions only
  json.end_list();
  json.key("region");
  write_region(json, solution, with_region);
  json.key("linkages");
  json.begin_list();
  for (const FourBarSolution& found : solution.linkages) write_four_bar(json, found, solution.given.frame());
  json.end_list();
  json.key("relax");
  write_relaxations(json, solution.relax);
}

}  // namespace

void write_branches(JsonWriter& json, const std::vector<CurveBranch>& branches) {
  json.begin_list();
  for (const CurveBranch& branch : branches) {
    json.begin_object(Layout::one_line);
    json.member("name", std::string_view(branch.name));
    json.member("from", branch.from);
    json.member("to", branch.to);
    json.end_object();
  }
  json.end_list();
}

void write_result(const TextSink& sink, const Problem& problem, const Solution& solution, bool with_region) {
  JsonWriter json(sink);
  json.begin_object();
  json.member("linkwright", file_version);
  json.key("problem");
  write_problem(json, as_solved(problem, solution));
  write_answer(json, solution, with_region);
  json.end_object();
}

std::string write_result(const Problem& problem, const Solution& solution, bool with_region) {
  std::string text;
  write_result([&text](std::string_view piece) { text += piece; }, problem, solution, with_region);
  return text;
}

}  // namespace linkwright
