#pragma once

#include "linkage_search.hpp"
#include "straight_line/line_candidate.hpp"

namespace linkwright {

/// The linkages of a map of straight lines, as a search for the best takes them. Refers to the family.
class SearchedLines : public LineEvaluator {
 public:
  using Solution = StraightLineSolution;
  using LineEvaluator::LineEvaluator;

  /// Largest distance of a pivot; the grounded links may be named either way.
  [[nodiscard]] double distance(const Candidate& a, const Candidate& b) const;
  /// The longest link.
  [[nodiscard]] double size(const Candidate& of) const { return of.linkage.longest(); }
  [[nodiscard]] std::optional<StraightLineSolution> make(MapPoint place) const;
  [[nodiscard]] bool is_confirmed(const Candidate& candidate, const StraightLineSolution& made) const;
};

/// Its point has the contact that its case promises, and the triangles of its links confirm its path.
[[nodiscard]] bool is_confirmed(const StraightLineSolution& made);

}  // namespace linkwright
