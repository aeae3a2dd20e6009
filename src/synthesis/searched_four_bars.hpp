#pragma once

#include "linkage_search.hpp"
#include "linkwright/mechanism/four_bar.hpp"
#include "planar/candidate.hpp"

namespace linkwright {

/// The four-bars of a solved task, as a search for the best takes them. Refers to the answer.
class SearchedFourBars : public CellEvaluator {
 public:
  using Solution = FourBarSolution;

  explicit SearchedFourBars(const FourBarAnswer& answer)
      : CellEvaluator(*answer.given.family, answer.requirements, answer.options.objective, answer.options.window,
                      answer.added),
        answer_(answer) {}

  /// Largest distance of a pivot.
  [[nodiscard]] double distance(const Candidate& a, const Candidate& b) const { return farthest_pivot(a.bars, b.bars); }
  /// The longest link.
  [[nodiscard]] double size(const Candidate& of) const { return of.bars.lengths().longest(); }
  [[nodiscard]] std::optional<FourBarSolution> make(MapPoint place) const;
  [[nodiscard]] bool is_confirmed(const Candidate& candidate, const FourBarSolution& made) const;

 private:
  const FourBarAnswer& answer_;
};

}  // namespace linkwright
