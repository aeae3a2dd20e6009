#pragma once

#include <optional>
#include <vector>

#include "linkwright/core/result.hpp"
#include "linkwright/function/angle_pair.hpp"
#include "linkwright/function/free_parameter.hpp"
#include "linkwright/function/named_function.hpp"

namespace linkwright {

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
