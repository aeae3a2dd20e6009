#include "given_pivot_family.hpp"

#include <cmath>
#include <limits>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/precondition.hpp"

namespace linkwright {
namespace {

MapAxis range_axis(AxisQuantity quantity) { return {quantity, {{"range", 0, 1}}}; }

MapAxis one_place() { return {AxisQuantity::nothing, {{"point", 0, 1}}}; }

MapAxis plane_axis(Side side, PivotKind kind) {
  const bool ground = kind == PivotKind::ground;
  if (side == Side::input) return range_axis(ground ? AxisQuantity::center_y : AxisQuantity::circle_y);
  return range_axis(ground ? AxisQuantity::center_x : AxisQuantity::circle_x);
}

MapAxis line_axis(PivotKind kind) {
  return range_axis(kind == PivotKind::ground ? AxisQuantity::center_on_line : AxisQuantity::circle_on_line);
}

// Amid the places that the body is led through.
Point middle_of(std::span<const PrescribedPose> poses) {
  Point sum = 0;
  for (const PrescribedPose& pose : poses) sum += pose.pose.origin;
  return sum / static_cast<double>(poses.size());
}

bool is_on(double tau) { return tau >= 0 && tau <= 1; }

}  // namespace

double PivotRange::at(double coordinate) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!(coordinate > 0)) return -infinity;
  if (!(coordinate < 1)) return infinity;
  return middle + spread * std::tan(pi * (coordinate - 0.5));
}

double PivotRange::coordinate_of(double place) const { return 0.5 + std::atan((place - middle) / spread) / pi; }

GivenPivotsFamily::GivenPivotsFamily(const WorkingFrame& frame, std::vector<PrescribedPose> poses,
                                     const DyadPair& links)
    : ProductFamily(frame, std::move(poses), one_place(), one_place()), links_(links) {}

std::optional<Dyad> GivenPivotsFamily::dyad(Side side, double tau) const {
  if (!is_on(tau)) return std::nullopt;
  Dyad link = side == Side::input ? links_.input : links_.output;
  link.coordinate = 0.5;
  return link;
}

PivotPlaceFamily::PivotPlaceFamily(const WorkingFrame& frame, std::vector<PrescribedPose> poses,
                                   std::shared_ptr<const ThreePoseDyads> dyads, Side given, const Dyad& known,
                                   PivotKind open)
    : MotionFamily(frame, std::move(poses), plane_axis(Side::input, open), plane_axis(Side::output, open)),
      dyads_(std::move(dyads)),
      given_(given),
      known_(known),
      open_(open) {
  const Point middle = middle_of(working_poses());
  ranges_ = {PivotRange{middle.real()}, PivotRange{middle.imag()}};
}

std::optional<Dyad> PivotPlaceFamily::open_dyad(MapPoint place) const {
  if (!is_on(place.input) || !is_on(place.output)) return std::nullopt;
  const auto pivot = Homogeneous::of({ranges_[0].at(place.output), ranges_[1].at(place.input)});
  if (is_at_infinity(pivot)) return std::nullopt;
  auto found = dyads_->dyad_with(open_, pivot);
  if (found) found->coordinate = given_ == Side::input ? place.output : place.input;
  return found;
}

std::optional<DyadPair> PivotPlaceFamily::dyad_pair(MapPoint place) const {
  const auto open = open_dyad(place);
  if (!open) return std::nullopt;
  Dyad known = known_;
  known.coordinate = given_ == Side::input ? place.input : place.output;
  return given_ == Side::input ? DyadPair{known, *open} : DyadPair{*open, known};
}

double PivotPlaceFamily::axis_value(Side side, double tau) const {
  return side == Side::output ? frame().to_user(Point{ranges_[0].at(tau), 0}).real()
                              : frame().to_user(Point{0, ranges_[1].at(tau)}).imag();
}

void PivotPlaceFamily::fill(RegionMap& map, std::span<const double> input, std::span<const double> output,
                            bool respect_direction, const RegionOptions& options, const Progress& progress) const {
  const bool drives = given_ == Side::input;
  const auto row_at = [&](std::size_t row) {
    std::vector<Dyad> open;
    open.reserve(output.size());
    for (const double x : output) open.push_back(open_dyad({input[row], x}).value_or(no_dyad(x)));
    DyadAxis known({known_}, working_poses(), respect_direction);
    DyadAxis others(std::move(open), working_poses(), respect_direction,
                    drives ? DyadAxis::Role::driven : DyadAxis::Role::driving);
    return drives ? FourBarRow{std::move(known), std::move(others), {}}
                  : FourBarRow{std::move(others), std::move(known), {}};
  };
  classify_rows(map, input, output, row_at, frame().scale, options, progress,
                drives ? AlongRow::driven_link : AlongRow::driving_link);
}

PivotsOnLineFamily::PivotsOnLineFamily(const WorkingFrame& frame, std::vector<PrescribedPose> poses,
                                       std::shared_ptr<const ThreePoseDyads> dyads, PivotKind kind,
                                       const DirectedLine& line)
    : ProductFamily(frame, std::move(poses), line_axis(kind), line_axis(kind)),
      dyads_(std::move(dyads)),
      kind_(kind),
      line_{frame.to_working(line.point), line.direction},
      range_{line_.to_line(middle_of(working_poses())).real()} {}

std::optional<Dyad> PivotsOnLineFamily::dyad(Side /*side*/, double tau) const {
  if (!is_on(tau)) return std::nullopt;
  const auto pivot = Homogeneous::of(line_.to_fixed(range_.at(tau)));
  if (is_at_infinity(pivot)) return std::nullopt;
  auto found = dyads_->dyad_with(kind_, pivot);
  if (found) found->coordinate = tau;
  return found;
}

double PivotsOnLineFamily::axis_value(Side /*side*/, double tau) const { return frame().scale * range_.at(tau); }

}  // namespace linkwright
