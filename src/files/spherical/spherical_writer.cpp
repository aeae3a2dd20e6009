#include "spherical_writer.hpp"

#include "files/attitude/space_writer.hpp"
#include "files/fields/field_writer.hpp"
#include "files/function/function_error_writer.hpp"
#include "files/problem_fields.hpp"
#include "files/problem_writer.hpp"
#include "files/result_writer.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/spherical/spherical_defects.hpp"

namespace linkwright {
namespace {

using Layout = JsonWriter::Layout;

/// Over the task; null where a defect leaves it undefined.
void write_transmission(JsonWriter& json, const DefectReport& report) {
  json.key("min_transmission_angle_deg");
  report.defects.none() ? json.value(degrees(report.min_transmission_angle)) : json.null();
}

void write_report(JsonWriter& json, const DefectReport& report) {
  json.member("type", name(report.type));
  json.key("defects");
  write_defects(json, report.defects);
}

}  // namespace

void write_angles(JsonWriter& json, std::string_view key, const LinkAngles& angles) {
  json.key(key);
  json.begin_object(Layout::one_line);
  json.member("ground", degrees(angles.ground));
  json.member("input", degrees(angles.input));
  json.member("coupler", degrees(angles.coupler));
  json.member("output", degrees(angles.output));
  json.end_object();
}

namespace {

void write_dyad_members(JsonWriter& json, const SphericalDyad& dyad, double residual) {
  write_vector(json, "moving_axis", dyad.moving_axis);
  write_vector(json, "fixed_axis", dyad.fixed_axis);
  json.member("angle_deg", degrees(dyad.angle()));
  json.member("coordinate", dyad.coordinate);
  json.member("residual", residual);
}

}  // namespace

void write_spherical_dyad(JsonWriter& json, const SphericalDyad& dyad, double residual) {
  json.begin_object();
  write_dyad_members(json, dyad, residual);
  json.end_object();
}

void write_spherical_dyad(JsonWriter& json, const SphericalDyadPoint& point) {
  json.begin_object();
  write_dyad_members(json, point.dyad, point.residual);
  json.member("multiplicity", point.multiplicity);
  json.member("condition", point.condition);
  json.end_object();
}

SphericalNotes notes_on(const SphericalSolution& found, const SphericalFamily& family) {
  SphericalNotes notes;
  const MapPoint place{found.input.coordinate, found.output.coordinate};
  if (found.function) notes.orientations = family.orientations(place, found.four_bar);
  const AxisQuantity quantity = family.axis(Side::output).quantity;
  if (quantity == AxisQuantity::output_scale || quantity == AxisQuantity::pair_output)
    notes.free_value = family.axis_value(Side::output, place.output);
  return notes;
}

void write_spherical_four_bar(JsonWriter& json, const SphericalSolution& found, const SphericalNotes& notes) {
  json.begin_object();
  json.member("mechanism", "spherical_four_bar");
  json.key("input");
  write_spherical_dyad(json, found.input, found.input_residual);
  json.key("output");
  write_spherical_dyad(json, found.output, found.output_residual);
  write_angles(json, "angles_deg", found.angles);
  write_report(json, found.report);
  if (const TripleRockerKind kind = triple_rocker_kind(found.angles); kind != TripleRockerKind::none)
    json.member("triple_rocker", name(kind));
  json.key("drive");
  found.report.sense == DriveSense::none ? json.null() : json.value(name(found.report.sense));
  json.key("driver_sweep_deg");
  found.report.defects.none() ? json.value(degrees(found.report.sweep)) : json.null();
  write_transmission(json, found.report);
  json.key("min_transmission_angle_full_turn_deg");
  input_is_crank(found.report.type) ? json.value(degrees(found.report.min_transmission_angle_full_turn)) : json.null();
  json.member("residual", found.residual);
  if (found.residual_derivatives) json.member("residual_derivatives", *found.residual_derivatives);
  if (found.function) write_function_error(json, *found.function);
  json.member("local_optimum", found.local_optimum);
  json.member("verified_by_driving", found.verified_by_driving);
  notes.listed.write(json);
  if (notes.free_value) json.member("free_value", *notes.free_value);
  if (!notes.orientations.empty()) {
    json.key("orientations");
    write_fields(json, notes.orientations, on_lines);
  }
  json.key("swapped");
  json.begin_object();
  write_report(json, found.swapped);
  write_transmission(json, found.swapped);
  json.end_object();
  json.end_object();
}

}  // namespace linkwright
