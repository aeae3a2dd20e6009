#pragma once

#include <optional>
#include <vector>

#include "linkwright/core/progress.hpp"
#include "linkwright/function/function_error.hpp"
#include "linkwright/mechanism/linkage_type.hpp"
#include "linkwright/region/added_measures.hpp"
#include "linkwright/region/linkage_family.hpp"

namespace linkwright {

/// A linkage that generates a named function, and how well.
struct RankedGenerator {
  MapPoint place;
  LinkageType type = LinkageType::degenerate;
  Pivots hinges;
  double max_structural_error = 0;  ///< over the whole range, radians; with a free scale, of the output as scaled
};

/// What a family of linkages that generate a function says of them besides.
class GeneratorFamily {
 public:
  virtual ~GeneratorFamily() = default;

  /// The family that it is.
  [[nodiscard]] virtual const LinkageFamily& linkage_family() const = 0;
  /// How well the linkage at a place, with these hinges, generates the task's pairs and its named function. Called from
  /// several threads.
  [[nodiscard]] virtual FunctionError error_of(const Pivots& hinges, MapPoint place,
                                               const ErrorSampling& sampling) const = 0;
  /// Two of them are one design.
  [[nodiscard]] virtual bool are_alike(const Pivots& one, const Pivots& other) const = 0;
};

struct GeneratorSearchOptions {
  int input_samples = 400;          ///< along the curve of couplers
  int free_samples = 40;            ///< along the free parameter, where there is one
  int error_samples = 61;           ///< of each error curve while searching; the last word has 181
  int max_count = 10;               ///< how many, best first
  std::optional<MapWindow> window;  ///< nothing: the whole map
  int threads = 0;                  ///< 0: as many as the machine has
  AddedMeasures added{};            ///< which requirements may be on
  std::vector<MapPoint> starts{};   ///< places known to hold generators, beside the grid: inside small windows
};

/// The linkages that meet the requirements (defaults filled in), reach the whole range of inputs and have the least
/// largest structural error: hills of a grid over the map, climbed continuously in both coordinates with the type kept.
/// No two are alike; none without a named function.
[[nodiscard]] std::vector<RankedGenerator> best_generators(const GeneratorFamily& family,
                                                           const Requirements& requirements,
                                                           const GeneratorSearchOptions& options = {},
                                                           const Progress& progress = {});

/// The place that is reached from `start` by climbing to a lesser structural error, the type kept; nothing where
/// `start` is none that best_generators() would list, or nothing near it is better.
[[nodiscard]] std::optional<MapPoint> improved_generator(const GeneratorFamily& family,
                                                         const Requirements& requirements, MapPoint start,
                                                         const AddedMeasures& added = {});

}  // namespace linkwright
