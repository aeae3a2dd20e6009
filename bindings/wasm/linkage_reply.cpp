#include "linkage_reply.hpp"

#include <algorithm>
#include <cmath>

#include "files/problem_writer.hpp"
#include "function_reply.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/planar/function_family.hpp"
#include "reply_json.hpp"

namespace linkwright::wasm {
namespace {

using Layout = JsonWriter::Layout;

void write_or_null(JsonWriter& json, std::string_view key, bool defined, double value) {
  json.key(key);
  defined ? json.value(value) : json.null();
}

void write_dyad(JsonWriter& json, const Dyad& dyad, const WorkingFrame& frame) {
  const auto center = frame.finite_user_point(dyad.center), circle = frame.finite_user_point(dyad.circle);
  json.begin_object();
  json.member("coordinate", dyad.coordinate);
  json.key("center");
  write_point(json, center);
  json.key("circle");
  write_point(json, circle);
  json.key("center_homogeneous");
  write_numbers(json, std::array{dyad.center.w, dyad.center.x, dyad.center.y});
  json.key("circle_homogeneous");
  write_numbers(json, std::array{dyad.circle.w, dyad.circle.x, dyad.circle.y});
  write_or_null(json, "length", center && circle, center && circle ? std::abs(*circle - *center) : 0);
  json.end_object();
}

Notice degenerate_notice(const PickedLinkage& picked, const WorkingFrame& frame) {
  if (picked.nothing) return *picked.nothing;
  const auto at_infinity = [&](Homogeneous point) { return is_at_infinity(frame.to_working(point)); };
  if (picked.input.circle == Homogeneous{} || picked.output.circle == Homogeneous{})
    return {"no_linkage", "There is no linkage here: no grounded link of this length can have this direction.", {}};
  if (at_infinity(picked.input.center) || at_infinity(picked.output.center))
    return {"slider_fixed", "Slider: the fixed pivot is at infinity; the pin moves on a straight guide.", {}};
  if (at_infinity(picked.input.circle) || at_infinity(picked.output.circle))
    return {
        "slider_moving", "Slider: the moving pivot is at infinity; a guide in the body slides on the fixed pivot.", {}};
  return {"zero_link", "A link has no length: this is no four-bar.", {}};
}

/// Positions as the task counts them, from 1: the relaxed pose is none of those that are served.
int position_of(std::size_t pose, const PickedLinkage& picked) {
  const bool behind = picked.relaxed_index && pose >= *picked.relaxed_index;
  return static_cast<int>(pose) + (behind ? 2 : 1);
}

/// The values of a defect's notice, which counts the poses served.
void renumber(Notice& notice, const PickedLinkage& picked) {
  const auto position = [&](int served) { return position_of(static_cast<std::size_t>(served - 1), picked); };
  for (NamedValue& value : notice.values)
    if (auto* number = std::get_if<double>(&value.value))
      *number = position(static_cast<int>(*number));
    else
      for (char& digit : std::get<std::string>(value.value))
        if (digit != '-') digit = static_cast<char>('0' + position(digit - '0'));
}

void write_reason(JsonWriter& json, const PickedLinkage& picked, const WorkingFrame& frame) {
  json.key("reason");
  if (!picked.bars) return write_notice(json, degenerate_notice(picked, frame));
  auto reason = defect_notice(picked.bars->report.defects, picked.visits);
  if (!reason) return json.null();
  renumber(*reason, picked);
  write_notice(json, *reason);
}

void write_lengths(JsonWriter& json, const PickedLinkage& picked) {
  json.key("lengths");
  if (!picked.bars) {
    json.null();
  } else {
    write_lengths(json, picked.bars->lengths);
  }
  const LinkLengths lengths = picked.bars ? picked.bars->lengths : LinkLengths{1, 1, 1, 1};
  write_or_null(json, "link_ratio", picked.bars.has_value(), lengths.longest() / lengths.shortest());
  write_or_null(json, "longest", picked.bars.has_value(), lengths.longest());
}

void write_verdict(JsonWriter& json, const PickedLinkage& picked) {
  const DefectReport report = picked.bars ? picked.bars->report : DefectReport{};
  const bool clean = picked.bars && report.defects.none();
  write_or_null(json, "min_transmission_angle_deg", clean, degrees(report.min_transmission_angle));
  write_or_null(json, "min_transmission_angle_full_turn_deg", picked.bars && input_is_crank(report.type),
                degrees(report.min_transmission_angle_full_turn));
  write_or_null(json, "driver_sweep_deg", clean, degrees(report.sweep));
  json.key("drive_sense");
  report.sense == DriveSense::none ? json.null() : json.value(name(report.sense));
}

void write_swapped(JsonWriter& json, const PickedLinkage& picked) {
  json.key("swapped");
  if (!picked.bars) return json.null();
  const DefectReport& report = picked.bars->swapped;
  json.begin_object(Layout::one_line);
  json.member("type", name(report.type));
  json.key("defects");
  write_defects(json, report.defects);
  write_or_null(json, "min_transmission_angle_deg", report.defects.none(), degrees(report.min_transmission_angle));
  json.end_object();
}

/// Of the pose that was freed.
void write_pose_error(JsonWriter& json, const PickedLinkage& picked) {
  json.key("miss");
  if (!picked.bars || !picked.bars->pose_error) return json.null();
  json.begin_object(Layout::one_line);
  json.member("distance", picked.bars->pose_error->distance);
  json.member("angle_deg", degrees(picked.bars->pose_error->angle));
  json.member("input_deg", degrees(picked.bars->pose_error->turn));
  json.end_object();
}

void write_function(JsonWriter& json, const PickedLinkage& picked) {
  json.key("function");
  if (!picked.task) return json.null();
  write_generated_function(json, *picked.task, *picked.bars->function);
}

void write_ticks(JsonWriter& json, const PickedLinkage& picked) {
  const DriveTable& drive = picked.drive;
  json.key("ticks");
  json.begin_list();
  for (std::size_t pose = 0; pose < drive.state_of_pose.size(); ++pose) {
    json.begin_object(Layout::one_line);
    json.member("position", position_of(pose, picked));
    json.member("state", drive.state_of_pose[pose]);
    json.member("reached", drive.state_of_pose[pose] >= 0);
    json.end_object();
  }
  json.end_list();
}

void write_drive(JsonWriter& json, const PickedLinkage& picked) {
  json.key("dead_points_deg");
  const bool rocks = !picked.drive.states.empty() && !picked.drive.full_turn;
  const std::array limits = {degrees(picked.visits.travel.from), degrees(picked.visits.travel.to)};
  write_numbers(json, std::span(limits).first(rocks ? 2 : 0));
  json.key("drive");
  if (picked.drive.states.empty()) return json.null();
  json.begin_object();
  write_ticks(json, picked);
  json.member("full_turn", picked.drive.full_turn);
  json.key("limits");
  json.begin_object(Layout::one_line);
  for (const char* end : {"low", "high"}) {
    json.key(end);
    rocks ? json.value("dead_point") : json.null();
  }
  json.end_object();
  const int first = picked.drive.state_of_pose.front(), last = picked.drive.state_of_pose.back();
  const bool apart = first < 0 || last < 0;
  json.key("task");
  json.begin_list(Layout::one_line);
  json.value(apart ? -1 : first);
  json.value(apart ? -1 : last);
  json.end_list();
  json.end_object();
}

}  // namespace

PickedLinkage picked_linkage(const TaskFamily& given, MapPoint place, bool respect_direction) {
  const WorkingFrame& frame = given.frame();
  const DyadPair none{{{}, {}, place.input}, {{}, {}, place.output}};
  const DyadPair links = given.family->dyad_pair(place).value_or(none);
  PickedLinkage picked;
  picked.input = frame.to_user(links.input);
  picked.output = frame.to_user(links.output);
  if (given.relaxed) picked.relaxed_index = given.relaxed->index;
  constexpr bool verify = false;
  picked.bars = make_four_bar(given, place, respect_direction, verify);
  if (!picked.bars) return picked;
  const std::vector<PrescribedPose> poses = given.family->user_poses(place, picked.bars->four_bar);
  picked.visits = pose_visits(picked.bars->four_bar, poses);
  picked.drive = drive_table(picked.visits, poses, states_of_a_drive);
  if (const auto& family = given.functions) {
    picked.task = family->task_at(place);
    picked.bars->function = family->error_of(picked.bars->four_bar, place);
  }
  return picked;
}

std::string linkage_json(const PickedLinkage& picked, const WorkingFrame& frame,
                         const std::function<void(JsonWriter&)>& write_more) {
  return json_of([&](JsonWriter& json) {
    json.begin_object();
    json.key("tau");
    write_numbers(json, std::array{picked.input.coordinate, picked.output.coordinate});
    json.member("type", name(picked.bars ? picked.bars->report.type : LinkageType::degenerate));
    json.key("defects");
    write_defects(json, picked.bars ? picked.bars->report.defects : Defects{});
    write_reason(json, picked, frame);
    json.key("input");
    write_dyad(json, picked.input, frame);
    json.key("output");
    write_dyad(json, picked.output, frame);
    write_lengths(json, picked);
    write_verdict(json, picked);
    json.member("residual", picked.bars ? std::max(picked.bars->input_residual * picked.bars->lengths.input,
                                                   picked.bars->output_residual * picked.bars->lengths.output)
                                        : 0.0);
    write_swapped(json, picked);
    write_pose_error(json, picked);
    write_function(json, picked);
    json.member("fails", int{picked.fails});
    if (write_more) write_more(json);
    write_drive(json, picked);
    json.end_object();
  });
}

void append_states(const PickedLinkage& picked, std::vector<double>& states) {
  for (const DriveState& state : picked.drive.states)
    states.insert(
        states.end(),
        {degrees(state.turn), state.four_bar.input_circle.real(), state.four_bar.input_circle.imag(),
         state.four_bar.output_circle.real(), state.four_bar.output_circle.imag(), state.body.origin.real(),
         state.body.origin.imag(), degrees(state.body.angle), degrees(state.transmission_angle),
         degrees(state.coupler_turn), degrees(state.output_turn), state.velocity_ratio, state.mechanical_advantage});
}

}  // namespace linkwright::wasm
