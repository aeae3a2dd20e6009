#include "arm_family.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/parallel.hpp"
#include "linkwright/planar/four_bar_map.hpp"

namespace linkwright {
namespace {

MapAxis with_layers(MapAxis axis, int layers) {
  axis.layers = layers;
  return axis;
}

}  // namespace

ArmFamily::ArmFamily(ArmTask task, std::shared_ptr<const ArmChoice> choice, const Requirements& requirements,
                     Objective objective)
    : PathFamily(task.frame, with_layers(choice->axis(Side::input), ArmLayers(task, *choice).on_input_axis()),
                 choice->axis(Side::output)),
      task_(std::move(task)),
      choice_(std::move(choice)),
      layers_(task_, *choice_),
      respect_direction_(requirements.respect_direction),
      wishes_{CellJudge(requirements, path_linkages, measures()), rank_of(objective, measures()),
              task_.side == Side::input && requirements.no_defects} {}

bool ArmFamily::is_timed() const {
  return std::all_of(task_.path.begin(), task_.path.end(),
                     [](const PathPlace& place) { return place.known == PathPlace::Angle::of_link; });
}

std::span<const Measure> ArmFamily::measures() const {
  if (choice_->layers() == LayersOf::input_axis) return arm_measures;
  return planar_measures;
}

double ArmFamily::axis_value(Side side, double coordinate) const {
  return choice_->axis_value(side, side == Side::input ? layers_.without({coordinate, 0}).input : coordinate);
}

// Where no pattern is in order, one of them shows what is wrong with all.
std::vector<std::optional<ArmLinkage>> ArmFamily::best_of(std::span<const MapPoint> places, bool respect_direction,
                                                          Simd simd) const {
  std::vector<std::optional<ArmLinkage>> best(places.size());
  const auto take = [&](std::size_t tag, const ArmRating& rating) -> ArmLinkage* {
    std::optional<ArmLinkage>& shown = best[tag];
    if (shown && !rating.is_better_than(shown->rating)) return nullptr;
    return &shown.emplace();
  };
  ArmSolver solver(task_, layers_, wishes_, respect_direction, simd);
  for (std::size_t i = 0; i < places.size(); ++i)
    if (const auto here = arm_at(places[i])) solver.add_all(i, places[i], *here, take);
  solver.finish(take);
  for (std::size_t i = 0; i < places.size(); ++i)
    if (const auto here = best[i] ? std::nullopt : arm_at(places[i])) solver.add_any(i, places[i], *here, take);
  solver.finish(take);
  return best;
}

std::vector<Cell> ArmFamily::all_at(MapPoint place, bool respect_direction) const {
  std::vector<ArmLinkage> all;
  const auto take = [&](std::size_t, const ArmRating&) { return &all.emplace_back(); };
  ArmSolver solver(task_, layers_, wishes_, respect_direction, Simd::automatic);
  if (const auto here = arm_at(place)) solver.add_all(0, place, *here, take);
  solver.finish(take);
  std::stable_sort(all.begin(), all.end(),
                   [](const ArmLinkage& a, const ArmLinkage& b) { return a.rating.is_better_than(b.rating); });
  std::vector<Cell> cells;
  for (const ArmLinkage& found : all) cells.push_back(found.cell(frame()));
  return cells;
}

LinkageFamily::CellAt ArmFamily::cells(bool respect_direction) const {
  return [this, respect_direction](MapPoint place, const auto& is_worth_it) -> std::optional<Cell> {
    const auto found = best_of(std::array{place}, respect_direction, Simd::automatic).front();
    if (!found) return std::nullopt;
    const Cell cell = found->cell(frame());
    return is_worth_it(cell) ? std::optional(cell) : std::nullopt;
  };
}

std::optional<DyadPair> ArmFamily::dyad_pair(MapPoint place) const {
  const auto found = best_of(std::array{place}, respect_direction_, Simd::automatic).front();
  return found ? std::optional(found->links()) : std::nullopt;
}

void ArmFamily::fill(RegionMap& map, std::span<const double> input, std::span<const double> output,
                     bool respect_direction, const RegionOptions& options, const Progress& progress) const {
  constexpr bool of_pairs = false;
  map.lay(input, output, measures(), of_pairs, options);
  map.give_each_cell_a_driver();
  parallel_for(map.rows(), options.threads, [&](std::size_t begin, std::size_t end) {
    std::vector<MapPoint> places(output.size());
    for (std::size_t row = begin; row < end; ++row) {
      map.leave_empty(row, row + 1);
      if (progress.is_cancelled()) continue;
      for (std::size_t column = 0; column < output.size(); ++column) places[column] = {input[row], output[column]};
      const auto best = best_of(places, respect_direction, options.simd);
      const RegionMap::Cells cells = map.cells(row);
      for (std::size_t column = 0; column < output.size(); ++column) {
        if (!best[column]) continue;
        const MapCell cell = best[column]->verdict(frame().scale);
        cells.type[column] = static_cast<std::uint8_t>(cell.type);
        cells.defects[column] = cell.defects.bits;
        for (std::size_t k = 0; k < measures().size(); ++k)
          cells.measures[k][column] = static_cast<float>(cell.values[k]);
        map.set_driver(row, column, best[column]->travel());
      }
    }
  });
}

// ---- linkages of a map ----------------------------------------------------------------------------------------------

// The place of the linkage that a cell shows.
MapPoint ArmFamily::shown_at(const RegionMap& map, std::size_t row, std::size_t column) const {
  const MapPoint place{map.input_coordinates()[row], map.output_coordinates()[column]};
  if (choice_->layers() != LayersOf::input_axis) return place;
  const double layer = static_cast<double>(map.values(measures::layer)[map.index(row, column)]);
  return {layer + layers_.without(place).input, place.output};
}

MapPivots ArmFamily::pivots(const RegionMap& map) const {
  MapPivots pivots;
  pivots.of_cell = [this, &map](std::size_t row, std::size_t column) -> std::optional<Pivots> {
    const auto links = dyad_pair(shown_at(map, row, column));
    return links ? std::optional(pivots_of(frame().to_user(*four_bar_of(*links)))) : std::nullopt;
  };
  return pivots;
}

LinkageFamily::OutputOfCells ArmFamily::outputs_of(const RegionMap& map) const {
  return [this, &map](std::size_t row, std::size_t column) { return output(shown_at(map, row, column)); };
}

std::string ArmFamily::elbows_at(MapPoint place) const {
  const auto here = arm_at(place);
  const auto layer = layers_.at(place);
  if (!layer || !here || here->elbows.points == 0) return {};
  const std::uint8_t bits = here->bits.value_or(layer->pattern);
  std::string sides;
  for (std::size_t j = 0; j < here->elbows.points; ++j) sides += (bits >> j) & 1 ? '-' : '+';
  return here->other ? sides : fmt::format("{} {}", sides, layer->dyad + 1);
}

// ---- one linkage ----------------------------------------------------------------------------------------------------

std::optional<ArmMotion> ArmFamily::motion_at(MapPoint place) const {
  if (!layers_.at(place)) {
    const auto links = dyad_pair(place);
    if (!links) return std::nullopt;
    place.input = links->input.coordinate;
  }
  const auto layer = layers_.at(place);
  const auto here = arm_at(place);
  if (!layer || !here) return std::nullopt;
  return arm_motion(here->arm, task_.path, here->elbows,
                    elbow_pattern(here->elbows, here->bits.value_or(layer->pattern)));
}

std::vector<PrescribedPose> ArmFamily::working_poses(MapPoint place, const FourBar& bars) const {
  return frame().to_working(user_poses(place, bars));
}

std::vector<PrescribedPose> ArmFamily::user_poses(MapPoint place, const FourBar& /*bars*/) const {
  const auto motion = motion_at(place);
  std::vector<PrescribedPose> poses;
  for (std::size_t j = 0; motion && j < task_.points.size(); ++j) {
    poses.push_back({{task_.points[j].point, j == 0 ? 0 : std::arg(motion->turn[j])}, {}});
    for (std::size_t m = 0; m < task_.points[j].derivatives.size(); ++m)
      poses.back().derivatives.push_back({task_.points[j].derivatives[m].point, motion->rates[j].body[m]});
  }
  return poses;
}

std::vector<PrescribedPose> ArmFamily::crank_poses(MapPoint place, const FourBar& bars) const {
  return crank_poses_of(bars, user_poses(place, bars), task_.sense);
}

std::optional<double> ArmFamily::rate_residual(MapPoint place) const {
  const auto links = dyad_pair(place);
  const auto rows = links ? derivative_conditions(user_poses({links->input.coordinate, place.output}, {}), frame())
                          : std::vector<HomogeneousMatrix>{};
  if (rows.empty()) return std::nullopt;
  return std::max(residual_of(links->input, rows), residual_of(links->output, rows));
}

TaskFamily family_of_arms(const PathTask& task, const Requirements& requirements, Objective objective) {
  ArmTask arms = arm_task(task);
  ArmChoiceSetup setup = arm_choice(task, arms);
  TaskFamily given;
  given.pattern = pattern(task.points);
  given.conditions.frame = arms.frame;
  given.size = given.frame().scale;
  given.has_directions = std::any_of(task.points.begin(), task.points.end(),
                                     [](const PathPoint& point) { return !point.derivatives.empty(); });
  given.warnings = std::move(setup.warnings);
  given.degeneracy = std::move(setup.degeneracy);
  given.has_no_dyads = setup.has_none;
  if (!setup.choice) return given;
  given.paths = std::make_shared<const ArmFamily>(std::move(arms), std::move(setup.choice),
                                                  with_default_lengths(requirements, given.size), objective);
  given.family = given.paths;
  return given;
}

}  // namespace linkwright
