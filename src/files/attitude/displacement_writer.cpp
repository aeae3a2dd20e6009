#include "linkwright/files/displacement_file.hpp"
#include "screw_writer.hpp"
#include "space_writer.hpp"

namespace linkwright {

std::string_view name(ScrewKind kind) {
  switch (kind) {
    case ScrewKind::identity:
      return "identity";
    case ScrewKind::pure_translation:
      return "pure_translation";
    case ScrewKind::half_turn:
      return "half_turn";
    case ScrewKind::general:
      break;
  }
  return "general";
}

void write_screw(JsonWriter& json, const Screw& screw) {
  const bool one_axis = screw.kind == ScrewKind::general || screw.kind == ScrewKind::half_turn;
  json.member("kind", name(screw.kind));
  write_vector(json, "axis", screw.direction);
  json.member("axis_defined", screw.kind != ScrewKind::identity);
  if (one_axis) {
    write_vector(json, "point", screw.point);
  } else {
    json.key("point");
    json.null();
  }
  write_angle(json, "angle_deg", screw.angle);
  json.member("slide", screw.translation);
  json.key("pitch");
  const auto pitch = screw.pitch();
  pitch ? json.value(*pitch) : json.null();
}

namespace {

void write_members(JsonWriter& json, const DisplacementReport& report) {
  const Displacement& displacement = report.task.displacement;
  json.member("length_unit", std::string_view(report.task.length_unit));
  write_matrix(json, "matrix", displacement.matrix());
  write_matrix(json, "inverse", displacement.inverse().matrix());
  write_quaternion(json, "quaternion", displacement.rotation.quaternion());
  write_vector(json, "translation", displacement.translation);
  json.key("screw");
  json.begin_object();
  write_screw(json, report.screw);
  json.end_object();
  write_vectors(json, "points", report.task.points);
  write_vectors(json, "displaced_points", report.displaced_points);
  write_vectors(json, "directions", report.task.directions);
  write_vectors(json, "displaced_directions", report.displaced_directions);
}

}  // namespace

Result<DisplacementReport> displacement_report(const DisplacementTask& task) {
  const auto screw = screw_of(task.displacement, task.small_turns_exact ? 0 : tolerance::no_turn);
  if (!screw) {
    Error error = screw.errors().front();
    error.place = "displacement";
    return error;
  }
  DisplacementReport report{.task = task, .screw = *screw, .displaced_points = {}, .displaced_directions = {}};
  for (const Vector3 point : task.points) {
    report.displaced_points.push_back(task.displacement.apply_to_point(point));
  }
  for (const Vector3 direction : task.directions) {
    report.displaced_directions.push_back(task.displacement.apply_to_direction(direction));
  }
  return report;
}

std::string write_displacement_report(const DisplacementReport& report) {
  return attitude_file_text([&report](JsonWriter& json) { write_members(json, report); });
}

}  // namespace linkwright
