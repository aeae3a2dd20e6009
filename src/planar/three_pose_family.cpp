#include "three_pose_family.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/four_bar.hpp"

namespace linkwright {
namespace {

double place_in_branch(double tau) { return tau - std::floor(tau); }

MapAxis axis_of(AxisQuantity quantity, const std::vector<std::string>& names) {
  MapAxis axis{quantity, {}};
  for (std::size_t i = 0; i < names.size(); ++i)
    axis.branches.push_back({names[i], static_cast<double>(i), static_cast<double>(i + 1)});
  return axis;
}

MapAxis axis_of_length(DirectionFreedom freedom, std::size_t directions) {
  if (freedom == DirectionFreedom::free) return axis_of(AxisQuantity::side_direction, {"sheet_1", "sheet_2"});
  if (directions == 2) return axis_of(AxisQuantity::curve_coordinate, {"direction_1", "direction_2"});
  return axis_of(AxisQuantity::curve_coordinate, {"direction_1"});
}

MapAxis axis_at_angle(DirectionFreedom freedom, bool directed) {
  if (freedom == DirectionFreedom::free && directed) return axis_of(AxisQuantity::side_length, {"sheet_1", "sheet_2"});
  if (freedom == DirectionFreedom::free)
    return axis_of(AxisQuantity::side_length, {"sheet_1", "sheet_2", "sheet_1_opposite", "sheet_2_opposite"});
  if (directed) return axis_of(AxisQuantity::curve_coordinate, {"direct"});
  return axis_of(AxisQuantity::curve_coordinate, {"direct", "opposite"});
}

// Arcs as intervals of one turn, rising within [0, 1].
std::vector<std::array<double, 2>> intervals_of(const std::vector<DirectionArc>& arcs) {
  std::vector<std::array<double, 2>> intervals;
  for (const DirectionArc arc : arcs) {
    intervals.push_back({arc.from / two_pi, std::min(arc.to / two_pi, 1.0)});
    if (arc.to > two_pi && arc.from > 0) intervals.push_back({0, arc.to / two_pi - 1});
  }
  std::sort(intervals.begin(), intervals.end());
  return intervals;
}

// The place that lies `run` along the intervals.
double place_after(const std::vector<std::array<double, 2>>& intervals, double run) {
  for (const auto& [from, to] : intervals) {
    if (run < to - from) return from + run;
    run -= to - from;
  }
  return std::nextafter(intervals.back()[1], 0.0);
}

std::vector<double> evenly(const MapAxis& axis, int count) {
  std::vector<double> coordinates;
  for (int i = 0; i < count; ++i) coordinates.push_back(axis.coordinate_length() * (i + 0.5) / count);
  return coordinates;
}

}  // namespace

DyadsOfLength::DyadsOfLength(std::shared_ptr<const ThreePoseDyads> dyads, double length)
    : dyads_(std::move(dyads)),
      length_(length),
      arcs_(dyads_->directions(length)),
      axis_(axis_of_length(dyads_->freedom(), arcs_.size())) {}

double DyadsOfLength::side_direction(double tau) const {
  if (dyads_->freedom() == DirectionFreedom::free) return two_pi * place_in_branch(tau);
  if (arcs_.empty()) return 0;
  return arcs_[std::min(static_cast<std::size_t>(std::max(axis_.onto(tau), 0.0)), arcs_.size() - 1)].from;
}

std::optional<Dyad> DyadsOfLength::dyad(double coordinate) const {
  const double tau = axis_.onto(coordinate);
  if (is_empty() || !(tau >= 0 && tau < axis_.coordinate_length())) return std::nullopt;
  const Point arm = length_ * direction(side_direction(tau));
  auto found = dyads_->freedom() == DirectionFreedom::free ? dyads_->dyad(arm, static_cast<int>(tau))
                                                           : dyads_->dyad_round(arm, place_in_branch(tau));
  if (found) found->coordinate = tau;
  return found;
}

double DyadsOfLength::axis_value(double tau) const {
  return axis_.quantity == AxisQuantity::side_direction ? 360 * place_in_branch(tau) : tau;
}

std::vector<double> DyadsOfLength::samples(int count) const {
  if (is_empty() || dyads_->freedom() != DirectionFreedom::free) return evenly(axis_, count);
  const auto intervals = intervals_of(arcs_);
  double width = 0;
  for (const auto& [from, to] : intervals) width += to - from;
  std::vector<double> coordinates;
  for (int sheet = 0; sheet < 2; ++sheet) {
    const int own = (count + 1 - sheet) / 2;
    for (int i = 0; i < own; ++i) coordinates.push_back(sheet + place_after(intervals, width * (i + 0.5) / own));
  }
  return coordinates;
}

std::vector<Dyad> DyadsOfLength::polygon() const {
  constexpr int corners_of_a_branch = 512;
  constexpr double inside = 1e-9;  // of an arc: the ends are double roots, which rounding may lose
  std::vector<double> coordinates;
  if (is_empty() || dyads_->freedom() != DirectionFreedom::free) {
    coordinates = evenly(axis_, corners_of_a_branch * static_cast<int>(axis_.branches.size()));
  } else {
    const auto intervals = intervals_of(arcs_);
    for (int sheet = 0; sheet < 2; ++sheet)
      for (const auto& [from, to] : intervals) {
        const int count = std::max(2, static_cast<int>(corners_of_a_branch * (to - from)));
        for (int i = 0; i <= count; ++i) {
          const double share = std::clamp((1 - std::cos(pi * i / count)) / 2, inside, 1 - inside);
          coordinates.push_back(sheet + from + (to - from) * share);
        }
      }
  }
  std::vector<Dyad> corners;
  for (const double tau : coordinates)
    if (const auto corner = dyad(tau)) corners.push_back(*corner);
  return corners;
}

SideLengthsFamily::SideLengthsFamily(const WorkingFrame& frame, std::vector<PrescribedPose> poses,
                                     const std::shared_ptr<const ThreePoseDyads>& dyads, double input_length,
                                     double output_length)
    : SideLengthsFamily(frame, std::move(poses), DyadsOfLength(dyads, input_length / frame.scale),
                        DyadsOfLength(dyads, output_length / frame.scale)) {}

SideLengthsFamily::SideLengthsFamily(const WorkingFrame& frame, std::vector<PrescribedPose> poses, DyadsOfLength input,
                                     DyadsOfLength output)
    : ProductFamily(frame, std::move(poses), input.axis(), output.axis()),
      input_(std::move(input)),
      output_(std::move(output)) {}

std::vector<double> SideLengthsFamily::samples(Side side, int count, Spacing /*spacing*/) const {
  return of(side).samples(count);
}

SideAngleFamily::SideAngleFamily(const WorkingFrame& frame, std::vector<PrescribedPose> poses,
                                 const std::shared_ptr<const ThreePoseDyads>& dyads, double angle, bool directed,
                                 double input_length)
    : SideAngleFamily(frame, std::move(poses), dyads, angle, directed,
                      DyadsOfLength(dyads, input_length / frame.scale)) {}

SideAngleFamily::SideAngleFamily(const WorkingFrame& frame, std::vector<PrescribedPose> poses,
                                 std::shared_ptr<const ThreePoseDyads> dyads, double angle, bool directed,
                                 DyadsOfLength input)
    : MotionFamily(frame, std::move(poses), input.axis(), axis_at_angle(dyads->freedom(), directed)),
      dyads_(std::move(dyads)),
      input_(std::move(input)),
      angle_(angle) {}

double SideAngleFamily::output_length(double tau) const {
  return input_.length() * std::tan(pi / 2 * place_in_branch(tau));
}

std::optional<Dyad> SideAngleFamily::output_at(double input_direction, double coordinate) const {
  const double tau = axis(Side::output).onto(coordinate);
  if (!(tau >= 0 && tau < axis(Side::output).coordinate_length())) return std::nullopt;
  const int branch = static_cast<int>(tau);
  const bool is_free = dyads_->freedom() == DirectionFreedom::free;
  const bool opposite = branch >= (is_free ? 2 : 1);
  const double beta = input_direction + angle_ + (opposite ? pi : 0);
  std::optional<Dyad> found;
  if (is_free)
    found = dyads_->dyad(output_length(tau) * direction(beta), branch % 2);
  else if (const auto length = dyads_->length_of(beta))
    found = dyads_->dyad_round(*length * direction(beta), place_in_branch(tau));
  if (found) found->coordinate = tau;
  return found;
}

std::optional<DyadPair> SideAngleFamily::dyad_pair(MapPoint place) const {
  const auto input = input_.dyad(place.input);
  if (!input) return std::nullopt;
  const auto output = output_at(input_.side_direction(place.input), place.output);
  if (!output) return std::nullopt;
  return DyadPair{*input, *output};
}

double SideAngleFamily::axis_value(Side side, double tau) const {
  if (side == Side::input) return input_.axis_value(tau);
  return axis(side).quantity == AxisQuantity::side_length ? frame().scale * output_length(tau) : tau;
}

std::vector<double> SideAngleFamily::samples(Side side, int count, Spacing spacing) const {
  return side == Side::input ? input_.samples(count) : MotionFamily::samples(side, count, spacing);
}

std::vector<Dyad> SideAngleFamily::polygon(Side side) const {
  return side == Side::input ? input_.polygon() : std::vector<Dyad>{};
}

std::optional<AxisArcs> SideAngleFamily::arcs_within(Side side, const PivotWindows& windows) const {
  if (side == Side::output) return std::nullopt;
  return AxisArcs{arcs_of_dyads(side, windows, [&](double tau) { return input_.dyad(tau); })};
}

std::optional<std::vector<AxisArc>> SideAngleFamily::output_arcs_within(double input,
                                                                        const PivotWindows& windows) const {
  const double beta = input_.side_direction(input);
  return arcs_of_dyads(Side::output, windows, [&](double tau) { return output_at(beta, tau); });
}

void SideAngleFamily::fill(RegionMap& map, std::span<const double> input, std::span<const double> output,
                           bool respect_direction, const RegionOptions& options, const Progress& progress) const {
  const auto row_at = [&](std::size_t row) {
    const Dyad driver = input_.dyad(input[row]).value_or(no_dyad(input[row]));
    const double beta = input_.side_direction(input[row]);
    std::vector<Dyad> driven;
    driven.reserve(output.size());
    for (const double tau : output) driven.push_back(output_at(beta, tau).value_or(no_dyad(tau)));
    return FourBarRow{DyadAxis({driver}, working_poses(), respect_direction),
                      DyadAxis(std::move(driven), working_poses(), respect_direction, DyadAxis::Role::driven),
                      {}};
  };
  classify_rows(map, input, output, row_at, frame().scale, options, progress);
}

}  // namespace linkwright
