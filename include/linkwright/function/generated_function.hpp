#pragma once

#include <functional>
#include <optional>
#include <span>

#include "linkwright/function/wanted_function.hpp"
#include "linkwright/mechanism/position.hpp"

namespace linkwright {

/// The output that a driven linkage generates, by forward kinematics alone: it stands at the first pair and is driven
/// from there, without being taken apart. Angles in radians on the task's dials.
class GeneratedFunction {
 public:
  /// The output angle at an input angle, both counted from where the linkage has its zeros; nothing where the input
  /// cannot be.
  using ForwardKinematics = std::function<std::optional<double>(double input_angle)>;
  /// Angles of a linkage, counted like those of its forward kinematics.
  struct Start {
    double input_angle = 0, output_angle = 0;
  };

  /// A linkage that stands at `first` when its angles are those of `start`; `ranges`: where its input can be.
  GeneratedFunction(ForwardKinematics output_angle, Start start, std::span<const AngleRange> ranges,
                    const AnglePair& first);

  /// Output at an input angle (modulo whole turns), the one nearest to `near`; nothing where the drive does not get
  /// there.
  [[nodiscard]] std::optional<double> output_at(double input, double near) const;

  /// The inputs that the drive reaches, around that of the first pair; a whole turn for a crank. Empty (from = to) for
  /// links that are none.
  [[nodiscard]] AngleRange reach() const { return reach_; }

 private:
  ForwardKinematics output_angle_;
  AngleRange reach_;
  double input_offset_ = 0, output_offset_ = 0;  ///< the linkage's angle less the dial's
};

}  // namespace linkwright
