#include "result_writer.hpp"

#include <array>
#include <cmath>
#include <span>

#include "files/fields/field_writer.hpp"
#include "files/json/json_writer.hpp"
#include "kinds.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/number_text.hpp"
#include "linkwright/files/result_file.hpp"
#include "problem_fields.hpp"
#include "problem_writer.hpp"
#include "region_arrays.hpp"

namespace linkwright {
namespace {

using Layout = JsonWriter::Layout;

// How many linkages a cell has.
template <class KindAnswer>
std::size_t layer_count(const KindAnswer& answer) {
  if constexpr (std::is_same_v<KindAnswer, StraightLineAnswer>)
    return answer.lines ? static_cast<std::size_t>(answer.lines->layers()) : 1;
  else
    return 1;
}

// Coordinates of the samples along an axis, once where there are layers. Straight lines have the numbers that people
// read for coordinates.
template <class KindAnswer>
std::vector<double> file_coordinates(const KindAnswer& answer, Side side) {
  const auto all = side == Side::input ? answer.region.input_coordinates() : answer.region.output_coordinates();
  const std::size_t layers = side == Side::input ? layer_count(answer) : 1;
  std::vector<double> once(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.size() / layers));
  if constexpr (std::is_same_v<KindAnswer, StraightLineAnswer>)
    for (double& coordinate : once) coordinate = answer.lines->axis_value(side, coordinate);
  return once;
}

void write_numbers(JsonWriter& json, std::string_view key, std::span<const double> numbers) {
  json.key(key);
  json.begin_list(Layout::one_line);
  for (const double number : numbers) json.value(number);
  json.end_list();
}

void write_counts(JsonWriter& json, const RegionCounts& counts, std::span<const LinkageType> types) {
  json.begin_object();
  for (const LinkageType type : types) json.member(name(type), counts.types[static_cast<std::size_t>(type)]);
  json.member("order", counts.order);
  json.member("branch", counts.branch);
  json.member("circuit", counts.circuit);
  json.member("defect_free", counts.defect_free);
  json.member("pairs", counts.pairs);
  json.end_object();
}

template <class KindAnswer>
void write_axis(JsonWriter& json, const Problem& problem, const KindAnswer& answer, Side side) {
  const AxisLabel label = axis_label(answer, side, problem.length_unit);
  json.begin_object();
  json.member("name", std::string_view(label.name));
  json.member("quantity", label.quantity);
  json.member("unit", std::string_view(label.unit));
  json.key("branches");
  write_branches(json, label.branches);
  if (const LinkageFamily* family = answer.family(); family && has_values(family->axis(side).quantity)) {
    const auto all = side == Side::input ? answer.region.input_coordinates() : answer.region.output_coordinates();
    json.key("values");
    json.begin_list(Layout::one_line);
    for (const double tau : all.first(all.size() / (side == Side::input ? layer_count(answer) : 1)))
      json.value(family->axis_value(side, tau));
    json.end_list();
  }
  json.end_object();
}

void write_inside(JsonWriter& json, const InsideWindows& inside) {
  json.key("inside_windows");
  json.begin_object(Layout::one_line);
  json.member("looked_at", inside.looked_at);
  json.member("meeting_requirements", inside.meeting);
  json.member("proved_empty", inside.is_empty);
  json.end_object();
}

template <class KindAnswer>
void write_region(JsonWriter& json, const Problem& problem, const KindAnswer& answer, bool with_arrays) {
  const RegionMap& region = answer.region;
  json.begin_object();
  json.member("samples", static_cast<std::int64_t>(region.rows() / layer_count(answer)));
  if (layer_count(answer) > 1) json.member("layers", static_cast<std::int64_t>(layer_count(answer)));
  write_numbers(json, "input_coordinate", file_coordinates(answer, Side::input));
  write_numbers(json, "output_coordinate", file_coordinates(answer, Side::output));
  json.key("axes");
  json.begin_list();
  for (const auto side : {Side::input, Side::output}) write_axis(json, problem, answer, side);
  json.end_list();
  json.key("counts");
  write_counts(json, answer.counts, linkages(problem.task).types);
  json.member("meeting_requirements", answer.meeting_requirements);
  if (answer.inside) write_inside(json, *answer.inside);
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

// As options.at wants it.
template <class KindAnswer>
void write_place(JsonWriter& json, const KindAnswer& answer, MapPoint place) {
  if constexpr (std::is_same_v<KindAnswer, StraightLineAnswer>) {
    const MapNumbers there = answer.lines->place_of(place);
    if (answer.lines->layers() > 1) json.member("layer", there.layer);
    place = {there.at[0], there.at[1]};
  }
  json.key("at");
  write_interval(json, place.input, place.output);
}

template <class KindAnswer>
void write_front(JsonWriter& json, const KindAnswer& found) {
  json.key("pareto");
  json.begin_object();
  json.key("objectives");
  json.begin_list(Layout::one_line);
  for (const Objective objective : *found.options.pareto) json.value(name(objective));
  json.end_list();
  json.key("front");
  json.begin_list();
  for (const ParetoCell& cell : found.pareto) {
    json.begin_object(Layout::one_line);
    write_place(json, found,
                {found.region.input_coordinates()[cell.row], found.region.output_coordinates()[cell.column]});
    json.key("values");
    write_interval(json, readable_value(measure_of((*found.options.pareto)[0]), cell.values[0]),
                   readable_value(measure_of((*found.options.pareto)[1]), cell.values[1]));
    json.end_object();
  }
  json.end_list();
  json.end_object();
}

Problem as_solved(const Problem& problem, const Findings& found) {
  Problem used = problem;
  used.requirements = found.requirements;
  used.options = found.options;
  return used;
}

template <class KindAnswer>
void write_answer(JsonWriter& json, const Problem& problem, const KindAnswer& answer, bool with_region) {
  json.member("status", name(answer.status));
  json.member("reason", std::string_view(answer.reason.message));
  json.member("pattern", std::string_view(answer.pattern));
  json.member("condition", answer.condition);
  json.member("characteristic_length", answer.characteristic_length);
  json.key("warnings");
  write_notices(json, answer.warnings);
  write_dyads(json, answer);
  json.key("region");
  is_mapped(answer) ? write_region(json, problem, answer, with_region) : json.null();
  if (answer.options.pareto) write_front(json, answer);
  write_linkages(json, answer);
  json.key("relax");
  write_relaxations(json, answer.relax);
  if (answer.relax_together) {
    json.key("relax_together");
    write_joint_relaxation(json, *answer.relax_together);
  }
}

}  // namespace

void write_notices(JsonWriter& json, const std::vector<Notice>& notices) {
  json.begin_list();
  for (const Notice& notice : notices) {
    json.begin_object(Layout::one_line);
    json.member("code", std::string_view(notice.code));
    json.member("message", std::string_view(notice.message));
    json.end_object();
  }
  json.end_list();
}

void write_relaxed_value(JsonWriter& json, const Relaxation& relaxation) {
  json.key("value");
  if (relaxation.box)
    write_fields(json, *relaxation.box);
  else if (relaxation.value)
    json.value(criterion(relaxation.requirement).is_angle() ? degrees_for_files(*relaxation.value) : *relaxation.value);
  else
    json.null();
}

void write_failures(JsonWriter& json, const std::vector<RequirementKind>& failed) {
  json.member("meets_requirements", failed.empty());
  if (failed.empty()) return;
  json.key("fails");
  json.begin_list(Layout::one_line);
  for (const RequirementKind kind : failed) json.value(key(kind));
  json.end_list();
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

void write_result(const TextSink& sink, const Problem& problem, const Answer& answer, bool with_region) {
  JsonWriter json(sink);
  json.begin_object();
  json.member("linkwright", file_version);
  json.key("problem");
  write_fields(json, as_solved(problem, findings(answer)));
  std::visit([&](const auto& of_kind) { write_answer(json, problem, of_kind, with_region); }, answer);
  json.end_object();
}

std::string write_result(const Problem& problem, const Answer& answer, bool with_region) {
  std::string text;
  write_result([&text](std::string_view piece) { text += piece; }, problem, answer, with_region);
  return text;
}

}  // namespace linkwright
