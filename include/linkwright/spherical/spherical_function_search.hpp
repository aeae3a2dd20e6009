#pragma once

#include <optional>
#include <vector>

#include "linkwright/core/progress.hpp"
#include "linkwright/function/generator_search.hpp"
#include "linkwright/region/added_measures.hpp"
#include "linkwright/region/requirements.hpp"
#include "linkwright/spherical/spherical_function_family.hpp"

namespace linkwright {

/// The linkages of a family with a named function whose largest structural error is least. All meet the requirements
/// (defaults filled in) and reach the whole range of inputs; no two are alike (1° in all moving axes). Empty without a
/// named function, or where nothing meets the requirements.
[[nodiscard]] std::vector<RankedGenerator> best_generators(const SphericalFunctionFamily& family,
                                                           const Requirements& requirements,
                                                           const GeneratorSearchOptions& options = {},
                                                           const Progress& progress = {});

/// The place that is reached from `start` by climbing to a lesser structural error, the type kept; nothing where
/// `start` is none that best_generators() would list, or nothing near it is better.
[[nodiscard]] std::optional<MapPoint> improved_generator(const SphericalFunctionFamily& family,
                                                         const Requirements& requirements, MapPoint start,
                                                         const AddedMeasures& added = {});

}  // namespace linkwright
