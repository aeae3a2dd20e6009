#pragma once

#include <array>
#include <functional>
#include <optional>

#include "linkwright/region/hill_climb.hpp"
#include "linkwright/region/linkage_family.hpp"

namespace linkwright {

/// The two axes of a family, the one whose coordinate is dearer to change first, as a climb takes them.
class OrderedAxes {
 public:
  explicit OrderedAxes(const LinkageFamily& family)
      : family_(family), swapped_(family.costlier_side() == Side::output) {}

  [[nodiscard]] std::array<double, 2> both(double of_input, double of_output) const {
    return swapped_ ? std::array{of_output, of_input} : std::array{of_input, of_output};
  }
  [[nodiscard]] std::array<double, 2> coordinates(MapPoint place) const { return both(place.input, place.output); }
  [[nodiscard]] MapPoint place(std::array<double, 2> coordinates) const {
    return swapped_ ? MapPoint{coordinates[1], coordinates[0]} : MapPoint{coordinates[0], coordinates[1]};
  }
  /// Around a place, its scores by the ordered coordinates.
  [[nodiscard]] Hill hill(std::function<std::optional<double>(double, double)> score_at, MapPoint around) const;

 private:
  const LinkageFamily& family_;
  bool swapped_;
};

/// Range of the coordinate of the longer axis.
[[nodiscard]] double longest_axis(const LinkageFamily& family);

}  // namespace linkwright
