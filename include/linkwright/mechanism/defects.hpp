#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/linkage_type.hpp"
#include "linkwright/mechanism/pose.hpp"

namespace linkwright {

/// Why a four-bar that passes through the positions does not do the task (bits as in region maps).
/// Branch is set whenever circuit is; order is decided, and set, only where there is no branch defect.
struct Defects {
  std::uint8_t bits = 0;

  static constexpr std::uint8_t order_bit = 1, branch_bit = 2, circuit_bit = 4;
  [[nodiscard]] bool order() const { return bits & order_bit; }
  [[nodiscard]] bool branch() const { return bits & branch_bit; }
  [[nodiscard]] bool circuit() const { return bits & circuit_bit; }
  [[nodiscard]] bool none() const { return bits == 0; }
  friend bool operator==(Defects, Defects) = default;
};

/// Sense in which the input passes the positions in order: counter-clockwise, clockwise, either (both senses do), none.
enum class DriveSense : std::uint8_t { none, ccw, cw, either };
[[nodiscard]] std::string_view name(DriveSense sense);  ///< "ccw", "cw", "either"; empty for none
/// Of the senses in which all positions come in order.
[[nodiscard]] DriveSense drive_sense(bool ccw, bool cw);

/// Order, branch and circuit of one four-bar, driven by its input, over one task.
struct DefectReport {
  LinkageType type = LinkageType::degenerate;
  Defects defects;
  DriveSense sense = DriveSense::none;  ///< none where a defect is present
  /// Least transmission angle over the travel from the first to the last position, in the better sense, radians; 0
  /// where a defect is present.
  double min_transmission_angle = 0;
  /// The same over a full turn of a crank; 0 for other types.
  double min_transmission_angle_full_turn = 0;
  double sweep = 0;  ///< angle the input turns from the first to the last position, radians > 0; 0 with a defect
};

/// Sign tests of Chase & Mirth, "Circuits and branches of single-degree-of-freedom planar linkages" (1993), in the
/// closed form of docs/theory/planar.md: no trigonometry, no driving. `poses`: distinct poses in the order to be
/// visited, the first being the one in which `four_bar` is given; with `respect_direction`, a pose with derivatives
/// must be passed in the direction of its first one.
[[nodiscard]] DefectReport find_defects(const FourBar& four_bar, std::span<const PrescribedPose> poses,
                                        bool respect_direction = true);

}  // namespace linkwright
