#include "attitude/rotation_step.hpp"
#include "linkwright/files/angular_motion_file.hpp"
#include "linkwright/files/number_text.hpp"
#include "space_writer.hpp"

namespace linkwright {
namespace {

using Layout = JsonWriter::Layout;

void write_angles(JsonWriter& json, std::string_view key, const std::array<double, 3>& angles) {
  write_numbers(json, key, {degrees_for_files(angles[0]), degrees_for_files(angles[1]), degrees_for_files(angles[2])});
}

void write_sequence_rates(JsonWriter& json, const SequenceRates& sequence) {
  const EulerAngles& angles = sequence.angles;
  write_angles(json, "angles_deg", {angles.first, angles.second, angles.third});
  write_angles(json, "rates_deg", sequence.fit.rates.rates);
  write_angles(json, "accelerations_deg", sequence.fit.rates.accelerations);
  json.member("locked", sequence.fit.singularity == Singularity::gimbal_lock);
  json.member("lock_distance", sequence.fit.lock_distance);
  json.member("velocity_residual", sequence.fit.velocity_residual);
  json.member("acceleration_residual", sequence.fit.acceleration_residual);
}

void write_motion(JsonWriter& json, std::string_view key, const AngularMotion& motion) {
  json.key(key);
  json.begin_object();
  write_vector(json, "velocity", motion.velocity);
  write_vector(json, "acceleration", motion.acceleration);
  write_matrix(json, "velocity_matrix", angular_velocity_matrix(motion.velocity));
  write_matrix(json, "acceleration_matrix", angular_acceleration_matrix(motion));
  json.end_object();
}

void write_quaternion_rate(JsonWriter& json, std::string_view key, const QuaternionRate& rate) {
  write_numbers(json, key, {rate.w, rate.v.x, rate.v.y, rate.v.z});
}

void write_point(JsonWriter& json, const PointMotion& point, const AccelerationParts& parts) {
  json.begin_object();
  write_vector(json, "position", point.position);
  write_vector(json, "velocity", point.velocity);
  write_vector(json, "acceleration", point.acceleration);
  json.key("acceleration_parts");
  json.begin_object();
  write_vector(json, "of_origin", parts.of_origin);
  write_vector(json, "tangential", parts.tangential);
  write_vector(json, "centripetal", parts.centripetal);
  write_vector(json, "coriolis", parts.coriolis);
  write_vector(json, "relative", parts.relative);
  json.end_object();
  json.end_object();
}

void write_sequences(JsonWriter& json, const AngularMotionReport& report) {
  json.key("euler");
  json.begin_object();
  for (const SequenceRates& sequence : report.euler) {
    json.key(sequence.angles.sequence.name());
    json.begin_object();
    write_sequence_rates(json, sequence);
    json.end_object();
  }
  json.end_object();
  if (!report.given) return;
  json.key("given_angles");
  json.begin_object();
  json.member("sequence", std::string_view(report.given->angles.sequence.name()));
  json.member("turning", report.given->angles.sequence.turning() == Turning::intrinsic ? "intrinsic" : "extrinsic");
  write_sequence_rates(json, *report.given);
  json.end_object();
}

void write_members(JsonWriter& json, const AngularMotionReport& report) {
  write_matrix(json, "matrix", report.task.orientation.rotation.matrix());
  write_quaternion(json, "quaternion", report.task.orientation.quaternion);
  write_motion(json, "fixed", report.task.in_i);
  write_motion(json, "moving", report.in_j);
  json.member("velocity_defect", report.task.velocity_defect);
  json.member("acceleration_defect", report.task.acceleration_defect);
  write_matrix(json, "matrix_first", report.derivatives.first);
  write_matrix(json, "matrix_second", report.derivatives.second);
  write_quaternion_rate(json, "quaternion_first", report.quaternion_first);
  write_quaternion_rate(json, "quaternion_second", report.quaternion_second);
  write_sequences(json, report);
  json.key("points");
  json.begin_list();
  for (std::size_t i = 0; i < report.points.size(); ++i) write_point(json, report.points[i], report.parts[i]);
  json.end_list();
  if (!report.after || !report.task.step) return;
  json.key("after_step");
  json.begin_object();
  json.member("step", *report.task.step);
  write_matrix(json, "matrix", report.after->matrix());
  write_quaternion(json, "quaternion", *report.after);
  json.end_object();
}

Result<SequenceRates> sequence_rates(const EulerAngles& angles, const AngularMotion& in_i) {
  const auto fit = euler_rates(angles, in_i);
  return fit ? Result<SequenceRates>(SequenceRates{angles, *fit}) : Result<SequenceRates>(fit.errors());
}

}  // namespace

Result<AngularMotionReport> angular_motion_report(const AngularMotionTask& task) {
  const Rotation& c = task.orientation.rotation;
  const UnitQuaternion q = task.orientation.quaternion.canonical();
  const AngularMotion& in_i = task.in_i;
  AngularMotionReport report{
      .task = task,
      .in_j = {c.apply_inverse(in_i.velocity), c.apply_inverse(in_i.acceleration)},
      .derivatives = rotation_derivatives(c, in_i),
      .quaternion_first = quaternion_rate(q, in_i.velocity),
      .quaternion_second = quaternion_acceleration(q, in_i),
      .euler = {},
      .given = {},
      .points = {},
      .parts = {},
      .after = {},
  };
  for (const EulerSequence& sequence : EulerSequence::all()) {
    const auto rates = sequence_rates(euler_angles(q, sequence).angles, in_i);
    if (!rates) return rates.errors();
    report.euler.push_back(*rates);
  }
  if (task.orientation.euler) {
    const auto rates = sequence_rates(*task.orientation.euler, in_i);
    if (!rates) return rates.errors();
    report.given = *rates;
  }
  const BodyMotion body{c, in_i, task.origin};
  for (const PointMotion& point : task.points) {
    report.points.push_back(point_motion(body, point));
    report.parts.push_back(acceleration_parts(body, point));
  }
  if (task.step) {
    const auto after = rotation_step(q, in_i.velocity, *task.step);
    if (!after) return after.errors();
    report.after = *after;
  }
  return report;
}

std::string write_angular_motion_report(const AngularMotionReport& report) {
  return attitude_file_text([&report](JsonWriter& json) { write_members(json, report); });
}

}  // namespace linkwright
