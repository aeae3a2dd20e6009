#pragma once

#include <array>
#include <optional>
#include <vector>

#include "robust/six_bar_distances.hpp"

namespace linkwright {

/// A six-bar made with errors: what its nominal dimensions are off by, in the order of its parameters.
using SixBarDeviations = std::array<double, SixBarDistances::most_parameters>;

/// A six-bar in one position of its task, and what it becomes there when it is made with errors.
class SixBarSolver {
 public:
  /// At a dead point no sample assembles.
  SixBarSolver(const SixBarDistances& distances, const SixBarOutput& output, std::size_t position);

  struct State {
    SixBarDistances::Joints joints{};
    Point origin, direction;  ///< of the guided frame: its origin, and along the first two hinges of its body
  };
  [[nodiscard]] const State& nominal() const { return nominal_; }
  /// The configuration that the nominal one turns into as the deviations grow; nothing where they lead to a dead point.
  [[nodiscard]] std::optional<State> made(const SixBarDeviations& deviations) const;

 private:
  static constexpr std::size_t equations = SixBarDistances::most_equations;
  using Values = std::array<double, equations>;
  using Inverse = std::array<Values, equations>;  ///< by columns, the rest zero
  using Joints = SixBarDistances::Joints;

  struct Target;
  [[nodiscard]] bool can_be_made(const SixBarDeviations& deviations) const;
  [[nodiscard]] Target target(const SixBarDeviations& deviations, double share) const;
  [[nodiscard]] Values errors(const Joints& joints, const Target& target) const;
  [[nodiscard]] bool close_by(const Inverse& inverse, Joints& joints, const Target& target) const;
  [[nodiscard]] bool close_by_newton(Joints& joints, const Target& target) const;
  [[nodiscard]] std::optional<Joints> followed(const SixBarDeviations& deviations) const;

  const SixBarDistances& distances_;
  State nominal_;
  Point arm_;  ///< of the guided frame's origin, along and across its body
  double longest_ = 0;
  bool positive_ = false;           ///< sign of the equations' determinant
  std::optional<Inverse> inverse_;  ///< at the nominal position
};

}  // namespace linkwright
