#pragma once

#include <vector>

#include "linkwright/mechanism/positions.hpp"

namespace linkwright {

/// One derivative of input and output angle by any parameter that increases along the task (radians per its power).
struct AngleDerivative {
  double input = 0, output = 0;

  friend bool operator==(const AngleDerivative&, const AngleDerivative&) = default;
};

/// A precision point: while the input link stands at one angle the output link stands at the other (radians,
/// counter-clockwise, each from a datum of its own), and the first, second, … derivatives there. With m derivatives it
/// counts as m + 1 positions.
struct AnglePair {
  double input = 0, output = 0;
  std::vector<AngleDerivative> derivatives;

  /// How many infinitesimally close positions it counts as, ≥ 1.
  [[nodiscard]] int multiplicity() const { return 1 + static_cast<int>(derivatives.size()); }

  friend bool operator==(const AnglePair&, const AnglePair&) = default;
};

}  // namespace linkwright
