#include "linkwright/planar/improved_linkage.hpp"

#include "planar/candidate.hpp"

namespace linkwright {

std::optional<MapPoint> improved_linkage(const FourBarFamily& family, const Requirements& requirements,
                                         Objective objective, MapPoint start) {
  constexpr double first_step_share = 1.0 / 400;  // a cell of the usual map
  constexpr double fine = 1e-8;  // the numbers are an answer: nothing finer is told apart at a level top
  const CellEvaluator evaluator(family, requirements, objective);
  const auto foot = evaluator.candidate(start);
  if (!foot) return std::nullopt;
  const Candidate top = climbed(evaluator, *foot, {first_step_share * evaluator.largest_coordinate(), fine});
  return top.score > foot->score ? std::optional(top.place) : std::nullopt;
}

}  // namespace linkwright
