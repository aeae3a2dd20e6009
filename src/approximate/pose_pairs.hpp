#pragma once

#include <span>
#include <vector>

#include "approximate/body_linkage.hpp"
#include "approximate/fit_limits.hpp"
#include "approximate/pose_field.hpp"

namespace linkwright {

struct PosePair {
  BodyLinkage linkage;
  double score = 0;  ///< weighted sum of squared displacements, to first order
};

/// What a dyad asks of a body at each of some poses: how far its link is from having its length there, and the gradient
/// of that.
class DyadAtPoses {
 public:
  DyadAtPoses(const BodyDyad& dyad, std::span<const BodyPose> poses, double turning_length);

  [[nodiscard]] const BodyDyad& dyad() const { return dyad_; }
  /// Sum of squares of the least displacements that let two dyads hold the body at once: to first order, in closed
  /// form.
  [[nodiscard]] static double square_error(const DyadAtPoses& a, const DyadAtPoses& b, std::span<const double> weights);

 private:
  struct AtPose {
    double error;
    BodyMove gradient;
    double square;
  };
  BodyDyad dyad_;
  std::vector<AtPose> at_;
};

[[nodiscard]] BodyLinkage linkage_of(const BodyDyad& input, const BodyDyad& output);

/// All pairs of the dyads that keep lengths and ratio, best first, `count` at most, none near another.
[[nodiscard]] std::vector<PosePair> best_pairs(std::span<const DyadAtPoses> dyads, std::span<const double> weights,
                                               const FitLimits& limits, std::size_t count);

}  // namespace linkwright
