#include "linkwright/files/twist_file.hpp"
#include "space_writer.hpp"

namespace linkwright {
namespace {

std::string_view name(TwistKind kind) {
  switch (kind) {
    case TwistKind::rest:
      return "rest";
    case TwistKind::translation:
      return "translation";
    case TwistKind::rotation:
      return "rotation";
    case TwistKind::screw:
      break;
  }
  return "screw";
}

void write_instantaneous_screw(JsonWriter& json, const InstantaneousScrew& screw) {
  const bool one_axis = screw.kind == TwistKind::rotation || screw.kind == TwistKind::screw;
  json.member("kind", name(screw.kind));
  write_vector(json, "axis", screw.direction);
  json.member("axis_defined", screw.kind != TwistKind::rest);
  if (one_axis) {
    write_vector(json, "point", screw.point);
  } else {
    json.key("point");
    json.null();
  }
  json.member("rate", screw.rate);
  json.member("slide_rate", screw.slide_rate);
  json.key("pitch");
  const auto pitch = screw.pitch();
  pitch ? json.value(*pitch) : json.null();
}

void write_twist_members(JsonWriter& json, const TwistReport& report) {
  json.member("length_unit", std::string_view(report.task.length_unit));
  write_vector(json, "angular_velocity", report.task.twist.angular);
  write_vector(json, "velocity_of_origin", report.task.twist.velocity);
  json.key("screw");
  json.begin_object();
  write_instantaneous_screw(json, report.screw);
  json.end_object();
  write_vectors(json, "points", report.task.points);
  write_vectors(json, "velocities", report.velocities);
}

}  // namespace

Result<TwistReport> twist_report(const TwistTask& task) {
  const auto screw = instantaneous_screw(task.twist);
  if (!screw) return screw.errors();
  TwistReport report{.task = task, .screw = *screw, .velocities = {}};
  for (const Vector3 point : task.points) report.velocities.push_back(task.twist.velocity_at(point));
  return report;
}

std::string write_twist_report(const TwistReport& report) {
  return attitude_file_text([&report](JsonWriter& json) { write_twist_members(json, report); });
}

}  // namespace linkwright
