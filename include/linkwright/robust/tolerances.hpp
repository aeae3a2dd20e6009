#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "linkwright/core/result.hpp"

namespace linkwright {

/// How a dimension is spread over its tolerance.
enum class ToleranceDistribution : std::uint8_t {
  normal,            ///< half tolerance T = 3σ
  truncated_normal,  ///< the same, parts beyond ± T sorted out
  uniform            ///< evenly over ± T
};
/// Key in problem files: "normal", "truncated_normal", "uniform".
[[nodiscard]] std::string_view name(ToleranceDistribution distribution);
/// Nothing where there is none of that name.
[[nodiscard]] std::optional<ToleranceDistribution> tolerance_distribution_named(std::string_view name);
/// σ over T.
[[nodiscard]] double standard_deviation(ToleranceDistribution distribution);

/// Half tolerances of the lengths of a planar four-bar with a point of its coupler, user's unit, ≥ 0.
struct LengthTolerances {
  double input = 0, coupler = 0, output = 0;
  double ground_pivots = 0;  ///< of each coordinate of each
  double point = 0;          ///< of each coordinate in the coupler

  [[nodiscard]] static LengthTolerances all(double tolerance) {
    return {tolerance, tolerance, tolerance, tolerance, tolerance};
  }
  friend bool operator==(const LengthTolerances&, const LengthTolerances&) = default;
};

/// An error that a sample may not exceed at any position to be good.
struct ToleranceLimit {
  enum class Kind : std::uint8_t {
    position,  ///< distance of the body's origin, user's unit
    angle,     ///< of the body or the output, radians
    deviation  ///< distance from the line, user's unit
  };
  Kind kind = Kind::position;
  double value = 0;

  friend bool operator==(const ToleranceLimit&, const ToleranceLimit&) = default;
};

/// How exactly a linkage is made, and how it is judged: half tolerances, all independent.
struct Tolerances {
  LengthTolerances length;
  double clearance = 0;   ///< radius, user's unit: how far a pin can move in its hole, any way
  double driver = 0;      ///< of the input's angle, radians
  double link_angle = 0;  ///< of each arc of a spherical four-bar, radians
  ToleranceDistribution distribution = ToleranceDistribution::normal;  ///< of all but clearance

  std::optional<double> turning_length;  ///< by which an angle is multiplied to be weighed against a distance
  std::optional<ToleranceLimit> limit;
  std::optional<double> cost_exponent;  ///< k > 0: a tolerance T costs T^−k
  int samples = 100'000;
  std::uint64_t seed = 1;

  friend bool operator==(const Tolerances&, const Tolerances&) = default;
};

/// Numbers of samples that can be asked for, and the largest seed: numbers of problem files are exact up to there.
inline constexpr int least_samples = 1000, most_samples = 10'000'000;
inline constexpr std::uint64_t largest_seed = (std::uint64_t{1} << 53) - 1;
/// All of them; places as in problem files, `tolerances.…`.
[[nodiscard]] std::vector<Error> mistakes_in(const Tolerances& tolerances);

/// What is made with a tolerance. Planar four-bars: links, coordinates of the ground pivots, of the point along and
/// across the coupler, angle of the input.
enum class PlanarParameter : std::uint8_t {
  input,
  coupler,
  output,
  input_center_x,
  input_center_y,
  output_center_x,
  output_center_y,
  point_along,
  point_across,
  driver
};
inline constexpr std::size_t planar_parameters = 10;
[[nodiscard]] std::string_view name(PlanarParameter parameter);
/// Spherical ones: arcs, and the angle of the input; radians.
enum class SphericalParameter : std::uint8_t { input, coupler, output, ground, driver };
inline constexpr std::size_t spherical_parameters = 5;
[[nodiscard]] std::string_view name(SphericalParameter parameter);

/// A number to each parameter, in the order of the enumeration.
using PlanarValues = std::array<double, planar_parameters>;
using SphericalValues = std::array<double, spherical_parameters>;

/// Half tolerances as they are given, clearance left out.
[[nodiscard]] PlanarValues planar_half_tolerances(const Tolerances& tolerances);
[[nodiscard]] SphericalValues spherical_half_tolerances(const Tolerances& tolerances);

/// How far each parameter can be off: half tolerances, and both clearances of a link at their worst.
[[nodiscard]] PlanarValues planar_reach(const Tolerances& tolerances);

/// σ² of each parameter. A pin lies anywhere in its clearance, evenly over the disc; along the link, which alone counts
/// to first order, its variance is c²/4, and each moving link has two.
[[nodiscard]] PlanarValues planar_variances(const Tolerances& tolerances);
[[nodiscard]] SphericalValues spherical_variances(const Tolerances& tolerances);

}  // namespace linkwright
