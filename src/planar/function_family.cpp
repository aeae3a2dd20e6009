#include "function_family.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "function_linkage.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/parallel.hpp"
#include "linkwright/core/tolerance.hpp"
#include "planar/four_bar_cells.hpp"

namespace linkwright {
namespace {

// The input link as a body that turns about the origin.
std::vector<PrescribedPose> input_turns(const std::vector<AnglePair>& pairs) {
  std::vector<PrescribedPose> poses;
  for (const AnglePair& pair : pairs) {
    poses.push_back({{0, pair.input - pairs.front().input}, {}});
    for (const AngleDerivative& derivative : pair.derivatives)
      poses.back().derivatives.push_back({0, derivative.input});
  }
  return poses;
}

DyadAxis empty_axis(std::size_t size, const std::vector<PrescribedPose>& poses) {
  DyadAxis axis({}, poses);
  axis.dyads.resize(size);
  for (auto* values : {&axis.center_x, &axis.center_y, &axis.circle_x, &axis.circle_y, &axis.length})
    values->resize(size);
  for (auto* arms : {&axis.arm_x, &axis.arm_y})
    for (auto& arm : *arms) arm.resize(size);
  axis.admissible_directions.resize(size);
  axis.at_least_half_turn.resize(size);
  axis.sweep_ccw.resize(size);
  return axis;
}

// Puts an output link on a place of the axis, and how it turns.
void put(DyadAxis& axis, std::size_t at, Point center, Point circle, const std::vector<AnglePair>& pairs) {
  axis.center_x[at] = center.real();
  axis.center_y[at] = center.imag();
  axis.circle_x[at] = circle.real();
  axis.circle_y[at] = circle.imag();
  axis.length[at] = std::abs(circle - center);
  for (std::size_t j = 0; j < pairs.size(); ++j) {
    const Point arm = direction(pairs[j].output - pairs.front().output) * (circle - center);
    axis.arm_x[j][at] = arm.real();
    axis.arm_y[j][at] = arm.imag();
  }
}

}  // namespace

FunctionFamily::FunctionFamily(FunctionTask task, std::shared_ptr<const FunctionCouplers> couplers)
    : FunctionFamily(task, couplers->frame(),
                     std::make_unique<const Columns>(
                         task, couplers,
                         [input = task.input_pivot, output = task.output_pivot](const std::vector<AnglePair>& pairs) {
                           return function_couplers({{pairs, {}, {}}, input, output});
                         })) {}

FunctionFamily::FunctionFamily(FunctionTask task, WorkingFrame frame, std::unique_ptr<const Columns> columns)
    : FourBarFamily(frame, columns->coupler_axis(), axis_of(task.free)),
      task_(std::move(task)),
      columns_(std::move(columns)),
      ground_((task_.output_pivot - task_.input_pivot) / frame.scale) {}

FunctionTask FunctionFamily::task_at(MapPoint place) const {
  return task_.free ? linkwright::task_at(task_, columns_->value_at(place.output)) : task_;
}

FunctionError FunctionFamily::error_of(const FourBar& bars, MapPoint place, const ErrorSampling& sampling) const {
  return columns_->error_of([&](const AnglePair& first) { return generated_function(bars, first); }, place.output,
                            sampling);
}

std::optional<double> FunctionFamily::rate_residual(MapPoint place) const {
  const Columns::Column column = columns_->recent_at(place.output);
  const auto coupler = column.couplers->coupler(axis(Side::input).onto(place.input));
  const auto rows = column.couplers->given.derivative_rows();
  return coupler && !rows.empty() ? std::optional(residual_of(*coupler, rows)) : std::nullopt;
}

bool FunctionFamily::are_alike(const Pivots& one, const Pivots& other) const {
  constexpr double alike = 0.02;  // of the ground link
  const double most = alike * std::abs(task_.output_pivot - task_.input_pivot);
  return norm(one.moving[0] - other.moving[0]) < most && norm(one.moving[1] - other.moving[1]) < most;
}

// In the frame of the family: the frames of all columns have their origin in the input's ground pivot.
std::optional<Dyad> FunctionFamily::coupler(const Columns::Column& column, double tau) const {
  auto found = column.couplers->coupler(axis(Side::input).onto(tau));
  if (!found) return std::nullopt;
  const double larger = column.couplers->frame().scale / frame().scale;
  for (Homogeneous* p : {&found->center, &found->circle})
    *p = normalized(Homogeneous{p->w, larger * p->x, larger * p->y});
  return found;
}

std::optional<DyadPair> FunctionFamily::dyad_pair(MapPoint place) const {
  return dyad_pair(columns_->recent_at(place.output), place);
}

FourBarFamily::DyadPairsOfCells FunctionFamily::dyad_pairs_of_cells(std::span<const double> input,
                                                                    std::span<const double> output) const {
  constexpr int any_threads = 0;
  const auto columns = std::make_shared<const std::vector<Columns::Column>>(columns_->along(output, any_threads));
  return [this, input, output, columns](std::size_t row, std::size_t column) {
    return dyad_pair((*columns)[column], {input[row], output[column]});
  };
}

std::optional<DyadPair> FunctionFamily::dyad_pair(const Columns::Column& column, MapPoint place) const {
  const auto found = coupler(column, place.input);
  if (!found) return std::nullopt;
  return DyadPair{{Homogeneous::of(0), found->circle, place.input},
                  {Homogeneous::of(ground_), found->center, place.output}};
}

std::vector<PrescribedPose> FunctionFamily::user_poses(MapPoint place, const FourBar& bars) const {
  return coupler_poses(bars, columns_->pairs_at(place.output));
}

std::vector<PrescribedPose> FunctionFamily::working_poses(MapPoint place, const FourBar& bars) const {
  return coupler_poses(bars, columns_->pairs_at(place.output));
}

LinkageOutput FunctionFamily::output_of(MapPoint place, const FourBar& bars) const {
  return angle_output(bars, user_poses(place, bars));
}

// The free parameter runs along the columns.
std::shared_ptr<const FourBarCells> FunctionFamily::four_bar_cells(const RegionMap& map) const {
  std::vector<std::vector<AnglePair>> pairs;
  for (const double coordinate : map.output_coordinates()) pairs.push_back(task_at({0, coordinate}).pairs);
  return std::make_shared<const FourBarCells>(*this, map, pairs);
}

double FunctionFamily::axis_value(Side side, double tau) const {
  return side == Side::input ? tau : axis_value_of(task_.free, tau);
}

std::vector<double> FunctionFamily::samples(Side side, int count, Spacing spacing) const {
  const auto& curve = columns_->couplers().curve;
  if (side == Side::input && !task_.free && curve) return curve->samples(count, spacing);
  return FourBarFamily::samples(side, count, spacing);
}

std::vector<Dyad> FunctionFamily::polygon(Side side) const {
  std::vector<Dyad> links;
  const FunctionCouplers& all = columns_->couplers();
  if (task_.free || (all.curve && all.curve->coordinate_length() == 0)) return links;
  const std::vector<Dyad> couplers = all.curve ? all.curve->polygon(drawn_side) : all.points;
  for (const Dyad& coupler : couplers)
    links.push_back(side == Side::input ? Dyad{Homogeneous::of(0), coupler.circle, coupler.coordinate}
                                        : Dyad{Homogeneous::of(ground_), coupler.center, coupler.coordinate});
  return links;
}

// Verdicts do not change with size and attitude: every linkage is laid with its input link from 0 to 1 in the first
// pair, so that one driver stands for the whole row.
FourBarRow FunctionFamily::row_at(double tau, std::span<const Columns::Column> columns,
                                  std::span<const double> coordinates, bool respect_direction) const {
  const std::vector<PrescribedPose> turns = input_turns(task_.pairs);
  FourBarRow row{DyadAxis({{Homogeneous::of(0), Homogeneous::of(1), tau}}, turns, respect_direction),
                 empty_axis(columns.size(), turns), std::vector<float>(columns.size(), 0)};
  for (std::size_t k = 0; k < columns.size(); ++k) {
    row.output.dyads[k].coordinate = coordinates[k];
    const auto found = coupler(columns[k], tau);
    const auto a = found ? finite_point(found->circle) : std::nullopt, b = found ? finite_point(found->center) : a;
    if (!a || !b || std::abs(*a) <= tolerance::change_point * std::abs(ground_)) continue;  // degenerate
    row.enlarge[k] = static_cast<float>(std::abs(*a));
    put(row.output, k, ground_ / *a, *b / *a, columns[k].pairs);
  }
  return row;
}

void FunctionFamily::fill(RegionMap& map, std::span<const double> input, std::span<const double> output,
                          bool respect_direction, const RegionOptions& options, const Progress& progress) const {
  const std::vector<Columns::Column> columns = columns_->along(output, options.threads, progress);
  classify_rows(
      map, input, output, [&](std::size_t row) { return row_at(input[row], columns, output, respect_direction); },
      frame().scale, options, progress);
}

void structural_errors_deg(const FunctionFamily& family, const RegionMap& map, std::span<float> values) {
  structural_errors_deg(map, values, [&](MapPoint place) -> std::optional<FunctionError> {
    const auto links = family.dyad_pair(place);
    const auto bars = links ? four_bar_of(*links) : std::nullopt;
    if (!bars) return std::nullopt;
    return family.error_of(*bars, place, ErrorSampling::coarse());
  });
}

TaskFamily task_family(const FunctionTask& task) {
  auto couplers = std::make_shared<const FunctionCouplers>(function_couplers(task));
  TaskFamily given;
  given.pattern = pattern(task.pairs);
  given.has_directions =
      std::any_of(task.pairs.begin(), task.pairs.end(), [](const AnglePair& pair) { return pair.multiplicity() > 1; });
  given.conditions = couplers->given.conditions;
  given.size = std::abs(task.output_pivot - task.input_pivot);
  given.curve = couplers->curve;
  given.warnings = couplers->warnings;
  given.degeneracy = couplers->degeneracy;
  if (!given.degeneracy) given.functions = std::make_shared<FunctionFamily>(task, std::move(couplers));
  given.family = given.functions;
  return given;
}

}  // namespace linkwright
