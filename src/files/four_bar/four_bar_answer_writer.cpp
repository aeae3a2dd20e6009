#include <span>

#include "files/four_bar/four_bar_writer.hpp"
#include "files/result_writer.hpp"
#include "four_bar_kind.hpp"
#include "linkwright/planar/relaxed_position.hpp"

namespace linkwright {
namespace {

using Layout = JsonWriter::Layout;

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

// One that has grown to everything is a curve all the same.
void write_curve(JsonWriter& json, const FourBarAnswer& answer, bool is_asked_for) {
  const BurmesterCurve* curve = answer.given.curve.get();
  if (curve == nullptr && !is_asked_for) return json.null();
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
  write_coordinates(json, "coordinate", answer.samples);
  write_points(json, "center_homogeneous", answer.samples, &Dyad::center);
  write_points(json, "circle_homogeneous", answer.samples, &Dyad::circle);
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

void write_four_bars(JsonWriter& json, const std::vector<FourBarSolution>& list, const TaskFamily& given) {
  json.begin_list();
  for (const FourBarSolution& found : list) write_four_bar(json, found, given.frame(), notes_on(found, given));
  json.end_list();
}

void write_way_out(JsonWriter& json, const RelaxedPosition& way_out, const MotionTask& task,
                   const WorkingFrame& frame) {
  json.begin_object();
  json.member("pose", static_cast<int>(way_out.pose) + 1);
  json.key("reason");
  way_out.reason ? json.value(std::string_view(way_out.reason->message)) : json.null();
  json.member("meeting_requirements", way_out.meeting);
  json.key("miss");
  if (way_out.linkage) {
    write_pose_error(json, way_out.pose_error, frame.scale);
  } else {
    json.null();
  }
  json.key("linkage");
  way_out.linkage
      ? write_four_bar(json, *way_out.linkage, frame, {.poses = relaxed_task(task, way_out.pose).task.poses})
      : json.null();
  json.end_object();
}

void write_dyads(JsonWriter& json, const FourBarAnswer& answer, bool is_curve_asked_for) {
  json.key("curve");
  write_curve(json, answer, is_curve_asked_for);
  json.key("dyads");
  write_burmester_points(json, answer.given);
}

void write_lists(JsonWriter& json, const FourBarAnswer& answer) {
  json.key("linkages");
  json.begin_list();
  for (std::size_t i = 0; i < answer.linkages.size(); ++i) {
    FourBarNotes notes = notes_on(answer.linkages[i], answer.given);
    notes.listed = ListedNotes(answer, i);
    write_four_bar(json, answer.linkages[i], answer.given.frame(), notes);
  }
  json.end_list();
  json.key("pairs");
  write_four_bars(json, answer.pairs, answer.given);
}

StoredLinkage stored(const FourBarSolution& found, const FourBarAnswer& answer,
                     const std::vector<PrescribedPose>& poses) {
  const FourBarNotes notes = notes_on(found, answer.given);
  StoredLinkage linkage;
  linkage.four_bar = found.four_bar;
  linkage.poses = notes.poses.empty() ? poses : notes.poses;
  linkage.record = json_text_of([&](JsonWriter& json) { write_four_bar(json, found, answer.given.frame(), notes); });
  return linkage;
}

}  // namespace

void write_dyads(JsonWriter& json, const MotionAnswer& answer) {
  const MotionTask& task = answer.task;
  const bool of_center = task.given && std::holds_alternative<InstantCenter>(*task.given);
  write_dyads(json, answer, task.relaxed || position_count(task.poses) == 4 || of_center);
}

void write_dyads(JsonWriter& json, const FunctionAnswer& answer) {
  write_dyads(json, answer, position_count(answer.task.pairs) == 4);
}

void write_linkages(JsonWriter& json, const MotionAnswer& answer) {
  write_lists(json, answer);
  json.key("freed");
  json.begin_list();
  for (const RelaxedPosition& way_out : answer.relaxed) write_way_out(json, way_out, answer.task, answer.given.frame());
  json.end_list();
}

void write_linkages(JsonWriter& json, const FunctionAnswer& answer) {
  write_lists(json, answer);
  json.key("freed");
  json.begin_list();
  json.end_list();
}

StoredLinkage stored(const FourBarSolution& found, const MotionAnswer& answer) {
  return stored(found, answer, answer.task.poses);
}

StoredLinkage stored(const FourBarSolution& found, const FunctionAnswer& answer) { return stored(found, answer, {}); }

}  // namespace linkwright
