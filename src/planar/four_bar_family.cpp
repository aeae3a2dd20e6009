#include "linkwright/planar/four_bar_family.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "linkwright/core/tolerance.hpp"
#include "linkwright/planar/four_bar_map.hpp"
#include "planar/four_bar_cells.hpp"
#include "planar/length_check.hpp"

namespace linkwright {
namespace {

MapAxis curve_axis(const BurmesterCurve& curve) { return {AxisQuantity::curve_coordinate, curve.branches()}; }

MapAxis point_axis(std::size_t count) {
  MapAxis axis{AxisQuantity::burmester_point, {}};
  for (std::size_t i = 0; i < count; ++i)
    axis.branches.push_back({"point", static_cast<double>(i), static_cast<double>(i + 1)});
  return axis;
}

GroundedLinkPivots user_pivots(const WorkingFrame& frame, const Dyad& link) {
  const auto user = [&](Homogeneous point) {
    const auto p = finite_point(point);
    return p ? std::optional(in_space(frame.to_user(*p))) : std::nullopt;
  };
  return {user(link.center), user(link.circle)};
}

}  // namespace

std::optional<FourBar> four_bar_of(const DyadPair& links) {
  const auto a = finite_point(links.input.center), b = finite_point(links.input.circle);
  const auto c = finite_point(links.output.center), d = finite_point(links.output.circle);
  if (!a || !b || !c || !d) return std::nullopt;
  return FourBar{*a, *b, *c, *d};
}

Pivots pivots_of(const FourBar& bars) {
  return {{in_space(bars.input_fixed), in_space(bars.output_fixed)},
          {in_space(bars.input_moving), in_space(bars.output_moving)}};
}

FourBar four_bar_of(const Pivots& pivots) {
  const auto in_plane = [](Vector3 p) { return Point{p.x, p.y}; };
  return {in_plane(pivots.ground[0]), in_plane(pivots.moving[0]), in_plane(pivots.ground[1]),
          in_plane(pivots.moving[1])};
}

namespace {

// Before it is known what it does in the positions of the task.
Cell still_cell(MapPoint place, const FourBar& bars, const WorkingFrame& frame) {
  constexpr double not_known = std::numeric_limits<double>::quiet_NaN();
  const LinkLengths lengths = bars.lengths();
  Cell cell;
  cell.type = linkage_type(lengths);
  cell.values = {not_known, not_known, lengths.longest() / lengths.shortest(),
                 frame.scale * lengths.longest()};  // planar_measures
  cell.place = place;
  cell.pivots = pivots_of(frame.to_user(bars));
  cell.change_point_margin = change_point_margin(lengths);
  return cell;
}

}  // namespace

LinkageFamily::CellAt FourBarFamily::cells(bool respect_direction) const {
  return [this, respect_direction, known = std::optional<DyadPair>()](
             MapPoint place, const auto& is_worth_it) mutable -> std::optional<Cell> {
    const auto links = known ? dyad_pair_reusing(place, *known) : dyad_pair(place);
    const auto bars = links ? four_bar_of(*links) : std::nullopt;
    if (!bars) return std::nullopt;
    known = links;
    Cell cell = still_cell(place, *bars, frame());
    if (cell.type == LinkageType::degenerate || !is_worth_it(cell)) return std::nullopt;
    return driven(std::move(cell), find_defects(*bars, working_poses(place, *bars), respect_direction));
  };
}

MapPivots FourBarFamily::pivots(const RegionMap& map) const {
  const auto links_at = dyad_pairs_of_cells(map.input_coordinates(), map.output_coordinates());
  const auto of_cell = [this, links_at](std::size_t row, std::size_t column) -> std::optional<Pivots> {
    const auto links = links_at(row, column);
    const auto bars = links ? four_bar_of(*links) : std::nullopt;
    return bars ? std::optional(pivots_of(frame().to_user(*bars))) : std::nullopt;
  };
  return {{}, {}, of_cell};
}

FourBarFamily::DyadPairsOfCells FourBarFamily::dyad_pairs_of_cells(std::span<const double> input,
                                                                   std::span<const double> output) const {
  return [this, input, output](std::size_t row, std::size_t column) { return dyad_pair({input[row], output[column]}); };
}

std::optional<LinkageOutput> FourBarFamily::output(MapPoint place) const {
  const auto links = dyad_pair(place);
  const auto bars = links ? four_bar_of(*links) : std::nullopt;
  return bars ? std::optional(output_of(place, frame().to_user(*bars))) : std::nullopt;
}

LinkageOutput FourBarFamily::output_of(MapPoint place, const FourBar& bars) const {
  return pose_output(bars, user_poses(place, bars));
}

// All of its linkages visit the same poses.
std::shared_ptr<const FourBarCells> FourBarFamily::four_bar_cells(const RegionMap& map) const {
  return std::make_shared<const FourBarCells>(*this, map, working_poses({}, {}));
}

MotionFamily::MotionFamily(WorkingFrame frame, std::vector<PrescribedPose> poses, MapAxis input, MapAxis output)
    : FourBarFamily(frame, std::move(input), std::move(output)),
      user_poses_(std::move(poses)),
      working_poses_(frame.to_working(user_poses_)) {}

// Beside the corners of the curve places all along the axis: where it has no dyads, the stretches end.
std::vector<AxisArc> FourBarFamily::arcs_of_dyads(Side side, const PivotWindows& windows,
                                                  const std::function<std::optional<Dyad>(double tau)>& dyad_at) const {
  constexpr int knots_of_a_branch = 256;
  std::vector<double> knots;
  for (const Dyad& corner : polygon(side)) knots.push_back(corner.coordinate);
  for (const CurveBranch& branch : axis(side).branches)
    for (int i = 0; i < knots_of_a_branch; ++i)
      knots.push_back(branch.from + (branch.to - branch.from) * i / knots_of_a_branch);
  return linkwright::arcs_within(axis(side), std::move(knots), windows, [&](double tau) {
    const auto link = dyad_at(tau);
    return link ? user_pivots(frame(), *link) : GroundedLinkPivots{};
  });
}

std::optional<DyadPair> ProductFamily::dyad_pair(MapPoint place) const {
  const auto input = dyad(Side::input, place.input), output = dyad(Side::output, place.output);
  if (!input || !output) return std::nullopt;
  return DyadPair{*input, *output};
}

std::optional<DyadPair> ProductFamily::dyad_pair_reusing(MapPoint place, const DyadPair& known) const {
  const auto input = known.input.coordinate == place.input ? known.input : dyad(Side::input, place.input);
  if (!input) return std::nullopt;
  const auto output = known.output.coordinate == place.output ? known.output : dyad(Side::output, place.output);
  return output ? std::optional(DyadPair{*input, *output}) : std::nullopt;
}

MapPivots ProductFamily::pivots(const RegionMap& map) const {
  if (map.row_pivots().empty()) return FourBarFamily::pivots(map);  // a map that was filled row by row
  return {map.row_pivots(), map.column_pivots(), {}};
}

GroundedLinkPivots ProductFamily::pivots_at(Side side, double tau) const {
  const auto link = dyad(side, tau);
  return link ? user_pivots(frame(), *link) : GroundedLinkPivots{};
}

std::vector<GroundedLinkPivots> ProductFamily::pivots_of(const std::vector<Dyad>& links) const {
  std::vector<GroundedLinkPivots> found;
  found.reserve(links.size());
  for (const Dyad& link : links) found.push_back(user_pivots(frame(), link));
  return found;
}

std::optional<AxisArcs> ProductFamily::arcs_within(Side side, const PivotWindows& windows) const {
  const bool are_all = axis(side).is_discrete();
  return AxisArcs{arcs_of_dyads(side, windows, [&](double tau) { return dyad(side, tau); }), are_all};
}

std::vector<Dyad> ProductFamily::polygon(Side side) const {
  constexpr int corners_of_a_branch = 512;
  const int branches = static_cast<int>(axis(side).branches.size());
  std::vector<Dyad> corners;
  for (const double tau : samples(side, corners_of_a_branch * branches, Spacing::coordinate))
    if (const auto corner = dyad(side, tau)) corners.push_back(*corner);
  return corners;
}

std::vector<Dyad> ProductFamily::dyads(Side side, std::span<const double> coordinates) const {
  std::vector<Dyad> found;
  found.reserve(coordinates.size());
  for (const double tau : coordinates) found.push_back(dyad(side, tau).value_or(no_dyad(tau)));
  return found;
}

FourBarFamily::DyadPairsOfCells ProductFamily::dyad_pairs_of_cells(std::span<const double> input,
                                                                   std::span<const double> output) const {
  return [rows = dyads(Side::input, input), columns = dyads(Side::output, output)](
             std::size_t row, std::size_t column) -> std::optional<DyadPair> {
    return DyadPair{rows[row], columns[column]};
  };
}

void ProductFamily::fill(RegionMap& map, std::span<const double> input, std::span<const double> output,
                         bool respect_direction, const RegionOptions& options, const Progress& progress) const {
  const DyadAxis rows(dyads(Side::input, input), working_poses(), respect_direction);
  if (is_symmetric() && std::equal(input.begin(), input.end(), output.begin(), output.end())) {
    classify_pairs(map, rows, rows, frame().scale, options, progress);
    return map.set_pivots(pivots_of(rows.dyads), pivots_of(rows.dyads));
  }
  const DyadAxis columns(dyads(Side::output, output), working_poses(), respect_direction);
  classify_pairs(map, rows, columns, frame().scale, options, progress);
  map.set_pivots(pivots_of(rows.dyads), pivots_of(columns.dyads));
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

std::optional<AxisArcs> CurveFamily::arcs_within(Side side, const PivotWindows& windows) const {
  std::vector<double> borders;
  const auto append = [&](const std::vector<double>& more) { borders.insert(borders.end(), more.begin(), more.end()); };
  const auto meet = [&](const std::optional<PivotWindow>& window, auto coordinates_on) {
    if (!window) return;
    const Box& box = std::get<Box>(*window);
    const auto side_line = [&](Point p, Point q) {
      return cross(frame().to_working(Homogeneous::of(p)), frame().to_working(Homogeneous::of(q)));
    };
    const Point low{box.x_low, box.y_low}, high{box.x_high, box.y_high};
    for (const Point corner : {low, high})
      for (const Point along : {Point{frame().scale, 0}, Point{0, frame().scale}})
        append(coordinates_on(side_line(corner, corner + along)));
  };
  meet(windows.ground, [&](Homogeneous line) { return curve_->coordinates_of_centers_on(line); });
  meet(windows.moving, [&](Homogeneous line) { return curve_->coordinates_of_circles_on(line); });
  constexpr bool are_all = true;
  return AxisArcs{
      arcs_where(axis(side), std::move(borders), [&](double tau) { return windows.hold(pivots_at(side, tau)); }),
      are_all};
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
