#include "linkwright/planar/linkage_family.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "linkwright/core/tolerance.hpp"
#include "planar/side_link.hpp"

namespace linkwright {
namespace {

constexpr std::array<std::string_view, 7> quantity_names = {
    "curve_coordinate", "burmester_point", "side_direction", "side_length", "output_scale", "pair_output", "nothing"};

FamilyAxis curve_axis(const BurmesterCurve& curve) { return {AxisQuantity::curve_coordinate, curve.branches()}; }

FamilyAxis point_axis(std::size_t count) {
  FamilyAxis axis{AxisQuantity::burmester_point, {}};
  for (std::size_t i = 0; i < count; ++i)
    axis.branches.push_back({"point", static_cast<double>(i), static_cast<double>(i + 1)});
  return axis;
}

}  // namespace

std::string_view name(AxisQuantity quantity) { return quantity_names[static_cast<std::size_t>(quantity)]; }

AxisStretch stretch_around(const FamilyAxis& axis, double tau) {
  const double branch = std::floor(tau);
  return {branch, branch + 1, axis.is_closed()};
}

std::vector<double> samples_within(const LinkageFamily& family, LinkageFamily::Side side,
                                   const std::optional<RegionWindow>& window, int count, Spacing spacing) {
  if (!window || family.axis(side).is_discrete()) return family.samples(side, count, spacing);
  const auto [low, high] = side == LinkageFamily::Side::input ? window->input : window->output;
  std::vector<double> coordinates;
  for (int i = 0; i < count; ++i) coordinates.push_back(low + (high - low) * (i + 0.5) / count);
  return coordinates;
}

bool is_within(const LinkageFamily& family, const std::optional<RegionWindow>& window, RegionPlace place) {
  using Side = LinkageFamily::Side;
  const auto holds = [&](Side side, const std::array<double, 2>& interval, double tau) {
    return family.axis(side).is_discrete() || (tau >= interval[0] && tau <= interval[1]);
  };
  return !window ||
         (holds(Side::input, window->input, place.input) && holds(Side::output, window->output, place.output));
}

std::optional<FourBar> four_bar_of(const SideLinks& links) {
  const auto a = finite_point(links.input.center), b = finite_point(links.input.circle);
  const auto c = finite_point(links.output.center), d = finite_point(links.output.circle);
  if (!a || !b || !c || !d) return std::nullopt;
  return FourBar{*a, *b, *c, *d};
}

RequirementFilter filter_of(const LinkageFamily& family, const RegionMap& map, const Requirements& requirements) {
  const WorkingFrame& frame = family.frame();
  const bool boxed = requirements.ground_pivots_within || requirements.moving_pivots_within;
  if (!boxed || !map.input_dyads().empty()) return {map, requirements, frame.origin, frame.scale};
  const auto links_at = family.links_of_cells(map.input_coordinates(), map.output_coordinates());
  const auto pivots_at = [&family, links_at](std::size_t row,
                                             std::size_t column) -> std::optional<RequirementFilter::Pivots> {
    const auto links = links_at(row, column);
    const auto bars = links ? four_bar_of(*links) : std::nullopt;
    if (!bars) return std::nullopt;
    const auto user = [&](Point p) { return family.frame().to_user(p); };
    return RequirementFilter::Pivots{{user(bars->input_center), user(bars->output_center)},
                                     {user(bars->input_circle), user(bars->output_circle)}};
  };
  return {map, requirements, frame.origin, frame.scale, pivots_at};
}

LinkageFamily::LinksOfCells LinkageFamily::links_of_cells(std::span<const double> input,
                                                          std::span<const double> output) const {
  return [this, input, output](std::size_t row, std::size_t column) {
    return side_links({input[row], output[column]});
  };
}

double LinkageFamily::axis_value(Side /*side*/, double tau) const { return tau; }

std::vector<double> LinkageFamily::samples(Side side, int count, Spacing /*spacing*/) const {
  const FamilyAxis& along = axis(side);
  std::vector<double> coordinates;
  if (along.is_discrete()) {
    for (const CurveBranch& branch : along.branches) coordinates.push_back((branch.from + branch.to) / 2);
    return coordinates;
  }
  for (int i = 0; i < count && along.coordinate_length() > 0; ++i)
    coordinates.push_back(along.coordinate_length() * (i + 0.5) / count);
  return coordinates;
}

MotionFamily::MotionFamily(WorkingFrame frame, std::vector<PrescribedPose> poses, FamilyAxis input, FamilyAxis output)
    : LinkageFamily(frame, std::move(input), std::move(output)),
      user_poses_(std::move(poses)),
      working_poses_(frame.to_working(user_poses_)) {}

std::optional<SideLinks> ProductFamily::side_links(RegionPlace place) const {
  const auto input = dyad(Side::input, place.input), output = dyad(Side::output, place.output);
  if (!input || !output) return std::nullopt;
  return SideLinks{*input, *output};
}

std::optional<SideLinks> ProductFamily::side_links_beside(RegionPlace place, const SideLinks& known) const {
  const auto input = known.input.coordinate == place.input ? known.input : dyad(Side::input, place.input);
  if (!input) return std::nullopt;
  const auto output = known.output.coordinate == place.output ? known.output : dyad(Side::output, place.output);
  return output ? std::optional(SideLinks{*input, *output}) : std::nullopt;
}

std::vector<Dyad> ProductFamily::polygon(Side side) const {
  constexpr int corners_of_a_branch = 512;
  const int branches = static_cast<int>(axis(side).branches.size());
  std::vector<Dyad> corners;
  for (const double tau : samples(side, corners_of_a_branch * branches, Spacing::coordinate))
    if (const auto corner = dyad(side, tau)) corners.push_back(*corner);
  return corners;
}

RegionAxis ProductFamily::region_axis(Side side, std::span<const double> coordinates, bool respect_direction) const {
  std::vector<Dyad> dyads;
  dyads.reserve(coordinates.size());
  for (const double tau : coordinates) dyads.push_back(dyad(side, tau).value_or(no_dyad(tau)));
  return {std::move(dyads), working_poses(), respect_direction};
}

void ProductFamily::fill(RegionMap& map, std::span<const double> input, std::span<const double> output,
                         bool respect_direction, const RegionOptions& options, const Progress& progress) const {
  const RegionAxis rows = region_axis(Side::input, input, respect_direction);
  if (is_symmetric() && std::equal(input.begin(), input.end(), output.begin(), output.end()))
    return map.recompute(rows, rows, frame().scale, options, progress);
  map.recompute(rows, region_axis(Side::output, output, respect_direction), frame().scale, options, progress);
}

CurveFamily::CurveFamily(const WorkingFrame& frame, std::vector<PrescribedPose> poses,
                         std::shared_ptr<const BurmesterCurve> curve)
    : ProductFamily(frame, std::move(poses), curve_axis(*curve), curve_axis(*curve)),
      curve_(std::move(curve)),
      lengths_(std::make_shared<const LengthCheck>(working_poses())) {}

// Sliders have no length to keep.
std::optional<Dyad> CurveFamily::dyad(Side /*side*/, double tau) const {
  const Dyad found = curve_->dyad(tau);
  const auto center = finite_point(found.center), circle = finite_point(found.circle);
  if (!center || !circle || lengths_->residual(*center, *circle) <= tolerance::side_link_length) return found;
  return std::nullopt;
}

std::vector<double> CurveFamily::samples(Side /*side*/, int count, Spacing spacing) const {
  return curve_->samples(count, spacing);
}

std::vector<Dyad> CurveFamily::polygon(Side /*side*/) const {
  return curve_->coordinate_length() == 0 ? std::vector<Dyad>{} : curve_->polygon(drawn_side);
}

PointFamily::PointFamily(const WorkingFrame& frame, std::vector<PrescribedPose> poses, std::vector<Dyad> dyads)
    : ProductFamily(frame, std::move(poses), point_axis(dyads.size()), point_axis(dyads.size())),
      dyads_(std::move(dyads)) {}

std::optional<Dyad> PointFamily::dyad(Side /*side*/, double tau) const {
  if (!(tau >= 0 && tau < static_cast<double>(dyads_.size()))) return std::nullopt;
  Dyad found = dyads_[static_cast<std::size_t>(tau)];
  found.coordinate = std::floor(tau) + 0.5;
  return found;
}

}  // namespace linkwright
