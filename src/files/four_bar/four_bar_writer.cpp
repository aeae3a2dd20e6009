#include "four_bar_writer.hpp"

#include <algorithm>
#include <cmath>

#include "files/fields/field_writer.hpp"
#include "files/function/function_error_writer.hpp"
#include "files/problem_fields.hpp"
#include "files/problem_writer.hpp"
#include "files/result_writer.hpp"
#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

using Layout = JsonWriter::Layout;

/// The finite point, or null where it is at infinity by the measure of the working frame.
void write_point_or_null(JsonWriter& json, Homogeneous point, const WorkingFrame& frame) {
  if (is_at_infinity(frame.to_working(point))) return json.null();
  write_point(json, Point{point.x / point.w, point.y / point.w});
}

void write_dyad(JsonWriter& json, const Dyad& dyad, double residual, const WorkingFrame& frame) {
  json.begin_object();
  write_dyad_members(json, dyad, residual, frame);
  json.end_object();
}

/// Over the task; null where a defect leaves it undefined.
void write_task_transmission(JsonWriter& json, const DefectReport& report) {
  json.key("min_transmission_angle_deg");
  if (!report.defects.none()) return json.null();
  json.value(degrees(report.min_transmission_angle));
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

}  // namespace

void write_pose_error(JsonWriter& json, const PoseError& error, double size) {
  json.begin_object(Layout::one_line);
  json.member("distance", error.distance);
  json.member("angle_deg", degrees(error.angle));
  json.member("combined", error.combined(size));
  json.end_object();
}

namespace {

void write_notes(JsonWriter& json, const FourBarNotes& notes) {
  notes.listed.write(json);
  if (notes.defect) json.member("reason", std::string_view(notes.defect->message));
  if (notes.free_value) json.member("free_value", *notes.free_value);
  if (notes.poses.empty()) return;
  json.key("poses");
  write_fields(json, notes.poses, on_lines);
}

}  // namespace

FourBarNotes notes_on(const FourBarSolution& found, const TaskFamily& given) {
  const FourBarFamily& family = *given.family;
  FourBarNotes notes;
  notes.defect = defect_notice(found, given);
  if (given.relaxed) notes.pose_error_size = given.relaxed->size;
  if (found.function || given.relaxed)
    notes.poses = family.user_poses({found.input.coordinate, found.output.coordinate}, found.four_bar);
  const AxisQuantity quantity = family.axis(Side::output).quantity;
  if (quantity == AxisQuantity::output_scale || quantity == AxisQuantity::pair_output)
    notes.free_value = family.axis_value(Side::output, found.output.coordinate);
  return notes;
}

void write_homogeneous(JsonWriter& json, Homogeneous point) {
  json.begin_list(Layout::one_line);
  json.value(point.w);
  json.value(point.x);
  json.value(point.y);
  json.end_list();
}

void write_dyad_members(JsonWriter& json, const Dyad& dyad, double residual, const WorkingFrame& frame) {
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
}

void write_four_bar(JsonWriter& json, const FourBarSolution& found, const WorkingFrame& frame,
                    const FourBarNotes& notes) {
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
  input_is_crank(found.report.type) ? json.value(degrees(found.report.min_transmission_angle_full_turn)) : json.null();
  json.member("residual", found.residual);
  if (found.residual_derivatives) json.member("residual_derivatives", *found.residual_derivatives);
  if (found.function) write_function_error(json, *found.function);
  if (found.pose_error) {
    json.key("miss");
    write_pose_error(json, *found.pose_error, notes.pose_error_size);
  }
  json.member("local_optimum", found.local_optimum);
  json.member("verified_by_driving", found.verified_by_driving);
  write_notes(json, notes);
  json.key("swapped");
  write_swapped(json, found.swapped);
  json.end_object();
}

}  // namespace linkwright
