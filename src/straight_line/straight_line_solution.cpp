#include "linkwright/straight_line/straight_line_solution.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/analysis/cognates.hpp"
#include "linkwright/analysis/drive_through.hpp"
#include "linkwright/analysis/position.hpp"

namespace linkwright {
namespace {

// By the triangles of the links, which the path knows nothing of: the coupler stands where the input's angle puts it.
bool assembles_alike(const TracingFourBar& start, const StraightPath& path) {
  constexpr int places = 17;
  constexpr double alike = 1e-7;  // next to a dead point the input's rounding shows as its root
  const LinkLengths lengths = start.bars.lengths();
  const Point arm = (start.point - start.bars.input_circle) / (start.bars.output_circle - start.bars.input_circle);
  const auto states = path.states(places);
  return std::all_of(states.begin(), states.end(), [&](const StraightPath::State& state) {
    const auto found =
        assemble(lengths, configuration_of(state.linkage.bars).input_angle, assembly_of(state.linkage.bars));
    if (!found) return false;
    const FourBar bars = placed(start.bars, *found);
    const Point point = bars.input_circle + arm * (bars.output_circle - bars.input_circle);
    return std::abs(point - state.linkage.point) <= alike * start.longest();
  });
}

UsableLine usable_of(const StraightPath& path, double deviation, LineMeasure measure) {
  return measure == LineMeasure::strip ? path.usable_strip(deviation) : path.usable(deviation);
}

// Traced only as far as a strip may reach. Driven from the side from which it transmits better.
std::optional<StraightLineCognate> measured_cognate(TracingFourBar linkage, Point along, double deviation,
                                                    LineMeasure measure) {
  const PathLimits reach{.max_deviation = 2 * deviation};
  auto path = StraightPath::of(linkage, along, reach);
  const auto backwards = StraightPath::of(linkage.swapped(), along, reach);
  if (!path || !backwards) return std::nullopt;
  const UsableLine usable = usable_of(*path, deviation, measure);
  const auto one = path->stroke_figures(usable.from, usable.to),
             other = backwards->stroke_figures(usable.from, usable.to);
  if (one && other && other->min_transmission_angle > one->min_transmission_angle) {
    linkage = linkage.swapped();
    path = backwards;
  }
  const auto over = path->stroke(usable.from, usable.to);
  if (!over) return std::nullopt;
  return StraightLineCognate{linkage, linkage_type(linkage.bars.lengths()), *over};
}

std::vector<StraightLineCognate> measured_cognates(const TracingFourBar& linkage, Point along, double deviation,
                                                   LineMeasure measure) {
  std::vector<StraightLineCognate> measured;
  if (const auto others = cognates(linkage))
    for (const TracingFourBar& other : *others)
      if (const auto found = measured_cognate(other, along, deviation, measure)) measured.push_back(*found);
  return measured;
}

// Contacts at places, by continuation: with the defects that the sign tests name.
bool drives_alike(const StraightLineSolution& found) {
  const auto* mixed = std::get_if<straight_cases::MixedContacts>(&found.task.given);
  if (!mixed) return true;
  const auto poses = contact_poses(found.linkage, found.task.line, mixed->contacts);
  if (poses.empty()) return false;
  const DriveThroughReport report =
      drive_through(found.linkage.bars, poses, {.max_steps = 400'000, .respect_direction = true});
  return report.completed && report.defects.bits == found.defects.bits;
}

}  // namespace

std::optional<StraightLineSolution> make_straight_line(const StraightLineFamily& family, MapPoint place) {
  const LineDesign design = family.design(place);
  if (design.kind != DesignKind::four_bar) return std::nullopt;
  const TracingFourBar& linkage = design.linkage;
  const Point along = family.task().line.direction;
  const auto path = StraightPath::of(linkage, along);
  const auto loop = loop_series(linkage.bars);
  if (!path || !loop) return std::nullopt;
  StraightLineSolution found;
  found.linkage = linkage;
  found.lengths = linkage.bars.lengths();
  found.type = linkage_type(found.lengths);
  found.task = family.task();
  found.place = family.place_of(place);
  found.contact = contact_with_line(coupler_motion(linkage.bars, *loop), linkage.point, along);
  found.deviation = family.measuring().deviation_of(linkage);
  found.usable = path->usable(found.deviation);
  found.usable_strip = path->usable_strip(found.deviation);
  const UsableLine& counted = found.counted(family.measuring().measure);
  const auto over = path->stroke(counted.from, counted.to);
  if (!over) return std::nullopt;
  found.over_usable = *over;
  found.cognates = measured_cognates(linkage, along, found.deviation, family.measuring().measure);
  if (const auto asked = family.stroke()) found.stroke = path->stroke((*asked)[0], (*asked)[1]);
  found.residual = std::abs(family.task().line.to_line(linkage.point).imag());
  found.defects = family.defects(linkage);
  found.verified_by_driving = assembles_alike(linkage, *path) && drives_alike(found);
  return found;
}

std::vector<RequirementKind> failures_of(const StraightLineSolution& found, const Requirements& wanted,
                                         LineMeasure measure) {
  std::vector<RequirementKind> failed;
  const auto demand = [&](bool met, RequirementKind kind) {
    if (!met) failed.push_back(kind);
  };
  const auto inside = [](const std::optional<Box>& box, Point one, Point other) {
    return !box || (box->contains(one) && box->contains(other));
  };
  const FourBar& bars = found.linkage.bars;
  const double longest = found.linkage.longest();
  const StrokeReport& over = found.stroke ? *found.stroke : found.over_usable;
  demand(wanted.types.empty() || std::find(wanted.types.begin(), wanted.types.end(), found.type) != wanted.types.end(),
         RequirementKind::types);
  demand(found.over_usable.min_transmission_angle >= wanted.min_transmission_angle,
         RequirementKind::min_transmission_angle);
  demand(longest <= wanted.max_link_ratio * found.linkage.shortest(), RequirementKind::max_link_ratio);
  demand(longest <= wanted.max_length.value_or(Requirements::unlimited), RequirementKind::max_length);
  demand(inside(wanted.ground_pivots_within, bars.input_center, bars.output_center),
         RequirementKind::ground_pivots_within);
  demand(inside(wanted.moving_pivots_within, bars.input_circle, bars.output_circle),
         RequirementKind::moving_pivots_within);
  demand(found.counted(measure).length() >= wanted.min_stroke, RequirementKind::min_stroke);
  demand(over.max_deviation <= wanted.max_deviation, RequirementKind::max_deviation);
  return failed;
}

}  // namespace linkwright
