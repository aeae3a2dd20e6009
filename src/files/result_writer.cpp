#include "result_writer.hpp"

#include <array>
#include <cmath>
#include <span>

#include "axis_label.hpp"
#include "files/four_bar/four_bar_writer.hpp"
#include "files/json/json_writer.hpp"
#include "files/six_bar/six_bar_writer.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/number_text.hpp"
#include "linkwright/files/result_file.hpp"
#include "problem_writer.hpp"
#include "region_arrays.hpp"

namespace linkwright {
namespace {

using Layout = JsonWriter::Layout;

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

/// The side links that a task allows form a curve, if only one that has grown to everything.
bool asks_for_a_curve(const Task& task) {
  if (const auto* motion = std::get_if<MotionTask>(&task)) {
    return motion->freed || position_count(motion->poses) == 4 ||
           (motion->given && std::holds_alternative<InstantCenter>(*motion->given));
  }
  const auto* function = std::get_if<FunctionTask>(&task);
  return function != nullptr && position_count(function->pairs) == 4;
}

void write_curve(JsonWriter& json, const Task& task, const Solution& solution) {
  const BurmesterCurve* curve = solution.given.curve.get();
  if (curve == nullptr && !asks_for_a_curve(task)) return json.null();
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

void write_burmester_points(JsonWriter& json, const TaskFamily& given) {
  json.begin_list();
  for (const BurmesterPoint& point : given.points) {
    json.begin_object();
    write_dyad_members(json, given.frame().to_user(point.dyad), point.residual, given.frame());
    json.member("multiplicity", point.multiplicity);
    json.member("condition", point.condition);
    json.end_object();
  }
  json.end_list();
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

void write_axis(JsonWriter& json, const Problem& problem, const Solution& solution, Side side) {
  if (const auto* six_bar = std::get_if<SixBarTask>(&problem.task))
    return write_six_bar_axis(json, *six_bar, solution.chain.get(), side);
  const FourBarFamily* family = solution.given.family.get();
  const MapAxis axis = family ? family->axis(side) : MapAxis{};
  const AxisLabel label = axis_label(axis, side, problem.task, problem.length_unit);
  json.begin_object();
  json.member("name", std::string_view(label.name));
  json.member("quantity", name(axis.quantity));
  json.member("unit", std::string_view(label.unit));
  json.key("branches");
  write_branches(json, axis.branches);
  if (family && has_values(axis.quantity)) {
    const RegionMap& region = solution.region;
    json.key("values");
    json.begin_list(Layout::one_line);
    for (const double tau : side == Side::input ? region.input_coordinates() : region.output_coordinates())
      json.value(family->axis_value(side, tau));
    json.end_list();
  }
  json.end_object();
}

void write_region(JsonWriter& json, const Problem& problem, const Solution& solution, bool with_arrays) {
  if (solution.search) return json.null();
  const RegionMap& region = solution.region;
  json.begin_object();
  json.member("samples", static_cast<std::int64_t>(region.rows()));
  write_numbers(json, "input_coordinate", region.input_coordinates());
  write_numbers(json, "output_coordinate", region.output_coordinates());
  json.key("axes");
  json.begin_list();
  for (const auto side : {Side::input, Side::output}) write_axis(json, problem, solution, side);
  json.end_list();
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
    json.member("requirement", key(relaxation.requirement));
    json.member("only_this", relaxation.only_this);
    write_relaxed_value(json, relaxation);
    json.member("leaves", relaxation.leaves);
    json.end_object();
  }
  json.end_list();
}

void write_four_bars(JsonWriter& json, const std::vector<FourBarSolution>& list, const TaskFamily& given) {
  json.begin_list();
  for (const FourBarSolution& found : list) write_four_bar(json, found, given.frame(), notes_on(found, given));
  json.end_list();
}

void write_linkages(JsonWriter& json, const Problem& problem, const Solution& solution) {
  if (!std::holds_alternative<SixBarTask>(problem.task))
    return write_four_bars(json, solution.linkages, solution.given);
  json.begin_list();
  for (const SixBarSolution& found : solution.six_bars) write_six_bar(json, found);
  json.end_list();
}

void write_way_out(JsonWriter& json, const FreedPosition& way_out, const MotionTask& task, const WorkingFrame& frame) {
  json.begin_object();
  json.member("pose", static_cast<int>(way_out.pose) + 1);
  json.key("reason");
  way_out.reason ? json.value(std::string_view(way_out.reason->message)) : json.null();
  json.member("meeting_requirements", way_out.meeting);
  json.key("miss");
  if (way_out.linkage) {
    write_miss(json, way_out.miss, frame.scale);
  } else {
    json.null();
  }
  json.key("linkage");
  way_out.linkage ? write_four_bar(json, *way_out.linkage, frame, {.poses = freed_task(task, way_out.pose).task.poses})
                  : json.null();
  json.end_object();
}

void write_ways_out(JsonWriter& json, const Problem& problem, const Solution& solution) {
  json.begin_list();
  if (const auto* motion = std::get_if<MotionTask>(&problem.task)) {
    for (const FreedPosition& way_out : solution.freed) write_way_out(json, way_out, *motion, solution.given.frame());
  }
  json.end_list();
}

Problem as_solved(const Problem& problem, const Solution& solution) {
  Problem used = problem;
  used.requirements = solution.requirements;
  used.options = solution.options;
  return used;
}

void write_answer(JsonWriter& json, const Problem& problem, const Solution& solution, bool with_region) {
  json.member("status", name(solution.status));
  json.member("reason", std::string_view(solution.reason.message));
  json.member("pattern", std::string_view(solution.given.pattern));
  json.member("condition", solution.given.conditions.condition());
  json.member("characteristic_length", solution.given.frame().scale);
  json.key("warnings");
  write_warnings(json, solution.given.warnings);
  json.key("curve");
  write_curve(json, problem.task, solution);
  json.key("dyads");
  write_burmester_points(json, solution.given);
  json.key("region");
  write_region(json, problem, solution, with_region);
  if (solution.search) {
    json.key("search");
    write_search(json, *solution.search, solution.options);
  }
  json.key("linkages");
  write_linkages(json, problem, solution);
  json.key("pairs");
  write_four_bars(json, solution.pairs, solution.given);
  json.key("freed");
  write_ways_out(json, problem, solution);
  json.key("relax");
  write_relaxations(json, solution.relax);
  if (solution.relax_together) {
    json.key("relax_together");
    write_joint_relaxation(json, *solution.relax_together);
  }
}

}  // namespace

void write_relaxed_value(JsonWriter& json, const Relaxation& relaxation) {
  const bool is_angle = relaxation.requirement == RequirementKind::min_transmission_angle;
  json.key("value");
  if (relaxation.box)
    write_box(json, *relaxation.box);
  else if (relaxation.value)
    json.value(is_angle ? degrees_for_files(*relaxation.value) : *relaxation.value);
  else
    json.null();
}

void write_joint_relaxation(JsonWriter& json, const JointRelaxation& joint) {
  json.begin_object(Layout::one_line);
  json.key("requirements");
  json.begin_list(Layout::one_line);
  for (const RequirementKind requirement : joint.requirements) json.value(key(requirement));
  json.end_list();
  json.member("leaves", joint.leaves);
  json.end_object();
}

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
  write_answer(json, problem, solution, with_region);
  json.end_object();
}

std::string write_result(const Problem& problem, const Solution& solution, bool with_region) {
  std::string text;
  write_result([&text](std::string_view piece) { text += piece; }, problem, solution, with_region);
  return text;
}

}  // namespace linkwright
