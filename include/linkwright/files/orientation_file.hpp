#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "linkwright/attitude/axis_angle.hpp"
#include "linkwright/attitude/euler_angles.hpp"
#include "linkwright/attitude/rodrigues.hpp"
#include "linkwright/attitude/rotation.hpp"
#include "linkwright/attitude/rotation_vector.hpp"
#include "linkwright/core/result.hpp"

namespace linkwright {

/// An orientation as a file gives it. Angles in radians here, degrees in the file.
struct StoredOrientation {
  Rotation rotation;                       ///< C_ij: the frame j that is given, in the fixed frame i
  UnitQuaternion quaternion;               ///< q_ij; of small turns it knows more than the matrix does
  std::optional<AxisAngle> turn;           ///< where it was given by axis and angle: the angle as given, of any size
  std::optional<EulerAngles> euler;        ///< where it was given by three angles: as given
  std::optional<double> nearest_distance;  ///< where the nearest rotation to a noisy matrix was asked for: how near
};

/// What `linkwright attitude convert` reads: schema/attitude.schema.json.
struct OrientationTask {
  StoredOrientation orientation;
  std::vector<Vector3> vectors;  ///< to be turned, in the fixed frame
};

/// `{"linkwright": 1, "orientation": {…}, "vectors": [[x, y, z], …]}`, the vectors optional; the orientation is one of
/// `matrix` (with `nearest: true` any matrix, else a rotation to 1e-6), `axis` with `angle_deg`, `quaternion`
/// [w, x, y, z], `rotation_vector` (radians), `rodrigues`, `mrp`, `euler_deg` with `sequence` and optionally `turning`,
/// `turns` (a list of axes with angles, each about axes carried along by those before), `triads` (the axes of both
/// frames in a third). All mistakes are reported, each with its place.
[[nodiscard]] Result<OrientationTask> read_orientation_task(std::string_view text);

/// An orientation in every representation.
struct OrientationReport {
  OrientationTask task;
  AxisAngle turn;  ///< by at most π
  RotationVector rotation_vector;
  std::optional<RodriguesVector> rodrigues;  ///< none for a half-turn
  ModifiedRodriguesVector mrp;
  std::vector<EulerDecomposition> euler;  ///< twelve, intrinsic, in the order of EulerSequence::all()
  ResalFrame resal;
  double orthogonality_error = 0, determinant = 0, cofactor_error = 0;  ///< of the matrix
  EigenvalueOne eigenvalue_one;
  std::vector<Vector3> images;  ///< of the task's vectors, by the tensor of finite rotation
};

[[nodiscard]] OrientationReport orientation_report(const OrientationTask& task);

/// The report as JSON text; its `quaternion` reads back as the same orientation.
[[nodiscard]] std::string write_orientation_report(const OrientationReport& report);

}  // namespace linkwright
