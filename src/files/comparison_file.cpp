#include "linkwright/files/comparison_file.hpp"

#include "linkwright/core/angle.hpp"
#include "linkwright/files/csv_table.hpp"
#include "planar/nearest_path.hpp"

namespace linkwright {

Result<ComparedPath> compared_path(const PathTask& task) {
  PathTask near = task;
  near.pivots = {};
  near.box.reset();
  near.map.reset();
  near.between = std::nullopt;
  if (!near.is_approximate()) near.crank_timing = near.is_timed() ? CrankTiming::relative : CrankTiming::free;
  if (auto mistakes = mistakes_in(near); !mistakes.empty()) return mistakes;
  NearestTarget target = nearest_target(near);
  return ComparedPath{std::move(target.target), std::move(target.timing), std::move(target.point)};
}

Result<ComparedPath> compared_path(const std::vector<Point>& points, bool closed) {
  PathTask task;
  task.closed = closed;
  task.crank_timing = CrankTiming::free;
  for (const Point point : points) task.points.push_back({point, {}, {}, {}, {}, {}});
  return compared_path(task);
}

Result<PathComparison> compare_with_path(const StoredLinkage& linkage, const std::optional<Point>& point,
                                         const ComparedPath& path) {
  const auto traced = point ? point : linkage.point;
  if (!traced)
    return Error{
        "no_coupler_point", "",
        "no point of the coupler is given whose path could be compared; give \"point\": [x, y] in the file, or "
        "--point x,y"};
  const TracingFourBar bars{linkage.four_bar, *traced};
  const auto fit =
      path.timing ? compare_with_timed_curve(bars, path.target, *path.timing) : compare_with_curve(bars, path.target);
  if (!fit && path.timing)
    return Error{
        "angles_out_of_reach", "",
        "the linkage cannot be moved, or its input does not reach the angles of the crank in this assembly; leave "
        "the angles out"};
  if (!fit)
    return Error{"linkage_stands", "",
                 "the linkage cannot be moved: a link has no length, or the links lie in one line"};
  PathComparison compared{{}, fit->drive, path.target, fit->linkage().point};
  compared.path.timed = path.timing.has_value();
  compared.path.error = fit->error;
  compared.path.error.max_at = path.point[fit->error.max_at];
  for (std::size_t j = 0; j < fit->states.size(); ++j)
    compared.path.at.push_back({path.point[j], fit->input_turns[0][j], fit->states[j].point, fit->states[j].distance});
  compared.path.realisations.push_back(fit->linkage().bars);
  return compared;
}

std::string comparison_table(const PathComparison& comparison) {
  MotionTable table{{"point", "x", "y", "path_x", "path_y", "distance", "input_deg"}, {}};
  for (std::size_t j = 0; j < comparison.path.at.size(); ++j) {
    const FittedPath::Nearest& at = comparison.path.at[j];
    const Point wanted = comparison.target.points[j];
    for (const double value : {static_cast<double>(at.point + 1), wanted.real(), wanted.imag(), at.place.real(),
                               at.place.imag(), at.distance, degrees(at.input)})
      table.values.push_back(value);
  }
  return csv_text(table);
}

}  // namespace linkwright
