#include <array>

#include "files/fields/field_writer.hpp"
#include "files/fields/result_forms.hpp"
#include "files/problem_writer.hpp"
#include "files/result_fields.hpp"
#include "linkwright/core/angle.hpp"
#include "replies.hpp"
#include "reply_json.hpp"

namespace linkwright::wasm {
namespace {

using Layout = JsonWriter::Layout;

constexpr int steps_of_a_curve = 90;

// ---- axes and marks
// --------------------------------------------------------------------------------------------------

void write_block(JsonWriter& json, const OrderBlock& block) {
  json.begin_object(Layout::one_line);
  json.member("branch", static_cast<int>(block.branch));
  json.member("from", block.from);
  json.member("to", block.to);
  json.key("knots");
  write_rows(json, block.knots);
  json.end_object();
}

void write_axis(JsonWriter& json, const ShownAxis& axis) {
  json.begin_object();
  json.member("quantity", name(axis.axis.quantity));
  json.member("order", axis.order.code());
  json.key("branches");
  write_fields(json, axis.axis.branches, forms::branches);
  json.key("ticks");
  axis.ticks.empty() ? json.null() : write_rows(json, axis.ticks);
  json.key("blocks");
  json.begin_list();
  for (const OrderBlock& block : axis.order.blocks()) write_block(json, block);
  json.end_list();
  json.end_object();
}

void write_mark(JsonWriter& json, const CurveMark& mark) {
  json.begin_object(Layout::one_line);
  json.member("kind", name(mark.kind));
  if (mark.kind == CurveMark::Kind::pole) {
    json.key("positions");
    write_numbers(json, std::array{mark.poses[0] + 1.0, mark.poses[1] + 1.0});
  }
  json.key("tau");
  write_numbers(json, mark.tau);
  json.key("center");
  write_point(json, mark.center);
  json.key("circle");
  write_point(json, mark.circle);
  json.end_object();
}

// ---- curves
// ----------------------------------------------------------------------------------------------------------

void write_asymptote(JsonWriter& json, const CircularCubic& curve, const WorkingFrame& frame) {
  const auto asymptote = curve.asymptote();
  if (!asymptote) return json.null();
  json.begin_list(Layout::one_line);
  write_point(json, frame.to_user((*asymptote)[0]));
  write_point(json, (*asymptote)[1]);
  json.end_list();
}

/// Of Burmester curves, or of what the dyads lie along instead.
void write_curves(JsonWriter& json, const TaskFamily& given) {
  const BurmesterCurve* curve = given.curve.get();
  const std::string_view along =
      given.family ? name(given.family->axis(Side::input).quantity) : name(CubicKind::every_point);
  json.begin_object();
  json.member("kind", curve ? name(curve->kind()) : along);
  json.member("center_kind", curve ? name(curve->center_kind()) : along);
  json.key("kappa");
  const auto kappa = curve ? curve->kappa() : std::nullopt;
  kappa ? json.value(*kappa) : json.null();
  json.key("asymptotes");
  json.begin_object();
  json.key("center");
  curve ? write_asymptote(json, curve->center_curve(), given.frame()) : json.null();
  json.key("circle");
  curve ? write_asymptote(json, curve->circle_curve(), given.frame()) : json.null();
  json.end_object();
  json.end_object();
}
void write_curves_of(JsonWriter& json, const FourBarAnswer& known) { write_curves(json, known.given); }
void write_curves_of(JsonWriter& json, const SphericalAnswer& known) {
  const SphericalTaskFamily& given = known.given;
  const CubicConeKind kind = given.curve ? given.curve->kind() : CubicConeKind::every_axis;
  json.begin_object();
  json.member("kind", given.curve || !given.family ? name(kind) : name(AxisQuantity::burmester_point));
  for (const char* key : {"center_kind", "kappa", "asymptotes"}) {
    json.key(key);
    json.null();
  }
  json.end_object();
}
void write_curves_of(JsonWriter& json, const Findings& /*known*/) { write_curves(json, TaskFamily{}); }

/// The pairs, and the named function between them; degrees.
void write_function(JsonWriter& json, const WantedFunction* wanted) {
  if (wanted == nullptr) return json.null();
  std::vector<std::array<double, 2>> pairs, curve;
  for (const AnglePair& pair : wanted->pairs) pairs.push_back({degrees(pair.input), degrees(pair.output)});
  if (wanted->function) {
    const ScaledFunction scaled(*wanted->function);
    const auto [from, to] = scaled.input_range();
    for (int i = 0; i <= steps_of_a_curve; ++i) {
      const double input = from + (to - from) * i / steps_of_a_curve;
      curve.push_back({degrees(input), degrees(scaled.output_at(input))});
    }
  }
  json.begin_object();
  json.key("pairs");
  write_rows(json, pairs);
  json.key("curve");
  write_rows(json, curve);
  json.end_object();
}

// ---- the census
// ------------------------------------------------------------------------------------------------------

template <class Counts>
void write_counts(JsonWriter& json, std::string_view key, const Counts& counts) {
  json.key(key);
  json.begin_list(Layout::one_line);
  for (const std::int64_t count : counts) json.value(count);
  json.end_list();
}

template <class CountOf>
void write_by_requirement(JsonWriter& json, std::string_view key, RequirementKinds kinds, CountOf count_of) {
  std::vector<std::int64_t> counts;
  for (const RequirementKind kind : kinds) counts.push_back(count_of(kind));
  write_counts(json, key, counts);
}

void write_relaxation(JsonWriter& json, const Relaxation& relaxation) {
  json.begin_object(Layout::one_line);
  json.member("requirement", key(relaxation.requirement));
  json.key("value");
  FieldWriter value(json);
  visit_relaxed_value(value, relaxation);
  json.member("leaves", relaxation.leaves);
  json.end_object();
}

void write_missed_box(JsonWriter& json, const MissedBox& missed) {
  json.begin_object(Layout::one_line);
  json.member("requirement", key(missed.box));
  json.key("nearest");
  write_point(json, missed.nearest);
  json.key("beyond");
  write_point(json, missed.beyond);
  json.end_object();
}

template <class Items, class Write>
void write_list(JsonWriter& json, std::string_view key, const Items& items, Write write) {
  json.key(key);
  json.begin_list();
  for (const auto& item : items) write(json, item);
  json.end_list();
}

}  // namespace

std::string task_reply(Session& session) {
  const Findings& known = findings(session.known());
  const auto reason = session.why_nothing();
  const SolutionStatus status = !reason            ? SolutionStatus::solved
                                : session.family() ? SolutionStatus::no_solution
                                                   : SolutionStatus::degenerate;
  return json_text_of([&](JsonWriter& json) {
    json.begin_object();
    json.member("status", name(status));
    json.key("reason");
    reason ? write_notice(json, *reason) : json.null();
    json.member("pattern", std::string_view(known.pattern));
    json.member("condition", known.condition);
    json.member("characteristic_length", known.characteristic_length);
    write_list(json, "warnings", known.warnings, write_notice);
    json.key("curves");
    std::visit([&](const auto& of_kind) { write_curves_of(json, of_kind); }, session.known());
    json.member("symmetric", session.axes().symmetric);
    json.key("axes");
    json.begin_object();
    json.key("input");
    write_axis(json, session.axes().input);
    json.key("output");
    write_axis(json, session.axes().output);
    json.end_object();
    write_list(json, "specials", session.marks(), write_mark);
    json.key("function");
    write_function(json, wanted_function(session.problem().task));
    json.key("requirements");
    write_requirements(json, known.requirements, linkages(session.problem().task));
    json.end_object();
  });
}

std::string census_reply(const ColouredMap& map) {
  const RegionCounts& of = map.counts;
  const RequirementCensus& met = map.census;
  return json_text_of([&](JsonWriter& json) {
    json.begin_object();
    write_counts(json, "types", of.types);
    json.member("pairs", of.pairs);
    json.member("order", of.order);
    json.member("branch", of.branch);
    json.member("circuit", of.circuit);
    json.member("defect_free", of.defect_free);
    json.member("meeting", met.meeting);
    write_counts(json, "meeting_types", met.meeting_types);
    write_by_requirement(json, "only", met.kinds, [&](RequirementKind kind) { return met.failing_only(kind); });
    write_by_requirement(json, "left", met.kinds, [&](RequirementKind kind) { return met.left_after(kind); });
    write_list(json, "relax", map.relax, write_relaxation);
    json.key("relax_together");
    map.relax_together ? write_fields(json, *map.relax_together) : json.null();
    write_list(json, "missed_boxes", map.missed_boxes, write_missed_box);
    json.key("inside");
    json.begin_object(Layout::one_line);
    json.member("looked_at", map.inside.looked_at);
    json.member("meeting", map.inside.meeting);
    json.member("is_empty", map.inside.is_empty);
    json.end_object();
    json.end_object();
  });
}

}  // namespace linkwright::wasm
