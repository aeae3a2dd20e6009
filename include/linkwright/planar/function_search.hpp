#pragma once

#include <optional>
#include <vector>

#include "linkwright/core/progress.hpp"
#include "linkwright/planar/four_bar_family.hpp"
#include "linkwright/planar/function_family.hpp"
#include "linkwright/region/requirements.hpp"

namespace linkwright {

/// A linkage that generates a named function, and how well.
struct RankedGenerator {
  MapPoint place;
  FourBar four_bar;                 ///< user's frame
  double max_structural_error = 0;  ///< over the whole range, radians; with a free scale, of the output as scaled
};

struct GeneratorSearchOptions {
  int input_samples = 400;          ///< along the curve of couplers
  int free_samples = 40;            ///< along the free parameter, where there is one
  int error_samples = 61;           ///< of each error curve while searching; the last word has 181
  int max_count = 10;               ///< how many, best first
  std::optional<MapWindow> window;  ///< nothing: the whole map
  int threads = 0;                  ///< 0: as many as the machine has
};

/// The linkages of a family with a named function whose largest structural error is least: hills of a grid over the
/// map, climbed continuously in both coordinates with the type kept. All meet the requirements (lengths set) and
/// reach the whole range of inputs; no two are alike (2 % of the ground link in all pivots). Empty without a named
/// function, or where nothing meets the requirements.
[[nodiscard]] std::vector<RankedGenerator> best_generators(const FunctionFamily& family,
                                                           const Requirements& requirements,
                                                           const GeneratorSearchOptions& options = {},
                                                           const Progress& progress = {});

/// The place that is reached from `start` by climbing to a lesser structural error, the type kept; nothing where
/// `start` is none that best_generators() would list, or nothing near it is better.
[[nodiscard]] std::optional<MapPoint> improved_generator(const FunctionFamily& family, const Requirements& requirements,
                                                         MapPoint start);

}  // namespace linkwright
