#include "linkwright/spherical/relaxed_orientation.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "linkwright/algebra/line_search.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/count_text.hpp"
#include "linkwright/core/parallel.hpp"
#include "linkwright/mechanism/spherical_position.hpp"
#include "linkwright/region/hill_climb.hpp"
#include "linkwright/region/requirement_filter.hpp"
#include "region/climb.hpp"
#include "region/ordered_axes.hpp"
#include "region/window_look.hpp"

namespace linkwright {
namespace {

constexpr int samples_of_a_map = 80;
constexpr std::size_t starts = 4;
constexpr double usable_transmission_angle = radians(20);

/// What is left of a task without one of its orientations.
struct Remainder {
  SphericalMotionTask task;
  SphericalTaskFamily given;
  UnitQuaternion wanted;

  [[nodiscard]] std::optional<double> error_of(const SphericalFourBar& bars) const {
    const auto error = orientation_error(bars, task.orientations.front().orientation, wanted);
    return error ? std::optional(error->angle) : std::nullopt;
  }
};

Remainder without(const SphericalMotionTask& task, std::size_t dropped) {
  Remainder left{task, {}, task.orientations[dropped].orientation};
  left.task.orientations.erase(left.task.orientations.begin() + static_cast<std::ptrdiff_t>(dropped));
  left.given = task_family(left.task);
  return left;
}

std::vector<Candidate> nearest_cells(const Remainder& left, const RegionMap& map, const RequirementFilter& filter,
                                     const Evaluator& evaluator, const RegionOptions& options) {
  std::vector<double> score(map.rows() * map.columns(), no_score);
  const auto place_of = [&](std::size_t row, std::size_t column) {
    return MapPoint{map.input_coordinates()[row], map.output_coordinates()[column]};
  };
  parallel_for(map.rows(), options.threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row)
      for (std::size_t column = 0; column < map.columns(); ++column) {
        if (!filter.passes(row, column)) continue;
        const auto links = left.given.family->dyad_pair(place_of(row, column));
        const auto error = links ? left.error_of(four_bar_of(*links)) : std::nullopt;
        if (error) score[map.index(row, column)] = -*error;
      }
  });
  const auto score_at = [&](std::size_t row, std::size_t column) { return score[map.index(row, column)]; };
  const auto any = [](std::size_t, std::size_t, std::size_t, std::size_t) { return true; };
  std::vector<Candidate> found;
  for (const RankedCell& cell :
       hill_tops(map.rows(), map.columns(), {map.rows() / 20 + 1, starts, options.threads}, score_at, any))
    if (const auto candidate = evaluator.candidate(place_of(cell.row, cell.column))) found.push_back(*candidate);
  return found;
}

// The nearest of the four-bars that meet these requirements; false where none does.
bool find_nearest(const Remainder& left, const Requirements& wanted, const RegionOptions& options,
                  const Progress& progress, RelaxedOrientation& found) {
  const SphericalFamily& family = *left.given.family;
  const std::vector<double> places = family.samples(Side::input, samples_of_a_map, Spacing::coordinate);
  RegionMap map;
  family.classify(map, places, places, wanted.respect_direction, options, progress);
  const RequirementFilter filter = filter_of(family, map, wanted);
  found.meeting = filter.census(progress).meeting;
  const Evaluator evaluator(family, wanted, Objective::min_transmission_angle);
  Ascent ascent;
  const double step = longest_axis(family) / samples_of_a_map;
  ascent.first_step = {step, step};
  ascent.resolution = 1e-6;
  ascent.score = [&](const Candidate& candidate) -> std::optional<double> {
    const auto error = left.error_of(spherical_four_bar_of(candidate.cell.pivots));
    return error ? std::optional(-*error) : std::nullopt;
  };
  double least = pi;
  std::vector<Candidate> feet = nearest_cells(left, map, filter, evaluator, options);
  if (feet.empty()) {
    const MapMaking making{[&](RegionMap& part, std::span<const double> input, std::span<const double> output) {
                             family.classify(part, input, output, wanted.respect_direction, options, progress);
                           },
                           samples_of_a_map,
                           {}};
    for (const auto& closer : look_into_windows(family, {&map, &filter, {step, step}}, wanted, making).maps) {
      const auto more = nearest_cells(left, closer->map, *closer->filter, evaluator, options);
      feet.insert(feet.end(), more.begin(), more.end());
    }
  }
  for (const Candidate& foot : feet) {
    const Candidate end = climbed(evaluator, foot, ascent, progress);
    const auto error = orientation_error(spherical_four_bar_of(end.cell.pivots),
                                         left.task.orientations.front().orientation, left.wanted);
    if (!error || error->angle >= least) continue;
    constexpr bool verify = true;
    auto made = make_spherical_four_bar(left.given, end.cell.place, wanted.respect_direction, verify);
    if (!made || is_unconfirmed(*made)) continue;
    least = error->angle;
    found.error = *error;
    found.place = end.cell.place;
    found.linkage = std::move(made);
  }
  return found.linkage.has_value();
}

RelaxedOrientation relaxed_at(const SphericalMotionTask& task, std::size_t dropped, const Requirements& requirements,
                              const RegionOptions& options, const Progress& progress) {
  RelaxedOrientation found;
  found.orientation = dropped;
  const Remainder left = without(task, dropped);
  if (!left.given.family) {
    found.reason = left.given.degeneracy;
    return found;
  }
  Requirements usable = requirements;
  usable.min_transmission_angle = std::max(usable.min_transmission_angle, usable_transmission_angle);
  if (find_nearest(left, usable, options, progress, found) ||
      find_nearest(left, requirements, options, progress, found))
    return found;
  found.reason =
      Notice{"none_left", "None of the four-bars through the other orientations meets all requirements.", {}};
  return found;
}

}  // namespace

// The turn that is missing is least where a search along the input, from where the input link points the right way,
// finds it so.
std::optional<OrientationError> orientation_error(const SphericalFourBar& bars, const UnitQuaternion& first,
                                                  const UnitQuaternion& wanted) {
  const LinkAngles angles = bars.angles();
  const Assembly assembly = assembly_of(bars);
  struct Miss {
    double score;
  };
  const auto at = [&](double input, const auto& /*best*/) -> std::optional<Miss> {
    const auto there = assemble(angles, input, assembly);
    if (!there) return std::nullopt;
    return Miss{-angle_between(coupler_turn(bars, placed(bars, *there)) * first, wanted)};
  };
  const UnitQuaternion turn = wanted * first.inverse();
  const SphericalFourBar there{bars.input_fixed, turn.apply(bars.input_moving), turn.apply(bars.output_moving),
                               bars.output_fixed};
  const double start = configuration_of(there).input_angle;
  const auto begin = at(start, 0);
  if (!begin) return std::nullopt;
  constexpr LineSearchOptions search{0.05, 1e-7, 40};
  const auto top = climb_line(LinePlace<Miss>{start, *begin}, search, at).top;
  return OrientationError{-top.found.score, top.at};
}

std::vector<RelaxedOrientation> drop_one_orientation(const SphericalMotionTask& task, const Requirements& requirements,
                                                     const RegionOptions& options, const Progress& progress) {
  std::vector<RelaxedOrientation> found;
  for (std::size_t i = 0; i < task.orientations.size() && !progress.is_cancelled(); ++i) {
    if (task.orientations[i].multiplicity() == 1)
      found.push_back(relaxed_at(task, i, with_default_angles(requirements), options, progress));
    progress(static_cast<double>(i + 1) / static_cast<double>(task.orientations.size()));
  }
  std::stable_sort(found.begin(), found.end(), [](const RelaxedOrientation& a, const RelaxedOrientation& b) {
    if (a.linkage.has_value() != b.linkage.has_value()) return a.linkage.has_value();
    return a.linkage && a.error.angle < b.error.angle;
  });
  return found;
}

}  // namespace linkwright
