#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "linkwright/core/result.hpp"

// How the driver of a loaded linkage moves in time from position 1 to the last one: told by the share of its turn,
// 0 to 1. Seconds.
namespace linkwright {

/// A time law of the driver. All but `uniform` start and end at rest.
struct DriverMotion {
  enum class Law : std::uint8_t {
    uniform,         ///< one speed, reached before position 1 and kept beyond the last one
    trapezoid,       ///< speed rises and falls evenly, with one speed between
    cycloid,         ///< s = τ − sin(2πτ)/2π: acceleration without jumps
    polynomial_345,  ///< s = 10τ³ − 15τ⁴ + 6τ⁵: likewise
    table            ///< a cubic spline through given shares at given times
  };
  struct TimedShare {
    double time = 0, share = 0;
    friend bool operator==(const TimedShare&, const TimedShare&) = default;
  };
  Law law = Law::cycloid;
  double duration = 1;    ///< s, in (0, longest_motion]; of a table its last time
  double ramp = 1.0 / 3;  ///< of a trapezoid: share of the duration to speed up, and as long to slow down, (0, 1/2]
  std::vector<TimedShare> table;  ///< of that law, from (0, 0) to (duration, 1), both ascending

  friend bool operator==(const DriverMotion&, const DriverMotion&) = default;
};
inline constexpr std::array<std::string_view, 5> driver_law_names = {"uniform", "trapezoid", "cycloid", "3-4-5",
                                                                     "table"};
[[nodiscard]] inline std::string_view name(DriverMotion::Law law) {
  return driver_law_names[static_cast<std::size_t>(law)];
}
inline constexpr double longest_motion = 1e6, shortest_motion = 1e-6;
inline constexpr std::size_t most_timed_shares = 200;

/// The caller's mistakes; places begin with `loads.motion`.
[[nodiscard]] std::vector<Error> mistakes_in(const DriverMotion& motion);

/// Where the driver is at some time.
struct DriverState {
  double time = 0;          ///< s
  double share = 0;         ///< of the turn
  double speed = 0;         ///< of the share, 1/s
  double acceleration = 0;  ///< of the share, 1/s²; at an end of the motion that within it, at a jump one of both
};

/// A motion without mistakes. The share rises with the time.
class TimeLaw {
 public:
  explicit TimeLaw(const DriverMotion& motion);

  [[nodiscard]] double duration() const { return duration_; }
  /// `time` in [0, duration()]; beyond, as at the end.
  [[nodiscard]] DriverState at_time(double time) const;
  /// `share` in [0, 1]; beyond, as at the end. The time is found to rounding.
  [[nodiscard]] DriverState at_share(double share) const;

 private:
  DriverMotion::Law law_;
  double duration_, ramp_;
  std::vector<DriverMotion::TimedShare> table_;
  std::vector<double> speeds_;  ///< at the times of the table
};

}  // namespace linkwright
