#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "linkwright/algebra/point.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/mechanism/positions.hpp"
#include "linkwright/planar/named_function.hpp"
#include "linkwright/region/linkage_class.hpp"

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

/// A parameter of the task that is left open: the second axis of the map.
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
/// The kind of a key; nothing where there is none of that name.
[[nodiscard]] std::optional<FreeParameter::Kind> free_parameter_named(std::string_view name);

/// Function generation: the input link of a four-bar on two given ground pivots shall turn its output link through
/// these pairs of angles, in this order.
struct FunctionTask {
  static constexpr const LinkageClass& linkages = planar_linkages;

  std::vector<AnglePair> pairs;
  Point input_pivot = 0, output_pivot = 1;  ///< fixed frame, user's unit
  std::optional<NamedFunction> function;  ///< what the pairs are taken from (precision_pairs), for the structural error
  std::optional<FreeParameter> free;      ///< four positions only

  friend bool operator==(const FunctionTask&, const FunctionTask&) = default;
};

/// The caller's mistakes: not four or five positions, numbers that are not finite or too large, derivatives in which
/// nothing moves or the input stands still, input angles that repeat (modulo whole turns), an output that never moves,
/// ground pivots that coincide, mistakes in the named function or the free parameter. Places are
/// `task.pairs[i].input_deg`, `task.pairs[i].derivatives[m].input`, `task.ground_pivots…`, `task.function…`,
/// `task.free…` (i from 0).
[[nodiscard]] std::vector<Error> mistakes_in(const FunctionTask& task);

/// The precision points of a named function without mistakes, by rising x.
[[nodiscard]] std::vector<AnglePair> precision_pairs(const NamedFunction& function);

/// The task with its free parameter at a value, free no longer; the output's dial is stretched about the first pair
/// with output_scale. `task` without mistakes.
[[nodiscard]] FunctionTask task_at(const FunctionTask& task, double value);

}  // namespace linkwright
