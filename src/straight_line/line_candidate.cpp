#include "straight_line/line_candidate.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/angle.hpp"
#include "linkwright/straight_line/straight_line_solution.hpp"
#include "linkwright/straight_line/straight_path.hpp"
#include "straight_line/line_estimate.hpp"

namespace linkwright {

constexpr double a_hair = 1e-6;  // by which ends of deviation are told from those of the path

bool LineEvaluator::can_be_built(const TracingFourBar& linkage) const {
  const Requirements& wanted = requirements_;
  const FourBar& bars = linkage.bars;
  const LinkageType type = linkage_type(bars.lengths());
  if (type == LinkageType::degenerate) return false;
  if (!wanted.types.empty() && std::find(wanted.types.begin(), wanted.types.end(), type) == wanted.types.end())
    return false;
  const auto inside = [](const std::optional<Box>& box, Point one, Point other) {
    return !box || (box->contains(one) && box->contains(other));
  };
  return linkage.longest() <= wanted.max_length.value_or(Requirements::unlimited) &&
         linkage.longest() <= wanted.max_link_ratio * linkage.shortest() &&
         inside(wanted.ground_pivots_within, bars.input_center, bars.output_center) &&
         inside(wanted.moving_pivots_within, bars.input_circle, bars.output_circle);
}

std::optional<LineCandidate> LineEvaluator::candidate(MapPoint place) const {
  const LineDesign design = family_.design(place);
  if (design.kind != DesignKind::four_bar || !can_be_built(design.linkage)) return std::nullopt;
  if (!family_.defects(design.linkage).none()) return std::nullopt;
  const auto numbers =
      family_.measuring().measure == LineMeasure::strip ? estimated(design.linkage) : measured(design.linkage);
  if (!numbers) return std::nullopt;
  return LineCandidate{place, design.linkage, score_of(objective_, *numbers),
                       numbers->stroke_over_longest * numbers->longest_link, false};
}

std::optional<RankedNumbers> LineEvaluator::measured(const TracingFourBar& linkage) const {
  const double deviation = family_.measuring().deviation_of(linkage);
  const auto asked = family_.stroke();
  PathLimits limits;
  if (!asked) limits.max_deviation = (1 + a_hair) * deviation;
  const auto path = StraightPath::of(linkage, family_.task().line.direction, limits);
  if (!path) return std::nullopt;
  const UsableLine usable = path->usable(deviation);
  if (!(usable.length() >= requirements_.min_stroke)) return std::nullopt;
  const auto over = path->stroke_figures(usable.from, usable.to);
  const auto stroke = asked ? path->stroke_figures((*asked)[0], (*asked)[1]) : over;
  if (!over || !stroke || !(stroke->max_deviation <= requirements_.max_deviation) ||
      over->min_transmission_angle < requirements_.min_transmission_angle)
    return std::nullopt;
  RankedNumbers numbers;
  numbers.transmission_versine = versine_of_angle(over->min_transmission_angle);
  numbers.longest_link = linkage.longest();
  numbers.stroke_over_longest = usable.length() / linkage.longest();
  numbers.deviation = stroke->max_deviation;
  numbers.velocity_nonuniformity =
      over->drive ? over->drive->nonuniformity(usable.length()) : std::numeric_limits<double>::infinity();
  return numbers;
}

// An exact strip takes 40 µs, too long for the steps of many climbs; half a percent of room makes up for it.
std::optional<RankedNumbers> LineEvaluator::estimated(const TracingFourBar& linkage) const {
  constexpr double room = 0.005, room_of_angle = radians(0.5);
  const auto estimate = estimate_of(family_, linkage);
  const double angle = std::asin(std::min(estimate.min_transmission_sine, 1.0));
  const bool asks_angle = requirements_.min_transmission_angle > 0;
  if (!(estimate.usable_strip >= (1 + room) * requirements_.min_stroke) ||
      !(estimate.deviation <= (1 - room) * requirements_.max_deviation) ||
      (asks_angle && angle < requirements_.min_transmission_angle + room_of_angle))
    return std::nullopt;
  RankedNumbers numbers;
  numbers.transmission_versine = versine_of_angle(angle);
  numbers.longest_link = linkage.longest();
  numbers.stroke_over_longest = estimate.usable_strip / linkage.longest();
  numbers.deviation = estimate.deviation;
  numbers.velocity_nonuniformity = estimate.velocity_nonuniformity;
  return numbers;
}

double LineEvaluator::change_point_margin(const LineCandidate& here) const {
  const LinkLengths lengths = here.linkage.bars.lengths();
  const GrashofExcesses t = grashof_excesses(lengths);
  return std::min({std::abs(t.t1), std::abs(t.t2), std::abs(t.t3)}) / lengths.perimeter();
}

}  // namespace linkwright
