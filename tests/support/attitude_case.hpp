#pragma once

#include <map>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "linkwright/attitude/rotation.hpp"

namespace linkwright::testing {

/// A rotation of data/attitude/table.json with all its representations (data/README.md).
struct AttitudeCase {
  struct Euler {
    Vector3 angles;
    bool locked = false;
  };

  std::string name, kind;
  UnitQuaternion input;  ///< of the doubles q_in
  double w = 0;          ///< of the canonical quaternion, exact
  Vector3 v;
  Matrix3x3 matrix;
  std::optional<Vector3> axis;
  double angle = 0;
  std::optional<Vector3> rodrigues;
  Vector3 mrp;
  std::map<std::string, Euler> euler;
};

[[nodiscard]] const std::vector<AttitudeCase>& attitude_cases();

/// Uniform over all rotations.
[[nodiscard]] UnitQuaternion random_rotation(std::mt19937_64& random);
/// Uniform over all directions.
[[nodiscard]] Vector3 random_direction(std::mt19937_64& random);

/// One ulp of 1.
inline constexpr double ulp = 0x1p-52;

/// The largest difference of two components, in ulps of 1; infinite if one is not a number.
[[nodiscard]] double ulps_between(double a, double b);
[[nodiscard]] double ulps_between(Vector3 a, Vector3 b);
[[nodiscard]] double ulps_between(const Matrix3x3& a, const Matrix3x3& b);
[[nodiscard]] double ulps_between(const Rotation& a, const Rotation& b);
/// Of q and −q the nearer.
[[nodiscard]] double ulps_between(const UnitQuaternion& a, const UnitQuaternion& b);
/// Of two angles, whole turns apart or not.
[[nodiscard]] double ulps_between_angles(double a, double b);

}  // namespace linkwright::testing
