#include "answer_check.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "line_check.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/region/measure.hpp"
#include "load_check.hpp"
#include "path_check.hpp"
#include "tolerance_check.hpp"

namespace linkwright::soak {
namespace {

using nlohmann::json;
using Wrongs = std::vector<std::string>;

constexpr double rounding = 1e-6;  // of limits that a linkage may stand right on

/// Keys that may be null by the schema; any other null was no number.
const std::set<std::string>& keys_that_may_be_null() {
  static const std::set<std::string> keys = {"condition",
                                             "kappa",
                                             "center_point",
                                             "circle_point",
                                             "drive",
                                             "driver_sweep_deg",
                                             "min_transmission_angle_deg",
                                             "min_transmission_angle_full_turn_deg",
                                             "min_transmission_angles_of_dyads_deg",
                                             "errors_at_pairs_deg",
                                             "max_structural_error_deg",
                                             "error_deg",
                                             "curve",
                                             "region",
                                             "miss",
                                             "linkage",
                                             "reason",
                                             "value",
                                             "types",
                                             "max_link_ratio",
                                             "max_length",
                                             "min_length",
                                             "ground_pivots_within",
                                             "moving_pivots_within",
                                             "given",
                                             "free",
                                             "window",
                                             "values",  // of an axis: the window reaches beyond it
                                             "chain",
                                             "box",
                                             "x",
                                             "y",
                                             "freed_pose",
                                             "range",
                                             "input_length",
                                             "miss_deg",
                                             "min_link_angle_deg",
                                             "max_link_angle_deg",
                                             "fixed_axes_within",
                                             "moving_axes_within",
                                             "deviation",
                                             "max_deviation",
                                             "stroke",
                                             "cubic_n",
                                             "crank_range_deg",
                                             "velocity_nonuniformity",
                                             "pole",
                                             "pole_tangent_deg",
                                             "inflection_diameter",
                                             "inflection_pole",
                                             "inflection_circle",
                                             "return_circle",
                                             "bresse_circle",
                                             "acceleration_pole",
                                             "body_rate",
                                             "body_acceleration",
                                             "invariants",
                                             "cubic",
                                             "ball_point",
                                             "center_of_curvature",
                                             "radius_of_curvature",
                                             "tolerance",
                                             "signal_to_noise_db",
                                             "yield",
                                             "yield_interval",
                                             "allocation",
                                             "circuit_order",
                                             "cognate",
                                             "moving_pivot",
                                             "crank_length",
                                             "point_arm",
                                             "loads",
                                             "gravity",
                                             "rpm",
                                             "measured_at",
                                             "percent_per_10K",
                                             "path",
                                             "max_path_error",
                                             "grashof_margin",
                                             "max_open_force",
                                             "max_close_force",
                                             "hold_open",
                                             "close_start",
                                             "hump",
                                             "pop_up",
                                             "self_rise",
                                             "self_close",
                                             "input_ground",
                                             "input_coupler",
                                             "output_coupler",
                                             "output_ground",
                                             "max_torque",
                                             "cylinder_force",
                                             "stroke_left",
                                             "bottoms_at",
                                             "least_lever"};
  return keys;
}

void look_for_nulls(const json& value, const std::string& key, Wrongs& wrongs) {
  if (value.is_null() && !keys_that_may_be_null().contains(key)) wrongs.push_back(key + " is no number");
  if (value.is_object())
    for (const auto& [name, member] : value.items()) look_for_nulls(member, name, wrongs);
  if (value.is_array())
    for (const json& element : value) look_for_nulls(element, key, wrongs);
}

void check_region_values(const RegionMap& map, Wrongs& wrongs) {
  std::vector<float> values(map.columns());
  for (const Measure& measure : map.reported_measures()) {
    if (measure == measures::tolerance_error || measure == measures::yield) continue;  // infinite, or not sampled
    for (std::size_t row = 0; row < map.rows(); ++row) {
      row_values(map, measure, row, values);
      if (std::all_of(values.begin(), values.end(), [](float value) { return std::isfinite(value); })) continue;
      wrongs.push_back(fmt::format("{} of the region is no number", measure.key));
      break;
    }
  }
}

void check_counts(const Problem& problem, const json& result, Wrongs& wrongs) {
  const json& region = result["region"];
  if (region.is_null()) return;
  const json& counts = region["counts"];
  std::int64_t of_types = 0;
  for (const LinkageType type : linkages(problem.task).types)
    of_types += counts[std::string(name(type))].get<std::int64_t>();
  const auto count = [&](const char* key) { return counts[key].get<std::int64_t>(); };
  const std::int64_t whole = count("pairs") - count("degenerate");
  if (of_types != count("pairs")) wrongs.push_back("the types do not add up to the pairs");
  if (count("circuit") > count("branch")) wrongs.push_back("more circuit than branch defects");
  if (count("order") + count("branch") + count("defect_free") != whole)
    wrongs.push_back("defects and what is free of them do not add up to the pairs");
  const auto meeting = region["meeting_requirements"].get<std::int64_t>();
  const bool no_defects = result["problem"]["requirements"].value("no_defects", true);
  if (meeting > (no_defects ? count("defect_free") : whole)) wrongs.push_back("more linkages meet than there are");
}

Point point_of(const json& value) { return {value[0].get<double>(), value[1].get<double>()}; }

bool is_inside(const json& box, Point p) {
  const auto within = [](const json& interval, double value) {
    const double low = interval[0], high = interval[1];
    const double slack = rounding * (high - low);
    return value >= low - slack && value <= high + slack;
  };
  return within(box["x"], p.real()) && within(box["y"], p.imag());
}

/// A linkage as requirements look at it.
struct Looked {
  const json& entry;
  std::vector<double> lengths;
  std::vector<Point> ground, moving;
};

/// Of straight lines only contacts at places can have some.
bool no_defects(const json& entry) {
  if (!entry.contains("defects")) return true;
  const json& defects = entry["defects"];
  return !defects["order"].get<bool>() && !defects["branch"].get<bool>() && !defects["circuit"].get<bool>();
}

/// A limit of the requirements that is a number.
std::optional<double> limit(const json& wanted, const char* key) {
  const auto found = wanted.find(key);
  return found == wanted.end() || found->is_null() ? std::nullopt : std::optional(found->get<double>());
}

void check_box(const json& wanted, const char* key, const std::vector<Point>& pivots, Wrongs& wrongs) {
  const auto found = wanted.find(key);
  if (found == wanted.end() || found->is_null()) return;
  for (const Point pivot : pivots)
    if (!is_inside(*found, pivot)) wrongs.push_back(fmt::format("a pivot lies outside {}", key));
}

void check_requirements(const json& wanted, const Looked& linkage, Wrongs& wrongs) {
  const json& entry = linkage.entry;
  const bool usable = no_defects(entry);
  if (wanted.value("no_defects", true) && !usable) wrongs.push_back("listed with a defect");
  if (const auto types = wanted.find("types"); types != wanted.end() && types->is_array() && !types->empty())
    if (std::find(types->begin(), types->end(), entry["type"]) == types->end())
      wrongs.push_back("not of a type wanted");
  const auto angle = limit(wanted, "min_transmission_angle_deg");
  if (angle && *angle > 0 && usable && entry["min_transmission_angle_deg"].get<double>() < *angle - rounding)
    wrongs.push_back("less than the least transmission angle");
  if (linkage.lengths.empty()) return;
  const auto [least, most] = std::minmax_element(linkage.lengths.begin(), linkage.lengths.end());
  const auto ratio = limit(wanted, "max_link_ratio"), longest = limit(wanted, "max_length");
  const auto shortest = limit(wanted, "min_length");
  if (ratio && *most > *ratio * *least * (1 + rounding)) wrongs.push_back("more than max_link_ratio");
  if (longest && *most > *longest * (1 + rounding)) wrongs.push_back("longer than max_length");
  if (shortest && *least < *shortest * (1 - rounding)) wrongs.push_back("shorter than min_length");
  check_box(wanted, "ground_pivots_within", linkage.ground, wrongs);
  check_box(wanted, "moving_pivots_within", linkage.moving, wrongs);
}

void check_confirmed(const json& entry, const std::string& which, Wrongs& wrongs) {
  if (no_defects(entry) && !entry["verified_by_driving"].get<bool>())
    wrongs.push_back(fmt::format("unconfirmed: {} is free of defects, and driving does not confirm it", which));
}

Vector3 vector_of(const json& value) { return {value[0], value[1], value[2]}; }

/// Axes in their cones and angles of the links; an angle and its supplement are the same link.
void check_spherical(const json& wanted, const json& entry, Wrongs& wrongs) {
  for (const auto& [name, angle] : entry["angles_deg"].items()) {
    const double acute = std::min(angle.get<double>(), 180 - angle.get<double>());
    const auto least = limit(wanted, "min_link_angle_deg"), most = limit(wanted, "max_link_angle_deg");
    if (least && acute < *least - rounding) wrongs.push_back("a link below min_link_angle_deg");
    if (most && acute > *most + rounding) wrongs.push_back("a link above max_link_angle_deg");
  }
  for (const auto& [key, end] : {std::pair("fixed_axes_within", "fixed_axis"), {"moving_axes_within", "moving_axis"}}) {
    const auto cone = wanted.find(key);
    if (cone == wanted.end() || cone->is_null()) continue;
    const Vector3 axis = normalized(vector_of((*cone)["axis"]));
    for (const char* side : {"input", "output"}) {
      const double cosine = std::abs(dot(axis, vector_of(entry[side][end])));
      if (degrees(std::acos(std::min(cosine, 1.0))) > (*cone)["half_angle_deg"].get<double>() + 1e-5)
        wrongs.push_back(fmt::format("an axis lies outside {}", key));
    }
  }
}

/// The angle between both axes of a dyad over finite orientations.
void check_dyad_angle(const std::vector<PrescribedOrientation>& orientations, const json& dyad,
                      const std::string& which, Wrongs& wrongs) {
  const Vector3 fixed = vector_of(dyad["fixed_axis"]), moving = vector_of(dyad["moving_axis"]);
  for (const PrescribedOrientation& there : orientations) {
    const Vector3 moved = turned(moving, orientations.front().orientation, there.orientation);
    if (!(std::abs(dot(fixed, moved - moving)) <= 1e-9))
      wrongs.push_back(fmt::format("{} changes its angle by {:.1e}", which, dot(fixed, moved - moving)));
  }
}

/// How far rounding of the coordinates alone can change a length, relative.
double coordinate_rounding(Point a, Point b) {
  return 1e-14 * (std::abs(a) + std::abs(b)) / std::max(std::abs(b - a), 1e-300);
}

/// Worst relative change of a grounded link's length over finite poses.
double length_change(const std::vector<PrescribedPose>& poses, Point center, Point circle) {
  const double length = std::abs(circle - center);
  double worst = 0;
  for (const PrescribedPose& pose : poses) {
    const double here = std::abs(displaced(circle, poses.front().pose, pose.pose) - center);
    worst = std::max(worst, std::abs(here - length) / length);
  }
  return worst;
}

void check_grounded_link(const std::vector<PrescribedPose>& poses, const json& dyad, const std::string& which,
                         Wrongs& wrongs) {
  constexpr double most = 1e-6;  // what the solver leaves out by its own word
  if (dyad["center_point"].is_null() || dyad["circle_point"].is_null()) return;
  const Point center = point_of(dyad["center_point"]), circle = point_of(dyad["circle_point"]);
  double noise = coordinate_rounding(center, circle);
  for (const PrescribedPose& pose : poses)
    noise = std::max(noise, coordinate_rounding(pose.pose.origin, circle) * std::abs(circle - pose.pose.origin) /
                                std::abs(circle - center));
  const double change = length_change(poses, center, circle);
  if (!(change <= most + noise))
    wrongs.push_back(fmt::format("{} changes its length by {:.1e} over the poses", which, change));
}

/// Of its links; not the arms from them to a point.
std::vector<double> four_bar_lengths(const json& entry) {
  std::vector<double> lengths;
  for (const char* link : {"ground", "input", "coupler", "output"})
    lengths.push_back(entry["lengths"][link].get<double>());
  return lengths;
}

Looked four_bar_looked_at(const json& entry) {
  Looked linkage{entry, four_bar_lengths(entry), {}, {}};
  for (const char* side : {"input", "output"}) {
    if (entry[side]["center_point"].is_array()) linkage.ground.push_back(point_of(entry[side]["center_point"]));
    if (entry[side]["circle_point"].is_array()) linkage.moving.push_back(point_of(entry[side]["circle_point"]));
  }
  return linkage;
}

Looked line_looked_at(const json& entry) {
  const json& pivots = entry["pivots"];
  Looked linkage{entry,
                 {},
                 {point_of(pivots["input_fixed"]), point_of(pivots["output_fixed"])},
                 {point_of(pivots["input_moving"]), point_of(pivots["output_moving"])}};
  for (const auto& [name, length] : entry["lengths"].items()) linkage.lengths.push_back(length.get<double>());
  return linkage;
}

Looked six_bar_looked_at(const json& entry) {
  Looked linkage{entry, {}, {}, {}};
  for (const auto& [name, length] : entry["lengths"].items()) linkage.lengths.push_back(length.get<double>());
  std::set<std::string> on_ground = {"a"};
  for (std::size_t link = 0; link < 2; ++link)
    if (entry["added"][link]["between"].get<std::string>().starts_with("0")) on_ground.insert(link == 0 ? "c4" : "c5");
  for (const auto& [name, point] : entry["joints"].items())
    (on_ground.contains(name) ? linkage.ground : linkage.moving).push_back(point_of(point));
  return linkage;
}

void check_residuals(const json& entry, Wrongs& wrongs) {
  constexpr double most = 1e-6, max_degrees = 1e-4;
  for (const char* key : {"residual", "pose_residual", "residual_derivatives"})
    if (entry.contains(key) && !(entry[key].get<double>() <= most))
      wrongs.push_back(fmt::format("{} is {:.1e}", key, entry[key].get<double>()));
  if (entry.contains("precision_error_deg") && no_defects(entry) &&
      !(entry["precision_error_deg"].get<double>() <= max_degrees))
    wrongs.push_back(fmt::format("precision_error_deg is {:.1e}", entry["precision_error_deg"].get<double>()));
}

/// Of motion tasks of a four-bar, the poses that a listed linkage passes.
std::vector<PrescribedPose> passed_poses(const Problem& problem) {
  const auto* motion = std::get_if<MotionTask>(&problem.task);
  if (motion == nullptr) return {};
  std::vector<PrescribedPose> poses = motion->poses;
  if (motion->relaxed) poses.erase(poses.begin() + static_cast<std::ptrdiff_t>(*motion->relaxed));
  return poses;
}

void check_linkages(const Problem& problem, const json& result, Wrongs& wrongs) {
  const json& wanted = result["problem"]["requirements"];
  const auto poses = passed_poses(problem);
  std::size_t number = 0;
  for (const json& entry : result["linkages"]) {
    Wrongs found;
    const std::string which = fmt::format("linkage {}", ++number);
    const bool is_four_bar = entry["mechanism"] == "four_bar",
               is_spherical = entry["mechanism"] == "spherical_four_bar";
    check_confirmed(entry, which, wrongs);
    const bool is_line = entry.contains("usable");
    if (is_line)
      found = wrongs_of_line(wanted, result["problem"]["options"], entry);
    else
      check_residuals(entry, found);
    check_requirements(wanted,
                       is_line        ? line_looked_at(entry)
                       : is_four_bar  ? four_bar_looked_at(entry)
                       : is_spherical ? Looked{entry, {}, {}, {}}
                                      : six_bar_looked_at(entry),
                       found);
    if (const auto* path = std::get_if<PathTask>(&problem.task))
      for (const std::string& wrong : wrongs_of_path(*path, wanted, entry)) found.push_back(wrong);
    if (is_spherical) check_spherical(wanted, entry, found);
    if (const auto* sphere = std::get_if<SphericalMotionTask>(&problem.task))
      for (const char* side : {"input", "output"}) check_dyad_angle(sphere->orientations, entry[side], side, found);
    if (is_four_bar && !poses.empty())
      for (const char* side : {"input", "output"}) check_grounded_link(poses, entry[side], side, found);
    for (const std::string& wrong : found) wrongs.push_back(fmt::format("{}: {}", which, wrong));
  }
  number = 0;
  for (const json& entry : result["pairs"]) check_confirmed(entry, fmt::format("pair {}", ++number), wrongs);
  for (const json& way_out : result["freed"])
    if (!way_out["linkage"].is_null())
      check_confirmed(way_out["linkage"],
                      fmt::format("the way out of position {}",
                                  way_out[way_out.contains("pose") ? "pose" : "orientation"].get<int>()),
                      wrongs);
}

/// By the objective, best first; those with defects have no transmission angle.
void check_order(const json& result, Wrongs& wrongs) {
  const std::string objective = result["problem"]["options"].value("objective", "min_transmission_angle");
  const std::set<std::string> of_analyses = {"tolerance_error", "yield",   "hand_force",     "hold_open",
                                             "pin_force",       "torque",  "cylinder_force", "self_rise",
                                             "self_close",      "best_F1", "near_error"};
  if (of_analyses.contains(objective) || result.contains("pareto")) return;
  std::optional<double> before;
  for (const json& entry : result["linkages"]) {
    if (!no_defects(entry)) continue;
    double worth = 0;
    if (objective == "stroke") {
      worth = entry["stroke_over_longest"].get<double>();
    } else if (objective == "deviation" || objective == "velocity_uniformity") {
      continue;  // over what, the case tells
    } else if (objective == "path_error") {
      const auto& error = entry["fit"]["error"];
      const json& options = result["problem"]["options"];
      const bool largest =
          options.contains("fit") && options["fit"].value("measure", "least_squares") == "least_largest";
      worth = -error[largest ? "max" : "rms"].get<double>();
    } else if (objective == "link_ratio") {
      worth = -entry["link_ratio"].get<double>();
    } else if (objective == "min_transmission_angle") {
      worth = entry["min_transmission_angle_deg"].get<double>();
    } else if (objective == "structural_error") {
      worth = -entry.value("max_structural_error_deg", 0.0);
    } else if (objective == "link_angle") {
      worth = 180;
      for (const auto& [name, angle] : entry["angles_deg"].items())
        worth = std::min({worth, angle.get<double>(), 180 - angle.get<double>()});
    } else if (entry.contains("point") && entry["mechanism"] == "four_bar" && !entry.contains("usable")) {
      const std::vector<double> lengths = four_bar_lengths(entry);
      worth = -*std::max_element(lengths.begin(), lengths.end());
    } else if (entry["lengths"].is_object()) {
      worth = -std::max_element(entry["lengths"].begin(), entry["lengths"].end())->get<double>();
    } else {
      continue;
    }
    if (before && worth > *before + rounding * std::max(std::abs(worth), 1.0)) {
      wrongs.push_back("the linkages are not listed best first");
      return;
    }
    before = worth;
  }
}

void check_status(const Problem& problem, const json& result, Wrongs& wrongs) {
  const auto listed = static_cast<int>(result["linkages"].size());
  if (listed > problem.options.best) wrongs.push_back("more linkages are listed than were asked for");
  if (result["reason"].get<std::string>().empty()) wrongs.push_back("no reason is given");
  if (result["status"] != "solved" && listed > 0) wrongs.push_back("linkages are listed of a task without any");
}

void check_echo(const json& result, Wrongs& wrongs) {
  const auto again = read_problem(result["problem"].dump());
  if (!again) wrongs.push_back("the echoed problem is refused: " + again.errors().front().message);
}

}  // namespace

std::vector<std::string> wrongs_of(const Problem& problem, const Answer& answer, const std::string& result_text) {
  Wrongs wrongs;
  const json result = json::parse(result_text, nullptr, false);
  if (result.is_discarded()) return {"the result is no JSON"};
  look_for_nulls(result, "", wrongs);
  check_region_values(findings(answer).region, wrongs);
  check_counts(problem, result, wrongs);
  check_linkages(problem, result, wrongs);
  check_order(result, wrongs);
  check_status(problem, result, wrongs);
  check_echo(result, wrongs);
  for (std::string& wrong : wrongs_of_tolerances(problem, answer, result)) wrongs.push_back(std::move(wrong));
  for (std::string& wrong : wrongs_of_loads(problem, answer, result)) wrongs.push_back(std::move(wrong));
  std::sort(wrongs.begin(), wrongs.end());
  wrongs.erase(std::unique(wrongs.begin(), wrongs.end()), wrongs.end());
  return wrongs;
}

}  // namespace linkwright::soak
