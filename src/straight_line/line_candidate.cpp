#include "straight_line/line_candidate.hpp"

#include <algorithm>
#include <cmath>

namespace linkwright {

std::optional<LineCandidate> LineEvaluator::candidate(MapPoint place) const {
  const LineDesign design = family_.design(place);
  const TracingFourBar& linkage = design.linkage;
  if (design.kind != DesignKind::four_bar || !has_shape(linkage, requirements_) || !has_place(linkage, requirements_) ||
      !family_.defects(linkage).none())
    return std::nullopt;
  const auto line = exact_line(linkage, line_, family_.measuring().deviation_of(linkage));
  if (!line) return std::nullopt;
  const LineWorth worth = line->worth(family_.measuring().measure);
  if (!meets(worth, requirements_)) return std::nullopt;
  const auto score = added_.score(place, requirements_, objective_, score_of(objective_, linkage, worth));
  return score ? std::optional(LineCandidate{place, linkage, *score, worth.usable, false}) : std::nullopt;
}

double LineEvaluator::change_point_margin(const LineCandidate& here) const {
  const LinkLengths lengths = here.linkage.bars.lengths();
  const GrashofExcesses t = grashof_excesses(lengths);
  return std::min({std::abs(t.t1), std::abs(t.t2), std::abs(t.t3)}) / lengths.perimeter();
}

}  // namespace linkwright
