#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "linkwright/attitude/angular_motion.hpp"
#include "linkwright/attitude/euler_rates.hpp"
#include "linkwright/attitude/point_motion.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/files/orientation_file.hpp"

namespace linkwright {

/// What `linkwright attitude rates` reads: schema/attitude.schema.json. Angles in radians here; in the file angular
/// velocity and acceleration are in radians, rates of angles with `_deg` in degrees, per unit of time.
struct AngularMotionTask {
  StoredOrientation orientation;    ///< C_ij
  AngularMotion in_i;               ///< of frame j against i, in i
  double velocity_defect = 0;       ///< of derivatives that were given: how far they are from being those of a rotation
  double acceleration_defect = 0;   ///< the same for the second ones
  PointMotion origin;               ///< of the origin of j, in i
  std::vector<PointMotion> points;  ///< in the body, by coordinates in j
  std::optional<double> step;       ///< a time after which the attitude is asked for, at constant ω
};

/// `{"linkwright": 1, "orientation": {…}, "motion": {…}, "origin": {…}, "points": [{…}, …], "step": dt}`; all but
/// orientation and motion optional. The motion is one of `velocity` and `acceleration` (vectors, radians; `frame`
/// "fixed" (default) or "moving"), `matrix_first` and `matrix_second` (derivatives of C_ij), `quaternion_first` and
/// `quaternion_second`, `euler_rates_deg` and `euler_accelerations_deg` (of an orientation by `euler_deg`); the second
/// of each may be missing: a zero acceleration, or of derivatives, one that is ignored. Points and origin have
/// `position`, `velocity`, `acceleration`, what is missing being 0.
[[nodiscard]] Result<AngularMotionTask> read_angular_motion_task(std::string_view text);

/// The rates of the angles of one sequence.
struct SequenceRates {
  EulerAngles angles;
  EulerRatesFit fit;
};

/// An angular motion in every representation.
struct AngularMotionReport {
  AngularMotionTask task;
  AngularMotion in_j;
  RotationDerivatives derivatives;
  QuaternionRate quaternion_first, quaternion_second;  ///< of the canonical quaternion
  std::vector<SequenceRates> euler;                    ///< twelve, in the order of EulerSequence::all()
  std::optional<SequenceRates> given;                  ///< of the angles by which the orientation was given, if it was
  std::vector<PointMotion> points;                     ///< in i
  std::vector<AccelerationParts> parts;                ///< of their accelerations
  std::optional<UnitQuaternion> after;                 ///< the attitude after the step
};

/// Errors: `not_finite` where rates are larger than numbers reach.
[[nodiscard]] Result<AngularMotionReport> angular_motion_report(const AngularMotionTask& task);

[[nodiscard]] std::string write_angular_motion_report(const AngularMotionReport& report);

}  // namespace linkwright
