#pragma once

#include <optional>
#include <vector>

#include "linkwright/analysis/linkage_type.hpp"
#include "linkwright/core/progress.hpp"
#include "linkwright/function/function_error.hpp"
#include "linkwright/region/added_measures.hpp"
#include "linkwright/region/linkage_family.hpp"

namespace linkwright {

/// A linkage that generates a named function, and how well.
struct RankedGenerator {
  MapPoint place;
  LinkageType type = LinkageType::degenerate;
  double max_structural_error = 0;  ///< over the whole range, radians; with a free scale, of the output as scaled
};

/// The linkages of a family with a named function, as a search for the best takes them.
class GeneratorSource {
 public:
  virtual ~GeneratorSource() = default;

  [[nodiscard]] virtual const LinkageFamily& family() const = 0;
  /// The linkage at a place; nothing where it does not meet the requirements, does not reach the whole range of inputs
  /// or lies outside the window. Called from several threads.
  [[nodiscard]] virtual std::optional<RankedGenerator> at(MapPoint place, const ErrorSampling& sampling) const = 0;
  /// Two of them are one design.
  [[nodiscard]] virtual bool are_alike(MapPoint one, MapPoint other) const = 0;
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

/// The linkages whose largest structural error is least: hills of a grid over the map, climbed continuously in both
/// coordinates with the type kept. No two are alike.
[[nodiscard]] std::vector<RankedGenerator> best_generators(const GeneratorSource& source,
                                                           const GeneratorSearchOptions& options = {},
                                                           const Progress& progress = {});

/// The place that is reached from `start` by climbing to a lesser structural error, the type kept; nothing where
/// `start` is none that best_generators() would list, or nothing near it is better.
[[nodiscard]] std::optional<MapPoint> improved_generator(const GeneratorSource& source, MapPoint start);

}  // namespace linkwright
