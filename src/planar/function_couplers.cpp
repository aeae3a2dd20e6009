#include "function_couplers.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "linkwright/core/tolerance.hpp"
#include "linkwright/planar/burmester_points.hpp"

namespace linkwright {
namespace {

Notice double_linkage(std::size_t number, int multiplicity) {
  return {
      "double_point",
      fmt::format("Linkage {} is a solution of multiplicity {}: a small change of an angle moves it far, splits it, "
                  "or makes it vanish.",
                  number, multiplicity),
      {{"point", static_cast<double>(number)}, {"multiplicity", static_cast<double>(multiplicity)}}};
}

void take_points(FunctionCouplers& couplers) {
  BurmesterPoints found = burmester_points(couplers.given.conditions);
  if (found.curve) {
    couplers.curve = std::move(found.curve);
    couplers.warnings.push_back(
        {"dependent_rows",
         "The conditions of the five pairs depend on each other: a whole curve of linkages generates all five.",
         {}});
    return;
  }
  if (found.degeneracy) {
    couplers.degeneracy = found.degeneracy;
    return;
  }
  const auto distance = [&](const BurmesterPoint& p) { return distance_from_ground(couplers.given, p.dyad); };
  const auto ground = std::min_element(found.points.begin(), found.points.end(),
                                       [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
  // The ground link is one of the four, however far rounding has taken it in an ill-conditioned task.
  if (ground != found.points.end()) found.points.erase(ground);
  for (const BurmesterPoint& point : found.points) {
    couplers.points.push_back(point.dyad);
    couplers.points.back().coordinate = static_cast<double>(couplers.points.size()) - 0.5;
    if (point.multiplicity > 1) couplers.warnings.push_back(double_linkage(couplers.points.size(), point.multiplicity));
  }
}

}  // namespace

std::optional<Dyad> FunctionCouplers::coupler(double tau) const {
  if (curve) {
    if (!(tau >= 0 && tau < curve->coordinate_length())) return std::nullopt;
    return curve->dyad(tau);
  }
  if (!(tau >= 0 && tau < static_cast<double>(points.size()))) return std::nullopt;
  return points[static_cast<std::size_t>(tau)];
}

std::optional<double> FunctionCouplers::ground_coordinate() const {
  return curve ? curve->coordinate_of(given.ground.circle) : std::nullopt;
}

FunctionCouplers function_couplers(const FunctionTask& task) {
  FunctionCouplers couplers{
      function_conditions(task.pairs, task.input_pivot, task.output_pivot), nullptr, {}, {}, std::nullopt};
  couplers.degeneracy = function_degeneracy(couplers.given);
  if (couplers.degeneracy) return couplers;
  const double condition = couplers.given.conditions.condition();
  if (couplers.given.conditions.are_independent() && condition > tolerance::ill_conditioned)
    couplers.warnings.push_back({"ill_conditioned",
                                 fmt::format("The pairs are so close together that round-off dominates (condition "
                                             "number {:.1e}); replace pairs that lie close "
                                             "together by one pair with derivatives (rates).",
                                             condition),
                                 {{"condition", condition}}});
  if (position_count(task.pairs) == 4)
    couplers.curve = std::make_shared<const BurmesterCurve>(couplers.given.conditions);
  else
    take_points(couplers);
  return couplers;
}

std::optional<FourBar> function_four_bar(const FunctionTask& task, const WorkingFrame& frame, const Dyad& coupler) {
  const auto a = finite_point(coupler.circle), b = finite_point(coupler.center);
  if (!a || !b) return std::nullopt;
  return FourBar{task.input_pivot, frame.to_user(*a), task.output_pivot, frame.to_user(*b)};
}

}  // namespace linkwright
