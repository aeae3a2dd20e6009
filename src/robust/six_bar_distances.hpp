#pragma once

#include <array>
#include <optional>
#include <vector>

#include "algebra/dense.hpp"
#include "linkwright/mechanism/six_bar.hpp"
#include "linkwright/mechanism/six_bar_position.hpp"
#include "linkwright/robust/made_dimension.hpp"

namespace linkwright {

/// A six-bar as the distances between the hinges of its moving bodies and the driver's direction: as many equations as
/// the moving hinges have coordinates.
class SixBarDistances {
 public:
  static constexpr int most_equations = 10, most_parameters = 16;
  using Joints = std::array<Point, SixBar::joint_count>;

  explicit SixBarDistances(const SixBar& six_bar);

  [[nodiscard]] const std::vector<SixBarLength>& lengths() const { return lengths_; }
  [[nodiscard]] const std::vector<std::size_t>& ground() const { return ground_; }
  [[nodiscard]] const std::vector<std::size_t>& moving() const { return moving_; }
  /// Of the moving bodies with three hinges: where their three lengths begin.
  [[nodiscard]] const std::vector<std::size_t>& triangles() const { return triangles_; }
  /// The first two hinges of the guided body.
  [[nodiscard]] std::array<std::size_t, 2> guided() const { return guided_; }
  /// Of a linkage; after the lengths and pivots that is two of the point and the driver.
  [[nodiscard]] std::size_t parameters() const { return lengths_.size() + 2 * ground_.size() + 3; }
  [[nodiscard]] std::size_t equations() const { return 2 * moving_.size(); }

  /// Derivatives of the equations by the coordinates of some hinges: a row for each length, of that length's own size,
  /// and one for the driver's angle, as a length at b.
  [[nodiscard]] SmallMatrix jacobian(const Joints& joints, const std::vector<std::size_t>& by) const;
  /// Inverse of jacobian() by the moving hinges; nothing at a dead point, nor where a ternary body is flat.
  [[nodiscard]] std::optional<SmallMatrix> inverse(const Joints& joints) const;

 private:
  std::vector<SixBarLength> lengths_;
  std::vector<std::size_t> ground_, moving_, triangles_;
  std::array<std::size_t, 2> guided_{};
};

/// Columns in the order of the parameters: lengths, both coordinates of each ground pivot, point along and across,
/// driver; components as those of planar poses. Nothing where a position has no inverse().
[[nodiscard]] std::optional<SensitivityMatrix> six_bar_sensitivities(const SixBarOutput& output);

}  // namespace linkwright
