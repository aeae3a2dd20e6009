#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "linkwright/function/generated_function.hpp"
#include "linkwright/function/named_function.hpp"
#include "linkwright/function/wanted_function.hpp"
#include "linkwright/mechanism/position.hpp"
#include "linkwright/region/map_axis.hpp"
#include "linkwright/region/region_map.hpp"

namespace linkwright {

/// One point of the plot.
struct ErrorSample {
  double input = 0, wanted = 0;     ///< radians
  std::optional<double> generated;  ///< nothing where the drive does not get there
};

/// How well a linkage generates a function.
struct FunctionError {
  /// Generated less wanted output at each pair, radians in (−π, π]; nothing where the drive does not get to the input.
  std::vector<std::optional<double>> at_pairs;
  double precision_error = 0;  ///< largest magnitude at the pairs that are reached
  bool reaches_pairs = false;  ///< the drive gets to every input
  /// With a named function, over its whole range of inputs: largest magnitude of the structural error where the drive
  /// gets, and the input there. Nothing where only pairs are given or none of the range is reached.
  std::optional<double> max_structural_error;
  double worst_input = 0;
  std::vector<AngleRange> unreached;  ///< parts of the range of inputs where the drive does not get, ascending
  /// For a plot, by rising input; none where only pairs are given. Of very many, the least and the greatest error of
  /// each short stretch are kept.
  std::vector<ErrorSample> samples;
};

/// How finely the range of a named function is looked at.
struct ErrorSampling {
  static constexpr std::size_t every_row = std::numeric_limits<std::size_t>::max();

  int steps = 181;                   ///< even steps of the range, ≥ 2
  std::size_t max_rows = every_row;  ///< of a table; of more than these, as many by even steps

  /// For the errors of many linkages, that are to be told one from another.
  [[nodiscard]] static constexpr ErrorSampling coarse() { return {61, 200}; }
};

/// `generated` goes through the first of the pairs. `function`, where there is one, is looked at as `sampling` says,
/// and where the reach ends; from the highest hills of its error the top is sought to 1e-10 of the range.
[[nodiscard]] FunctionError function_error(const GeneratedFunction& generated, std::span<const AnglePair> pairs,
                                           const ScaledFunction* function, const ErrorSampling& sampling = {});

/// Largest structural error of each cell of a map, degrees; 0 where a cell has a defect, there is none or the whole
/// range is not reached. `values` has a place for each cell.
void structural_errors_deg(const RegionMap& map, std::span<float> values,
                           const std::function<std::optional<FunctionError>(MapPoint place)>& error_at);

}  // namespace linkwright
