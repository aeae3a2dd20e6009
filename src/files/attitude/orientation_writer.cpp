#include "attitude/finite_rotation.hpp"
#include "linkwright/files/number_text.hpp"
#include "linkwright/files/orientation_file.hpp"
#include "space_writer.hpp"

namespace linkwright {
namespace {

using Layout = JsonWriter::Layout;

/// A member for each of the twelve sequences, by its name.
void write_sequences(JsonWriter& json, std::string_view key, const OrientationReport& report, Layout layout,
                     const std::function<void(std::string_view, const EulerDecomposition&)>& write) {
  json.key(key);
  json.begin_object(layout);
  for (const EulerDecomposition& found : report.euler) write(found.angles.sequence.name(), found);
  json.end_object();
}

void write_euler(JsonWriter& json, const OrientationReport& report) {
  write_sequences(
      json, "euler_deg", report, Layout::lines, [&](std::string_view name, const EulerDecomposition& found) {
        const EulerAngles& angles = found.angles;
        write_numbers(
            json, name,
            {degrees_for_files(angles.first), degrees_for_files(angles.second), degrees_for_files(angles.third)});
      });
  write_sequences(json, "locked", report, Layout::one_line,
                  [&](std::string_view name, const EulerDecomposition& found) {
                    json.member(name, found.singularity == Singularity::gimbal_lock);
                  });
  write_sequences(
      json, "lock_distance", report, Layout::lines,
      [&](std::string_view name, const EulerDecomposition& found) { json.member(name, found.lock_distance); });
  write_sequences(json, "determined", report, Layout::lines,
                  [&](std::string_view name, const EulerDecomposition& found) {
                    json.key(name);
                    json.begin_object(Layout::one_line);
                    json.member("combination", found.determined_sign > 0 ? "first + third" : "first - third");
                    write_angle(json, "angle_deg", found.determined);
                    json.end_object();
                  });
}

void write_tensor(JsonWriter& json, const FiniteRotation& tensor) {
  const Dyadic sum = tensor.dyadic();
  json.key("dyads");
  json.begin_list();
  for (const Dyadic::Dyad& dyad : sum.dyads()) {
    json.begin_list(Layout::one_line);
    for (const Vector3 vector : {dyad.antecedent, dyad.consequent}) {
      json.begin_list(Layout::one_line);
      for (std::size_t i = 0; i < 3; ++i) json.value(vector[i]);
      json.end_list();
    }
    json.end_list();
  }
  json.end_list();
  write_matrix(json, "matrix_minus_identity", tensor.matrix_minus_identity());
}

void write_properties(JsonWriter& json, const OrientationReport& report) {
  json.key("properties");
  json.begin_object();
  json.member("orthogonality_error", report.orthogonality_error);
  json.member("determinant", report.determinant);
  json.member("cofactor_error", report.cofactor_error);
  json.key("eigenvalue_one");
  json.begin_object(Layout::one_line);
  write_vector(json, "axis", report.eigenvalue_one.axis);
  json.member("residual", report.eigenvalue_one.residual);
  json.end_object();
  json.end_object();
}

void write_members(JsonWriter& json, const OrientationReport& report) {
  const StoredOrientation& orientation = report.task.orientation;
  write_matrix(json, "matrix", orientation.rotation.matrix());
  write_quaternion(json, "quaternion", orientation.quaternion);
  write_vector(json, "axis", report.turn.axis());
  json.member("axis_defined", report.turn.axis_defined());
  write_angle(json, "angle_deg", report.turn.angle());
  write_vector(json, "rotation_vector", report.rotation_vector.vector());
  if (report.rodrigues) {
    write_vector(json, "rodrigues", report.rodrigues->vector());
  } else {
    json.key("rodrigues");
    json.null();
  }
  write_vector(json, "mrp", report.mrp.vector());
  write_euler(json, report);
  json.key("resal");
  json.begin_object();
  write_matrix(json, "matrix", report.resal.frame.matrix());
  write_angle(json, "spin_deg", report.resal.spin);
  json.end_object();
  write_tensor(json, FiniteRotation(report.turn));
  write_properties(json, report);
  if (orientation.nearest_distance) json.member("nearest_distance", *orientation.nearest_distance);
  write_vectors(json, "vectors", report.task.vectors);
  write_vectors(json, "images", report.images);
}

}  // namespace

OrientationReport orientation_report(const OrientationTask& task) {
  const UnitQuaternion& q = task.orientation.quaternion;
  const Matrix3x3& matrix = task.orientation.rotation.matrix();
  OrientationReport report{.task = task,
                           .turn = AxisAngle::of(q),
                           .rotation_vector = RotationVector::of(q),
                           .rodrigues = RodriguesVector::of(q),
                           .mrp = ModifiedRodriguesVector::of(q),
                           .euler = {},
                           .resal = resal_frame(task.orientation.rotation),
                           .orthogonality_error = orthogonality_error(matrix),
                           .determinant = determinant(matrix),
                           .cofactor_error = cofactor_error(matrix),
                           .eigenvalue_one = eigenvalue_one(task.orientation.rotation),
                           .images = {}};
  for (const EulerSequence& sequence : EulerSequence::all()) report.euler.push_back(euler_angles(q, sequence));
  const FiniteRotation tensor(report.turn);
  for (const Vector3 vector : task.vectors) report.images.push_back(tensor.apply(vector));
  return report;
}

std::string write_orientation_report(const OrientationReport& report) {
  return attitude_file_text([&report](JsonWriter& json) { write_members(json, report); });
}

}  // namespace linkwright
