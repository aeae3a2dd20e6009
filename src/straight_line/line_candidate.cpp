#include "straight_line/line_candidate.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/angle.hpp"
#include "linkwright/straight_line/straight_path.hpp"
#include "straight_line/line_estimate.hpp"

namespace linkwright {

constexpr double a_hair = 1e-6;  // by which ends of deviation are told from those of the path

std::optional<LineCandidate> LineEvaluator::candidate(MapPoint place) const {
  const LineDesign design = family_.design(place);
  const TracingFourBar& linkage = design.linkage;
  if (design.kind != DesignKind::four_bar || !has_shape(linkage, requirements_) || !has_place(linkage, requirements_) ||
      !family_.defects(linkage).none())
    return std::nullopt;
  const auto worth = family_.measuring().measure == LineMeasure::strip ? estimated(linkage) : measured(linkage);
  if (!worth) return std::nullopt;
  const auto score = added_.score(place, requirements_, objective_, score_of(objective_, linkage, *worth));
  return score ? std::optional(LineCandidate{place, linkage, *score, worth->usable, false}) : std::nullopt;
}

// Nothing where the path does not reach so far. Traced no farther than it is measured.
std::optional<StrokeFigures> LineEvaluator::over_stroke(const TracingFourBar& linkage,
                                                        const std::array<double, 2>& stroke) const {
  const double beyond = a_hair * (stroke[1] - stroke[0]);
  const PathLimits limits{.from = std::min(stroke[0], 0.0) - beyond, .to = std::max(stroke[1], 0.0) + beyond};
  const auto path = StraightPath::of(linkage, family_.task().line.direction, limits);
  return path ? path->stroke_figures(stroke[0], stroke[1]) : std::nullopt;
}

std::optional<LineWorth> LineEvaluator::measured(const TracingFourBar& linkage) const {
  const double deviation = family_.measuring().deviation_of(linkage);
  const auto path =
      StraightPath::of(linkage, family_.task().line.direction, {.max_deviation = (1 + a_hair) * deviation});
  if (!path) return std::nullopt;
  const UsableLine usable = path->usable(deviation);
  if (!(usable.length() >= requirements_.min_stroke)) return std::nullopt;
  const auto over = path->stroke_figures(usable.from, usable.to);
  if (!over) return std::nullopt;
  const auto asked = family_.stroke();
  const auto stroke = asked ? over_stroke(linkage, *asked) : over;
  const auto worth = LineWorth::of(*over, stroke ? stroke->max_deviation : std::numeric_limits<double>::infinity());
  return meets(worth, requirements_) ? std::optional(worth) : std::nullopt;
}

// An exact strip takes 40 µs, too long for the steps of many climbs; half a percent of room makes up for it.
std::optional<LineWorth> LineEvaluator::estimated(const TracingFourBar& linkage) const {
  constexpr double room = 0.005, room_of_angle = radians(0.5);
  const LineWorth worth = estimate_of(family_, linkage).worth(LineMeasure::strip);
  const bool asks_angle = requirements_.min_transmission_angle > 0;
  if (!(worth.usable >= (1 + room) * requirements_.min_stroke) ||
      !(worth.deviation <= (1 - room) * requirements_.max_deviation) ||
      (asks_angle && worth.min_transmission_angle < requirements_.min_transmission_angle + room_of_angle))
    return std::nullopt;
  return worth;
}

double LineEvaluator::change_point_margin(const LineCandidate& here) const {
  const LinkLengths lengths = here.linkage.bars.lengths();
  const GrashofExcesses t = grashof_excesses(lengths);
  return std::min({std::abs(t.t1), std::abs(t.t2), std::abs(t.t3)}) / lengths.perimeter();
}

}  // namespace linkwright
