#include <algorithm>
#include <optional>
#include <string>

#include "drawn_kinds.hpp"
#include "linkwright/core/angle.hpp"

namespace linkwright::soak {
namespace {

using Pattern = std::vector<int>;

enum class Angles { none, crank, coupler };

/// One way round, mostly within a turn: by chance, by round steps, nearly equal, or as nobody turns a crank.
std::vector<double> drawn_crank_angles(Draw& draw, std::size_t count) {
  const int kind = draw.whole(0, 9);
  const double sense = draw.chance(0.5) ? 1 : -1, step = draw.one_of({5.0, 15.0, 45.0, 90.0}),
               close = draw.power_of_ten(-6, 0);
  double at = draw.chance(0.1) ? draw.between(-1e5, 1e5) : draw.chance(0.4) ? 0 : draw.between(-180, 180);
  std::vector<double> angles;
  for (std::size_t j = 0; j < count; ++j) {
    angles.push_back(at);
    const double next = kind == 0  ? draw.between(-400, 400)
                        : kind < 3 ? close * draw.between(0.1, 1)
                        : kind < 6 ? step * draw.whole(1, 2)
                                   : draw.between(1, 359.0 / static_cast<double>(count));
    at += sense * next;
  }
  return angles;
}

double drawn_rate(Draw& draw, std::size_t order, double sense) {
  const bool turns_on = order == 0 && draw.chance(0.95);
  return turns_on ? sense * draw.power_of_ten(-2, 1) : draw.between(-2, 2);
}

/// A point as files have it, without its angle.
Json written_place(const PrescribedPose& pose) {
  Json point = {{"x", pose.pose.origin.real()}, {"y", pose.pose.origin.imag()}};
  for (const PoseDerivative& derivative : pose.derivatives)
    point["derivatives"].push_back({{"x", derivative.origin.real()}, {"y", derivative.origin.imag()}});
  return point;
}

void add_crank_angle(Draw& draw, double angle, double sense, bool with_rates, Json& point) {
  point["input_deg"] = angle;
  if (!with_rates || !point.contains("derivatives")) return;
  std::size_t order = 0;
  for (Json& derivative : point["derivatives"]) derivative["input"] = drawn_rate(draw, order++, sense);
}

void add_coupler_angle(const PrescribedPose& pose, Json& point) {
  point["theta_deg"] = std::round(degrees(pose.pose.angle) * 1e9) / 1e9;
  for (std::size_t m = 0; m < pose.derivatives.size(); ++m)
    point["derivatives"][m]["theta"] = pose.derivatives[m].angle;
}

/// As many points as there are multiplicities; those marked have an angle.
Json drawn_points(Draw& draw, const Sheet& sheet, const Pattern& pattern, const std::vector<bool>& has_angle,
                  Angles angles) {
  const std::vector<PrescribedPose> poses = drawn_poses(draw, sheet, pattern);
  const std::vector<double> crank = drawn_crank_angles(draw, pattern.size());
  const double sense = crank.back() < crank.front() ? -1 : 1;
  const bool with_rates = draw.chance(0.3);
  Json points = Json::array();
  for (std::size_t j = 0; j < poses.size(); ++j) {
    Json point = written_place(poses[j]);
    if (has_angle[j] && angles == Angles::crank) add_crank_angle(draw, crank[j], sense, with_rates, point);
    if (has_angle[j] && angles == Angles::coupler) add_coupler_angle(poses[j], point);
    points.push_back(std::move(point));
  }
  return points;
}

Json drawn_points(Draw& draw, const Sheet& sheet, const Pattern& pattern, Angles angles) {
  return drawn_points(draw, sheet, pattern, std::vector<bool>(pattern.size(), true), angles);
}

/// Anywhere; on one of the points, or hardly beside it.
Json drawn_pivot(Draw& draw, const Sheet& sheet, const Json& points) {
  if (!draw.chance(0.15)) {
    const double reach = draw.chance(0.2) ? draw.power_of_ten(-3, 3) : 3;
    return written_point(sheet, sheet.shift + sheet.scale * draw.point(reach));
  }
  const Json& near = points[static_cast<std::size_t>(draw.whole(0, static_cast<int>(points.size()) - 1))];
  const double off = draw.chance(0.3) ? 0 : sheet.scale * draw.power_of_ten(-8, -1);
  const Point place = Point{near["x"].get<double>(), near["y"].get<double>()} + off * draw.point(1);
  return Json::array({place.real(), place.imag()});
}

void give_pivots(Draw& draw, const Sheet& sheet, bool both, Json& task) {
  const bool of_output = draw.chance(0.5);
  Json pivots = Json::object();
  if (both || !of_output) pivots["input"] = drawn_pivot(draw, sheet, task["points"]);
  if (both || of_output) pivots["output"] = drawn_pivot(draw, sheet, task["points"]);
  task["given"] = {{"ground_pivots", std::move(pivots)}};
}

Pattern three_positions(Draw& draw) {
  return draw.one_of<Pattern>({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {2, 1}, {1, 2}, {3}});
}
Pattern four_positions(Draw& draw) {
  return draw.one_of<Pattern>(
      {{1, 1, 1, 1}, {1, 1, 1, 1}, {2, 1, 1}, {1, 2, 1}, {1, 1, 2}, {2, 2}, {3, 1}, {1, 3}, {4}});
}
Pattern five_positions(Draw& draw) {
  return draw.one_of<Pattern>({{1, 1, 1, 1, 1},
                               {1, 1, 1, 1, 1},
                               {1, 1, 1, 1, 1},
                               {2, 1, 1, 1},
                               {1, 1, 2, 1},
                               {2, 1, 2},
                               {1, 2, 2},
                               {3, 1, 1},
                               {1, 3, 1},
                               {2, 3},
                               {4, 1},
                               {5}});
}

/// Positions with angles and others without, in any order.
Json some_with_angles(Draw& draw, const Sheet& sheet, Angles angles) {
  const bool three = draw.chance(0.5);
  const Pattern with = three ? three_positions(draw) : four_positions(draw);
  const Pattern without = !three ? Pattern{1} : draw.chance(0.7) ? Pattern{1, 1} : Pattern{2};
  Pattern pattern;
  std::vector<bool> has_angle;
  std::size_t i = 0, j = 0;
  while (i < with.size() || j < without.size()) {
    const bool takes = j == without.size() || (i < with.size() && draw.chance(0.6));
    pattern.push_back(takes ? with[i++] : without[j++]);
    has_angle.push_back(takes);
  }
  return drawn_points(draw, sheet, pattern, has_angle, angles);
}

}  // namespace

Json drawn_path(Draw& draw, const Sheet& sheet, std::string_view kind) {
  Json task = {{"kind", "path"}, {"mechanism", "four_bar"}};
  Json& points = task["points"];
  if (kind == "path_timed") points = drawn_points(draw, sheet, four_positions(draw), Angles::crank);
  if (kind == "path_timed_five") points = drawn_points(draw, sheet, five_positions(draw), Angles::crank);
  if (kind == "path_timed_pivot") points = drawn_points(draw, sheet, three_positions(draw), Angles::crank);
  if (kind == "path_some_timed") points = some_with_angles(draw, sheet, Angles::crank);
  if (kind == "path_poses") points = some_with_angles(draw, sheet, Angles::coupler);
  if (kind == "path_pivot") points = drawn_points(draw, sheet, five_positions(draw), Angles::none);
  if (kind == "path_pivots") points = drawn_points(draw, sheet, three_positions(draw), Angles::none);
  if (kind == "path_few") {
    const bool timed = draw.chance(0.4);
    points = timed ? drawn_points(draw, sheet, three_positions(draw), Angles::crank)
                   : drawn_points(draw, sheet, {1, 1, 1, 1, 1}, Angles::none);
  }
  if (kind == "path_timed_pivot" || kind == "path_pivot") give_pivots(draw, sheet, false, task);
  if (kind == "path_pivots" || kind == "path_few") give_pivots(draw, sheet, true, task);
  return task;
}

}  // namespace linkwright::soak
