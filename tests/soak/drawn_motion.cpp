#include <algorithm>
#include <map>
#include <string>

#include "drawn_kinds.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/planar/six_bar_task.hpp"

namespace linkwright::soak {
namespace {

using Pattern = std::vector<int>;

Json written_poses(const std::vector<PrescribedPose>& poses) {
  Json list = Json::array();
  for (const PrescribedPose& pose : poses) {
    Json entry = {{"x", pose.pose.origin.real()},
                  {"y", pose.pose.origin.imag()},
                  {"theta_deg", std::round(degrees(pose.pose.angle) * 1e9) / 1e9}};
    for (const PoseDerivative& derivative : pose.derivatives)
      entry["derivatives"].push_back(
          {{"x", derivative.origin.real()}, {"y", derivative.origin.imag()}, {"theta", derivative.angle}});
    list.push_back(std::move(entry));
  }
  return list;
}

Json four_bar_task(const std::vector<PrescribedPose>& poses) {
  return {{"kind", "motion"}, {"mechanism", "four_bar"}, {"poses", written_poses(poses)}};
}

double drawn_length(Draw& draw, const Sheet& sheet) { return sheet.scale * draw.power_of_ten(-1.5, 1.5); }

Json given_lengths(Draw& draw, const Sheet& sheet) {
  const double first = drawn_length(draw, sheet);
  return Json::object({{"side_lengths", {first, draw.chance(0.2) ? first : drawn_length(draw, sheet)}}});
}

Json given_length(Draw& draw, const Sheet& sheet) { return Json::object({{"side_length", drawn_length(draw, sheet)}}); }

Json given_angle(Draw& draw, const Sheet& sheet) {
  Json given = Json::object();
  given["side_angle_deg"] = draw.chance(0.3) ? 30.0 * draw.whole(-6, 6) : draw.between(-200, 200);
  if (draw.chance(0.5)) given["directed"] = draw.chance(0.5);
  if (draw.chance(0.4)) given["input_length"] = drawn_length(draw, sheet);
  return given;
}

Json given_center(Draw& draw, const Sheet& sheet) {
  if (draw.chance(0.15)) {
    const Sheet exact;
    return Json::object({{"instant_center", written_point(exact, draw.point(1))}, {"at_infinity", true}});
  }
  const double reach = draw.chance(0.3) ? draw.power_of_ten(-3, 3) : 3;
  return Json::object({{"instant_center", written_point(sheet, sheet.shift + sheet.scale * draw.point(reach))}});
}

Json drawn_pivot(Draw& draw, const Sheet& sheet) {
  const double reach = draw.chance(0.2) ? draw.power_of_ten(-3, 3) : 3;
  return written_point(sheet, sheet.shift + sheet.scale * draw.point(reach));
}

Json line_of_pivots(Draw& draw, const Sheet& sheet) {
  return {{"point", drawn_pivot(draw, sheet)},
          {"direction_deg", draw.chance(0.3) ? 90.0 * draw.whole(-2, 2) : draw.between(-200, 200)}};
}

Json given_pivots(Draw& draw, const Sheet& sheet) {
  Json given = Json::object();
  const auto kind = [&] { return std::string(draw.chance(0.5) ? "ground" : "moving"); };
  const int form = draw.whole(0, 2);
  if (form == 0) {
    Json& both = given[kind() + "_pivots"];
    for (const char* side : {"input", "output"}) both[side] = drawn_pivot(draw, sheet);
  } else if (form == 1) {
    for (const char* side : {"input_", "output_"}) given[side + kind() + "_pivot"] = drawn_pivot(draw, sheet);
  } else {
    given[(draw.chance(0.5) ? "input_" : "output_") + kind() + "_pivot"] = drawn_pivot(draw, sheet);
  }
  return given;
}

Json given_lines(Draw& draw, const Sheet& sheet) {
  Json given = Json::object();
  const int which = draw.whole(0, 2);
  if (which != 0) given["ground_pivot_on"] = line_of_pivots(draw, sheet);
  if (which != 1) given["moving_pivot_on"] = line_of_pivots(draw, sheet);
  return given;
}

Json drawn_given(Draw& draw, const Sheet& sheet, std::string_view kind) {
  if (kind == "three_lengths") return given_lengths(draw, sheet);
  if (kind == "three_length") return given_length(draw, sheet);
  if (kind == "three_angle") return given_angle(draw, sheet);
  if (kind == "three_center") return given_center(draw, sheet);
  if (kind == "three_pivots") return given_pivots(draw, sheet);
  if (kind == "three_lines") return given_lines(draw, sheet);
  switch (draw.whole(0, 4)) {
    case 0:
      return given_lengths(draw, sheet);
    case 1:
      return given_length(draw, sheet);
    case 2:
      return given_pivots(draw, sheet);
    case 3:
      return given_lines(draw, sheet);
    default:
      return given_angle(draw, sheet);
  }
}

/// A chain that reaches all poses: a and d somewhere, the links long enough and alike enough.
ThreeLinkChain reaching_chain(Draw& draw, const Sheet& sheet, const std::vector<PrescribedPose>& poses) {
  const Point start = poses.front().pose.origin;
  ThreeLinkChain chain;
  chain.a = start + sheet.scale * draw.point(3);
  chain.d = start + sheet.scale * draw.point(draw.chance(0.2) ? 0.01 : 1.5);
  double nearest = std::abs(chain.d - chain.a), furthest = nearest;
  for (const PrescribedPose& pose : poses) {
    const double distance = std::abs(displaced(chain.d, poses.front().pose, pose.pose) - chain.a);
    nearest = std::min(nearest, distance);
    furthest = std::max(furthest, distance);
  }
  const double sum = furthest * (1 + draw.power_of_ten(-4, 0)), difference = nearest * draw.between(-0.99, 0.99);
  const double first = (sum + difference) / 2, second = (sum - difference) / 2, base = std::abs(chain.d - chain.a);
  const double along = (first * first - second * second + base * base) / (2 * base);
  const double across = std::sqrt(std::max(first * first - along * along, 0.0));
  chain.b = chain.a + (chain.d - chain.a) / base * Point{along, draw.chance(0.5) ? across : -across};
  return chain;
}

Json written_chain(Draw& draw, const ThreeLinkChain& chain) {
  const Sheet exact;
  Json written = {
      {"a", written_point(exact, chain.a)}, {"b", written_point(exact, chain.b)}, {"d", written_point(exact, chain.d)}};
  if (draw.chance(0.3)) {
    written["elbow"] = {draw.chance(0.5) ? 0 : chain.assembly_mode_in_position_1(), draw.whole(-1, 1),
                        draw.whole(-1, 1), draw.whole(-1, 1)};
  }
  return written;
}

}  // namespace

Json drawn_three_positions(Draw& draw, const Sheet& sheet, std::string_view kind) {
  const bool mixed = kind == "three_mixed";
  const Pattern pattern = mixed ? draw.one_of<Pattern>({{2, 1}, {1, 2}, {3}}) : Pattern{1, 1, 1};
  Json task = four_bar_task(drawn_poses(draw, sheet, pattern));
  task["given"] = drawn_given(draw, sheet, kind);
  return task;
}

Json drawn_four_positions(Draw& draw, const Sheet& sheet, std::string_view kind) {
  const Pattern pattern = kind == "four_mixed"
                              ? draw.one_of<Pattern>({{2, 1, 1}, {1, 2, 1}, {1, 1, 2}, {2, 2}, {3, 1}, {1, 3}, {4}})
                              : Pattern{1, 1, 1, 1};
  Json task = four_bar_task(drawn_poses(draw, sheet, pattern));
  if (kind != "four_lines") return task;
  for (const char* side : {"input", "output"})
    if (draw.chance(0.6))
      task["pivot_on"].push_back(
          {{"which", side}, {"pivot", draw.chance(0.5) ? "ground" : "moving"}, {"line", line_of_pivots(draw, sheet)}});
  return task;
}

Json drawn_five_positions(Draw& draw, const Sheet& sheet, std::string_view kind) {
  Pattern pattern = {1, 1, 1, 1, 1};
  if (kind == "five_mixed" || (kind == "five_freed" && draw.chance(0.5)))
    pattern = draw.one_of<Pattern>({{2, 1, 1, 1},
                                    {1, 2, 1, 1},
                                    {1, 1, 2, 1},
                                    {1, 1, 1, 2},
                                    {2, 2, 1},
                                    {2, 1, 2},
                                    {1, 2, 2},
                                    {3, 1, 1},
                                    {1, 3, 1},
                                    {1, 1, 3},
                                    {3, 2},
                                    {2, 3},
                                    {4, 1},
                                    {1, 4},
                                    {5}});
  if (kind == "five_freed" && std::find(pattern.begin(), pattern.end(), 1) == pattern.end()) pattern = {1, 1, 1, 1, 1};
  Json task = four_bar_task(drawn_poses(draw, sheet, pattern));
  if (kind != "five_freed") return task;
  int relaxed = draw.whole(0, static_cast<int>(pattern.size()) - 1);
  while (pattern[static_cast<std::size_t>(relaxed)] != 1) relaxed = (relaxed + 1) % static_cast<int>(pattern.size());
  task["freed_pose"] = relaxed + 1;
  return task;
}

Json drawn_six_bar(Draw& draw, const Sheet& sheet, std::string_view kind) {
  const auto poses = drawn_poses(draw, sheet, {1, 1, 1, 1});
  const SixBarRow& row = six_bar_rows()[static_cast<std::size_t>(draw.whole(0, 10))];
  Json task = {{"kind", "motion"},
               {"mechanism", "six_bar"},
               {"poses", written_poses(poses)},
               {"added", {text(row.added[0]), text(row.added[1])}}};
  if (kind == "six_bar_chain") task["chain"] = written_chain(draw, reaching_chain(draw, sheet, poses));
  return task;
}

}  // namespace linkwright::soak
