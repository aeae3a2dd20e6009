#include <algorithm>

#include "four_bar_kind.hpp"
#include "planar/function_family.hpp"

namespace linkwright {
namespace {

// Of a map with a curve of its own to each column.
constexpr int most_samples_over_a_free_parameter = 500;
// Of a map with some ten linkages to be solved and judged at each place.
constexpr int most_samples_over_arms = 240;

// With a free parameter the curve is another at each value of it.
bool lies_along_its_curve(const TaskFamily& given, Side side) {
  if (!given.curve || !given.family) return given.curve != nullptr;
  const MapAxis& axis = given.family->axis(side);
  return axis.quantity == AxisQuantity::curve_coordinate && axis.branches.size() == given.curve->branches().size();
}

// Where there are none to be paired, those of the curve all the same.
std::vector<Dyad> polygon_of(const TaskFamily& given, Side side) {
  if (given.family) return given.family->polygon(side);
  const bool has_places = given.curve && given.curve->coordinate_length() > 0;
  return has_places ? given.curve->polygon(drawn_side) : std::vector<Dyad>{};
}

Notice why_degenerate(const TaskFamily& given, MapPoint place) {
  const auto links = given.family->dyad_pair(place);
  if (!links || links->input.circle == Homogeneous{} || links->output.circle == Homogeneous{})
    return {"no_linkage", "There is no linkage here: no grounded link of this length can have this direction.", {}};
  if (is_at_infinity(links->input.center) || is_at_infinity(links->output.center))
    return {"slider_fixed", "Slider: the fixed pivot is at infinity; the pin moves on a straight guide.", {}};
  if (is_at_infinity(links->input.circle) || is_at_infinity(links->output.circle))
    return {
        "slider_moving", "Slider: the moving pivot is at infinity; a guide in the body slides on the fixed pivot.", {}};
  return {"zero_link", "A link has no length: this is no four-bar.", {}};
}

// The freed pose is none of those that are passed.
std::vector<int> passed_positions(const TaskFamily& given, std::size_t count) {
  std::vector<int> numbers;
  for (std::size_t pose = 0; pose < count; ++pose)
    numbers.push_back(static_cast<int>(pose) + (given.relaxed && pose >= given.relaxed->index ? 2 : 1));
  return numbers;
}

}  // namespace

namespace {

// What a fit keeps to.
bool is_fitted_alike(const Problem& a, const Problem& b) {
  const Requirements &one = a.requirements, &other = b.requirements;
  return one.max_length == other.max_length && one.min_length == other.min_length &&
         one.max_link_ratio == other.max_link_ratio && one.min_transmission_angle == other.min_transmission_angle &&
         one.ground_pivots_within == other.ground_pivots_within &&
         one.moving_pivots_within == other.moving_pivots_within && a.options.fit == b.options.fit;
}

}  // namespace

bool serves(const MotionAnswer& known, const Problem& before, const Problem& now) {
  if (known.task.is_fitted()) return is_fitted_alike(before, now);
  return !known.task.given;  // what is given may leave a length, which is chosen by the requirements
}

bool serves(const PathAnswer& known, const Problem& before, const Problem& now) {
  if (known.task.is_approximate()) return is_fitted_alike(before, now);
  return known.family() == nullptr || known.family()->axis(Side::input).layers == 0;  // of layers requirements choose
}

Requirements with_defaults(Requirements wanted, const FourBarAnswer& known) {
  return with_defaults(std::move(wanted), known.given);
}

Notice nothing_on_map(const FourBarAnswer& /*known*/, const RegionMap& /*map*/) {
  return {"no_pair",
          "No pair of dyads makes a four-bar: in every pair a pivot is at infinity or a link has no length.",
          {}};
}

namespace {

// Of a few linkages that are found whole, one of the output's axis each: their links by the coordinate there.
std::vector<Dyad> links_of_few(const FourBarFamily& family, Side side) {
  std::vector<Dyad> links;
  const MapAxis& output = family.axis(Side::output);
  if (family.axis(Side::input).quantity != AxisQuantity::nothing || !output.is_discrete()) return links;
  for (const CurveBranch& one : output.branches) {
    const double coordinate = (one.from + one.to) / 2;
    const auto pair = family.dyad_pair({0.5, coordinate});
    if (!pair) continue;
    links.push_back(side == Side::input ? pair->input : pair->output);
    links.back().coordinate = coordinate;
  }
  return links;
}

}  // namespace

LinkPolygon links_along(const FourBarAnswer& known, Side side) {
  LinkPolygon polygon;
  const FourBarFamily* family = known.family();
  std::vector<Dyad> links = polygon_of(known.given, side);
  // Where nothing is left to choose of the output, it moves with the input; a few found whole, with the output.
  bool along_input = side == Side::input;
  if (family != nullptr && links.empty()) {
    links = links_of_few(*family, side);
    along_input = false;
  } else if (family != nullptr && family->axis(side).quantity == AxisQuantity::nothing) {
    along_input = true;
  }
  const auto branches = family              ? family->axis(along_input ? Side::input : Side::output).branches
                        : known.given.curve ? known.given.curve->branches()
                                            : std::vector<CurveBranch>{};
  append_links(polygon, links, branches, known.given.frame());
  return polygon;
}

std::vector<CurveMark> marks_of(const MotionAnswer& known) {
  const std::vector<PrescribedPose>& poses = known.task.poses;
  const TaskFamily& given = known.given;
  if (!given.curve || poses.empty()) return {};
  return curve_marks(poses, *given.curve, given.frame(), polygon_of(given, Side::input));
}

ShownAxis shown_axis(const FourBarAnswer& known, Side side, int order, const ShownAxis* before) {
  const TaskFamily& given = known.given;
  const Spacing spacing = known.options.spacing;
  if (!lies_along_its_curve(given, side))
    return given.family ? shown_by_samples(*given.family, side, spacing) : ShownAxis{};
  ShownAxis shown;
  if (given.family)
    shown.axis = given.family->axis(side);
  else
    shown.axis.branches = given.curve->branches();
  shown.order = order == MapRequest::nearest_order && before
                    ? DisplayOrder::nearest(*given.curve, spacing, given.frame(), before->order)
                    : DisplayOrder(*given.curve, spacing, given.frame(), std::max(order, 0));
  return shown;
}

std::vector<double> coordinates_of(const FourBarAnswer& known, const LinkageFamily& family, const MapRequest& request,
                                   const ShownAxis& shown, Side side) {
  const bool is_whole = (side == Side::input ? request.input : request.output) == MapRequest::whole;
  if (is_whole && !shown.axis.is_discrete() && lies_along_its_curve(known.given, side))
    return shown.order.samples(*known.given.curve, request.samples);
  const bool has_linkages_to_each =
      family.axis(Side::input).layers > 0 || family.axis(Side::output).quantity == AxisQuantity::layer;
  if (is_whole && has_linkages_to_each)  // as solve() has them, to the last bit
    return family.samples(side, request.samples, Spacing::coordinate);
  return coordinates_of(static_cast<const Findings&>(known), family, request, shown, side);
}

int live_samples(const PathAnswer& known, int asked) {
  const bool has_layers = known.family() && known.family()->axis(Side::input).layers > 0;
  return has_layers ? std::min(asked, most_samples_over_arms) : asked;
}

int live_samples(const FunctionAnswer& known, int asked) {
  return known.task.free ? std::min(asked, most_samples_over_a_free_parameter) : asked;
}

std::vector<MissedBox> boxes_missed(const FourBarAnswer& known) {
  return missed_boxes(*known.family(), known.requirements);
}

bool write_property(const MotionAnswer& known, const ColouredMap& map, std::string_view property,
                    std::span<float> values) {
  if (property != "pose_miss" || !known.given.relaxed) return false;
  pose_errors(*known.family(), map.region, map.fails, *known.given.relaxed, values);
  for (float& value : values) value = std::max(value, 0.0F);
  return true;
}

bool write_property(const FunctionAnswer& known, const ColouredMap& map, std::string_view property,
                    std::span<float> values) {
  if (property != "max_structural_error_deg" || !known.task.function || known.task.free) return false;
  structural_errors_deg(*known.given.functions, map.region, values);
  return true;
}

std::optional<FourBarSolution> solution_at(const MotionAnswer& known, MapPoint place, bool verify) {
  return linkage_at(known, place, verify);
}

std::optional<FourBarSolution> solution_at(const FunctionAnswer& known, MapPoint place, bool verify) {
  auto found = linkage_at(known, place, verify);
  if (found && known.given.functions) measure_function(*found, *known.given.functions);
  return found;
}

std::optional<FourBarSolution> solution_at(const PathAnswer& known, MapPoint place, bool verify) {
  return linkage_at(known, place, verify);
}

void describe(PickedLinkage& picked, const FourBarAnswer& known, const FourBarSolution* found) {
  if (found == nullptr) {
    picked.reason = why_degenerate(known.given, picked.place);
    return;
  }
  const std::vector<PrescribedPose> poses = known.family()->user_poses(picked.place, found->four_bar);
  const PoseVisits visits = pose_visits(found->four_bar, poses);
  picked.positions = passed_positions(known.given, poses.size());
  picked.travel = travel_of(visits, poses);
  picked.reason = defect_notice(found->report.defects, visits, picked.positions);
}

double residual_of(const FourBarSolution& found) {
  return std::max(found.input_residual * found.lengths.input, found.output_residual * found.lengths.output);
}

const GeneratorFamily* generators_of(const FunctionAnswer& known) { return known.given.functions.get(); }

}  // namespace linkwright
