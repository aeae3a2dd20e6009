#include "linkwright/planar/four_bar_map.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "linkwright/algebra/homogeneous.hpp"
#include "linkwright/core/parallel.hpp"
#include "linkwright/core/precondition.hpp"
#include "linkwright/core/tolerance.hpp"
#include "linkwright/mechanism/driver_sequence.hpp"
#include "planar/four_bar_kernel.hpp"
#include "planar/kernel_arrays.hpp"
#include "region/pair_map.hpp"

namespace linkwright {
namespace {

std::vector<double> coordinates_of(const std::vector<Dyad>& dyads) {
  std::vector<double> coordinates;
  coordinates.reserve(dyads.size());
  for (const Dyad& dyad : dyads) coordinates.push_back(dyad.coordinate);
  return coordinates;
}

// How the drivers of a row travel, to its cells. `directions`: of the cells, where the kernel has not set them.
void set_drivers(RegionMap& map, std::size_t row, const DyadAxis& drivers, AlongRow changes, std::uint8_t* directions) {
  if (changes == AlongRow::driven_link) {
    const DriverTravel travel = driver_travel(drivers, 0);
    map.set_driver(row, travel);
    if (directions != nullptr) std::fill_n(directions, map.columns(), travel.admissible_directions);
    return;
  }
  for (std::size_t column = 0; column < map.columns(); ++column) {
    const DriverTravel travel = driver_travel(drivers, column);
    map.set_driver(row, column, travel);
    if (directions != nullptr) directions[column] = travel.admissible_directions;
  }
}

// The kernel's own way: its rows and columns are the row's input and output links, one of which there is one only.
void classify_row(RegionMap& map, std::size_t row, const FourBarRow& links, double unit, Simd simd, AlongRow changes) {
  const DyadAxis &input = links.input, &output = links.output;
  const bool drivers_change = changes == AlongRow::driving_link;
  require((drivers_change ? output : input).size() == 1 && (drivers_change ? input : output).size() == map.columns(),
          "a row has one link of a side, and one a column of the other");
  const KernelCells cells = kernel_cells(map.cells(row));
  four_bar_kernel.for_simd(simd)({plain_arrays(input), plain_arrays(output), 0, input.size(), output.size(),
                                  static_cast<int>(input.pose_count()), unit, tolerance::change_point, cells});
  for (std::size_t column = 0; column < links.enlarge.size(); ++column) cells.longest[column] *= links.enlarge[column];
  set_drivers(map, row, input, changes, input.pose_count() != 2 ? cells.admissible_directions : nullptr);
}

}  // namespace

DyadAxis::DyadAxis(std::vector<Dyad> samples, std::span<const PrescribedPose> poses, bool respect_direction, Role role)
    : dyads(std::move(samples)) {
  require(!poses.empty() && poses.size() <= max_poses, "one to five poses are judged");
  const std::size_t count = dyads.size();
  for (std::vector<double>* column : {&center_x, &center_y, &circle_x, &circle_y, &length}) column->assign(count, 0);
  arm_x.assign(poses.size(), std::vector<double>(count, 0));
  arm_y.assign(poses.size(), std::vector<double>(count, 0));
  admissible_directions.assign(count, 0);
  at_least_half_turn.assign(count, 0);
  sweep_ccw.assign(count, 0);
  const Pose& first = poses.front().pose;
  std::vector<Point> turns;
  for (const PrescribedPose& pose : poses) turns.push_back(direction(pose.pose.angle - first.angle));
  for (std::size_t i = 0; i < count; ++i) {
    const auto center = finite_point(dyads[i].center), circle = finite_point(dyads[i].circle);
    if (!center || !circle) continue;  // a slider: length 0 makes its pairs degenerate
    center_x[i] = center->real();
    center_y[i] = center->imag();
    circle_x[i] = circle->real();
    circle_y[i] = circle->imag();
    length[i] = std::abs(*circle - *center);
    for (std::size_t j = 0; j < poses.size(); ++j) {
      const Point arm = poses[j].pose.origin + turns[j] * (*circle - first.origin) - *center;
      arm_x[j][i] = arm.real();
      arm_y[j][i] = arm.imag();
    }
    if (role == Role::driven) continue;
    const DriverSequence order = driver_sequence(*center, *circle, poses, respect_direction);
    admissible_directions[i] = order.senses();
    at_least_half_turn[i] = order.half_turn_senses();
    sweep_ccw[i] = static_cast<float>(order.sweep_ccw);
  }
}

void classify_pairs(RegionMap& map, const DyadAxis& input, const DyadAxis& output, double unit,
                    const RegionOptions& options, const Progress& progress) {
  require(input.pose_count() == output.pose_count(), "both axes are of one task");
  map.lay(coordinates_of(input.dyads), coordinates_of(output.dyads), planar_measures,
          pairs_decide_sense(input, input.pose_count()), options);
  map.set_diagonal(diagonal_of(input.dyads, output.dyads, same_points));
  const std::size_t rows = map.rows(), columns = map.columns();
  for (std::size_t row = 0; row < rows; ++row) map.set_driver(row, driver_travel(input, row));
  const KernelTask task{
      plain_arrays(input),     plain_arrays(output),      0, rows, columns, static_cast<int>(input.pose_count()), unit,
      tolerance::change_point, kernel_cells(map.cells(0))};
  run_rows(map, task, four_bar_kernel.for_simd(options.simd), options, progress);
}

void classify_rows(RegionMap& map, std::span<const double> input, std::span<const double> output,
                   const std::function<FourBarRow(std::size_t row)>& row_at, double unit, const RegionOptions& options,
                   const Progress& progress, AlongRow changes) {
  constexpr bool of_pairs = true;
  map.lay(input, output, planar_measures, of_pairs, options);
  if (changes == AlongRow::driving_link) map.give_each_cell_a_driver();
  parallel_for(map.rows(), options.threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      if (progress.is_cancelled())
        map.leave_empty(row, row + 1);
      else
        classify_row(map, row, row_at(row), unit, options.simd, changes);
    }
  });
}

}  // namespace linkwright
