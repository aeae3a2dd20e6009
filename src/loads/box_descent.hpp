#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace linkwright {

/// Least squares over four numbers in a box.
class BoxDescent {
 public:
  static constexpr std::size_t unknowns = 4;
  using Place = std::array<double, unknowns>;
  /// The residuals at a place, as many everywhere.
  using Residuals = std::function<std::vector<double>(const Place&)>;

  /// `size`: by which steps are small.
  BoxDescent(Place low, Place high, double size, Residuals residuals);

  struct Found {
    Place at{};
    double square = 0;
  };
  [[nodiscard]] double square_at(const Place& at) const;
  /// The best of `along` places along each side that has a length, best first, at most `most` of them.
  [[nodiscard]] std::vector<Found> best_of_grid(int along, std::size_t most) const;
  /// Levenberg's and Marquardt's steps, cut off at the box; unknowns that press against it rest.
  [[nodiscard]] Found descend(const Place& from) const;

 private:
  using Matrix = std::array<std::array<double, unknowns>, unknowns>;
  struct Slope {
    Matrix normal{};
    Place gradient{};
  };
  [[nodiscard]] Place within(Place at) const;
  [[nodiscard]] Slope slope_at(const Place& at, const std::vector<double>& here) const;
  [[nodiscard]] Place step_of(const Slope& slope, const Place& at, double damping) const;

  Place low_, high_;
  double size_;
  Residuals residuals_;
};

}  // namespace linkwright
