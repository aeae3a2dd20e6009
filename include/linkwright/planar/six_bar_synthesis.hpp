#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "linkwright/core/progress.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/planar/chain_family.hpp"
#include "linkwright/planar/six_bar_solution.hpp"
#include "linkwright/region/added_measures.hpp"
#include "linkwright/region/best_cells.hpp"
#include "linkwright/region/region_map.hpp"
#include "linkwright/region/requirement_filter.hpp"

namespace linkwright {

/// How many six-bars are wanted, and by what.
struct SixBarChoice {
  Objective objective = Objective::min_transmission_angle;
  int best = 10;
  int threads = 0;                    ///< 0: as many as the machine has
  AddedMeasures added{};              ///< of a map
  std::optional<MapWindow> window{};  ///< of a map, which nothing is refined out of
};

/// The best six-bars of maps that meet requirements whose lengths are set, refined along both coordinates to the
/// tops of their hills, checked and driven, best first, no two alike. What was found by then where `progress` is
/// cancelled.
[[nodiscard]] std::vector<SixBarSolution> best_six_bars(const SixBarTask& task, const ChainFamily& family,
                                                        std::span<const SearchMap> maps,
                                                        const Requirements& requirements, const SixBarChoice& choice,
                                                        const Progress& progress = {});

/// How many chains are tried where nobody says: enough for most tasks, in half a second.
inline constexpr int default_effort = 200'000;

/// A search for six-bars whose chain is not given.
struct SixBarSearchOptions {
  std::uint64_t seed = 1;       ///< of the chains drawn: the same seed finds the same six-bars, whatever the machine
  int effort = default_effort;  ///< chains that reach all poses to be tried
};

struct SixBarSearchResult {
  std::vector<SixBarSolution> linkages;  ///< best first
  std::int64_t chains_drawn = 0;         ///< all pivots in the box; most do not reach all poses
  std::int64_t chains_tried = 0;         ///< that reach all poses
  std::int64_t six_bars = 0;             ///< of those chains, sampled along both curves, all pivots in the box
  std::int64_t driven = 0;               ///< driven through: those that could be better than the chain's best so far
  std::int64_t defect_free = 0;          ///< of the ones driven
  bool interrupted = false;              ///< cancelled: the best so far
  Notice reason;                         ///< in words: searched, nothing_found, no_chain

  [[nodiscard]] std::int64_t looked_at() const { return six_bars; }
};

/// Draws chains in the task's box, samples the six-bars of each, keeps the best that meet the requirements (all pivots
/// in the box besides, in position 1), and moves chain and links of the best to where nothing better is near.
/// `task` has a box and no chain; one that it has is ignored. Cancelled, it ends with the best so far, checked.
[[nodiscard]] SixBarSearchResult search_six_bars(const SixBarTask& task, const Requirements& requirements,
                                                 const SixBarChoice& choice, const SixBarSearchOptions& options,
                                                 const Progress& progress = {});

}  // namespace linkwright
