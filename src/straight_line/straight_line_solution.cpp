#include "linkwright/straight_line/straight_line_solution.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/mechanism/coupler_curve.hpp"
#include "linkwright/mechanism/drive_through.hpp"
#include "linkwright/mechanism/position.hpp"
#include "linkwright/region/cell_judge.hpp"

namespace linkwright {
namespace {

// By the triangles of the links, which the path knows nothing of: the coupler stands where the input's angle puts it.
bool assembles_alike(const TracingFourBar& start, const StraightPath& path) {
  constexpr int places = 17;
  constexpr double alike = 1e-7;  // next to a dead point the input's rounding shows as its root
  const LinkLengths lengths = start.bars.lengths();
  const Point arm = (start.point - start.bars.input_moving) / (start.bars.output_moving - start.bars.input_moving);
  const auto states = path.states(places);
  return std::all_of(states.begin(), states.end(), [&](const StraightPath::State& state) {
    const auto found =
        assemble(lengths, configuration_of(state.linkage.bars).input_angle, assembly_of(state.linkage.bars));
    if (!found) return false;
    const FourBar bars = placed(start.bars, *found);
    const Point point = bars.input_moving + arm * (bars.output_moving - bars.input_moving);
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
  constexpr double alike = 1e-9;  // of a symmetric linkage both sides are
  if (one && other && other->min_transmission_angle > one->min_transmission_angle + alike) {
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
  const auto asked = family.stroke();
  found.asks_stroke = asked.has_value();
  if (asked) found.stroke = path->stroke((*asked)[0], (*asked)[1]);
  found.residual = std::abs(family.task().line.to_line(linkage.point).imag());
  found.defects = family.defects(linkage);
  found.verified_by_driving = assembles_alike(linkage, *path) && drives_alike(found);
  return found;
}

LineWorth StraightLineSolution::worth() const {
  const bool falls_short = asks_stroke && !stroke;
  LineWorth worth =
      LineWorth::of(judged(), falls_short ? std::numeric_limits<double>::infinity() : judged().max_deviation);
  worth.usable = over_usable.to - over_usable.from;
  return worth;
}

std::vector<RequirementKind> failures_of(const StraightLineSolution& found, const Requirements& wanted) {
  const CellJudge judge(wanted, straight_line_linkages, straight_line_measures);
  return kinds_of(judge.failures(line_cell(found.linkage, found.worth())), judge.kinds());
}

}  // namespace linkwright
