#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "linkwright/core/progress.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/loads/loads.hpp"
#include "linkwright/loads/spring_place.hpp"
#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/pose.hpp"

namespace linkwright {

/// A file of boxes: what spring is looked for, and where its studs may stand. Forces in newtons, lengths in the unit of
/// the problem whose linkage it is for. The caller's mistakes, at their places in the file; bounds that depend on the
/// unit of length are looked at by place_listed_spring().
[[nodiscard]] Result<SpringWanted> read_spring_boxes(std::string_view text);

/// A catalogue of gas springs.
struct SpringCatalogue {
  std::string length_unit, source;  ///< no unit: that of the problem
  std::vector<CatalogueSpring> springs;
};
[[nodiscard]] Result<SpringCatalogue> read_spring_catalogue(std::string_view text);

/// The spring placed for one linkage of a result.
struct PlacedSpring {
  std::string title, length_unit;
  FoundOrNot<SpringPlace> place;
  std::vector<CatalogueSpring> catalogue;  ///< in the unit of the problem
  std::optional<RankedParts> parts;        ///< of the catalogue, where there is one
};

/// The loads beside which a spring is placed: one that has the name of the one that is looked for gives way to it; all
/// others stay.
[[nodiscard]] Loads loads_beside(const SpringWanted& wanted, Loads loads);

/// A linkage of a result file, as a spring is placed for it.
struct LoadedLinkage {
  std::string title, length_unit;
  Loads loads;
  FourBar bars;  ///< in position 1
  std::vector<PrescribedPose> poses;
};
/// The linkage number `linkage`, from 1, of the result file `text`. The caller's mistakes: those of
/// read_listed_problem(), and a problem without loads.
[[nodiscard]] Result<LoadedLinkage> loaded_linkage(std::string_view text, int linkage);

/// The parts in another unit of length. The caller's mistake: one of the units is not known.
[[nodiscard]] Result<std::vector<CatalogueSpring>> parts_in(const SpringCatalogue& catalogue, const std::string& unit);

/// Beside loads_beside(); `catalogue` in the unit of the linkage. The caller's mistakes: those of
/// mistakes_in(SpringWanted).
[[nodiscard]] Result<PlacedSpring> place_spring_on(const LoadedLinkage& linkage, const SpringWanted& wanted,
                                                   std::optional<std::vector<CatalogueSpring>> catalogue,
                                                   const SpringSearchOptions& options = {},
                                                   const Progress& progress = {});

/// The three of them, with the mistakes of the first that has any.
[[nodiscard]] Result<PlacedSpring> place_listed_spring(std::string_view text, int linkage, const SpringWanted& wanted,
                                                       const std::optional<SpringCatalogue>& catalogue,
                                                       const SpringSearchOptions& options = {},
                                                       const Progress& progress = {});

/// As JSON text: the spring as in loads.springs, its force, and what is proven; parts that do and parts that do not.
[[nodiscard]] std::string write_placed_spring(const PlacedSpring& placed);

}  // namespace linkwright
