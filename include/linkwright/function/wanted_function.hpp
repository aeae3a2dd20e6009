#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "linkwright/core/result.hpp"
#include "linkwright/function/named_function.hpp"
#include "linkwright/mechanism/pose.hpp"

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

/// A parameter of a function task that is left open: the second axis of the map.
struct FreeParameter {
  enum class Kind : std::uint8_t {
    output_scale,  ///< factor s > 0 on the output's travel: ψⱼ − ψ₁ becomes s(ψⱼ − ψ₁); spaced by its logarithm
    pair_output,  ///< output angle of one pair, radians
  };
  Kind kind = Kind::output_scale;
  std::array<double, 2> range = {0.5, 2};  ///< low first
  std::size_t pair = 0;                    ///< of pair_output

  /// The value at t ∈ [0, 1] of the range, and back.
  [[nodiscard]] double at(double t) const;
  [[nodiscard]] double place_of(double value) const;

  friend bool operator==(const FreeParameter&, const FreeParameter&) = default;
};
/// Key in problem files: "output_scale", "pair_output".
[[nodiscard]] std::string_view name(FreeParameter::Kind kind);

/// What a linkage is to generate, whatever its kind: its input link shall turn its output link through these pairs of
/// angles, in this order.
struct WantedFunction {
  std::vector<AnglePair> pairs;
  std::optional<NamedFunction> function;  ///< what the pairs are taken from (precision_pairs), for the structural error
  std::optional<FreeParameter> free;      ///< four positions only

  friend bool operator==(const WantedFunction&, const WantedFunction&) = default;
};

/// The caller's mistakes: not four or five positions, numbers that are not finite or too large, derivatives in which
/// nothing moves or the input stands still, input angles that repeat (modulo whole turns), an output that never moves,
/// mistakes in the named function or the free parameter. Places are `task.pairs[i].input_deg`,
/// `task.pairs[i].derivatives[m].input`, `task.function…`, `task.free…` (i from 0).
[[nodiscard]] std::vector<Error> mistakes_in(const WantedFunction& wanted);

/// The precision points of a named function without mistakes, by rising x.
[[nodiscard]] std::vector<AnglePair> precision_pairs(const NamedFunction& function);

/// The function with its free parameter at a value, free no longer; the output's dial is stretched about the first pair
/// with output_scale. `wanted` without mistakes.
[[nodiscard]] WantedFunction wanted_at(WantedFunction wanted, double value);

}  // namespace linkwright
