#pragma once

#include <cstdint>
#include <span>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/pose.hpp"

namespace linkwright {

/// In which senses a grounded link, turning as the driver, meets the poses in order within one turn; it does not
/// depend on the rest of the linkage.
struct DriverSequence {
  static constexpr std::uint8_t ccw_bit = 1, cw_bit = 2;

  bool ccw = false, cw = false;
  double sweep_ccw = 0;  ///< angle from the first to the last pose turning counter-clockwise, radians in [0, 2π)

  /// The same turning clockwise, radians in [0, 2π).
  [[nodiscard]] double sweep_cw() const { return sweep_ccw > 0 ? two_pi - sweep_ccw : 0; }
  /// Half a turn or more, turning that way.
  [[nodiscard]] bool is_at_least_half_turn_ccw() const { return sweep_ccw >= pi; }
  [[nodiscard]] bool is_at_least_half_turn_cw() const { return sweep_cw() >= pi; }

  /// The senses as bits, and those of which it is half a turn or more.
  [[nodiscard]] std::uint8_t senses() const { return bits(ccw, cw); }
  [[nodiscard]] std::uint8_t half_turn_senses() const {
    return bits(is_at_least_half_turn_ccw(), is_at_least_half_turn_cw());
  }

 private:
  static std::uint8_t bits(bool is_ccw, bool is_cw) {
    return static_cast<std::uint8_t>((is_ccw ? ccw_bit : 0) | (is_cw ? cw_bit : 0));
  }
};

/// Put together position by position, in the order to be visited.
class DriverSequenceBuilder {
 public:
  /// The driver has turned by `angle` from the first position, counter-clockwise, radians in [0, 2π); the first: 0.
  void meet(double angle);
  /// It is to pass the position met last in the sense of this rate.
  void pass(double rate);
  [[nodiscard]] const DriverSequence& sequence() const { return sequence_; }

 private:
  DriverSequence sequence_{true, true, 0};
  bool is_first_ = true;
};

/// `circle` moves with the body and lies as in the first pose; `poses` in the order to be visited. With
/// `respect_direction`, a pose with derivatives is passed in the direction of its first one.
[[nodiscard]] DriverSequence driver_sequence(Point center, Point circle, std::span<const PrescribedPose> poses,
                                             bool respect_direction);

}  // namespace linkwright
