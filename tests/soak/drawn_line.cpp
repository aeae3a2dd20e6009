#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "drawn_kinds.hpp"

// Straight lines of every case: lengths of all sizes and both signs, rays near those that are special, contacts close
// together, on one side or on both.
namespace linkwright::soak {
namespace {

Json length(Draw& draw, const Sheet& sheet) {
  return written(sheet, (draw.chance(0.5) ? -1 : 1) * sheet.scale * draw.power_of_ten(-1, 1));
}
Json positive(Draw& draw, const Sheet& sheet) { return sheet.scale * draw.power_of_ten(-1, 1); }

// Not on the pole tangent or normal, which have no such point; sometimes very near.
Json ray(Draw& draw) {
  const double off = draw.chance(0.1) ? draw.power_of_ten(-6, 0) : draw.between(1, 89);
  return draw.whole(-2, 1) * 90 + off;
}
Json angle(Draw& draw) { return draw.chance(0.3) ? draw.whole(-12, 12) * 30.0 : draw.between(-360, 360); }
Json point(Draw& draw, const Sheet& sheet) { return written_point(sheet, sheet.shift + sheet.scale * draw.point(2)); }

Json contacts(Draw& draw, const Sheet& sheet) {
  Json list = Json::array();
  double s = sheet.scale * draw.between(-2, 0);
  for (int left = 4; left > 0;) {
    const int multiplicity = std::min(left, draw.whole(1, 3));
    list.push_back({{"s", s}, {"multiplicity", multiplicity}, {"side", draw.chance(0.8) ? 1 : -1}});
    s += sheet.scale * (draw.chance(0.1) ? draw.power_of_ten(-6, -1) : draw.between(0.1, 1));
    left -= multiplicity;
  }
  return list;
}

std::string drawn_case(Draw& draw, std::string_view kind) {
  if (kind == "line_four")
    return draw.one_of({"four_point_pivots", "four_point_cubic", "ball_point_on_side_link", "isosceles_trapezoid"});
  if (kind == "line_pole")
    return draw.one_of({"pole_at_fixed_pivot", "pole_at_given_pivot", "pole_at_fixed_pivot_ball_point_on_frame"});
  if (kind == "line_five")
    return draw.one_of({"five_point", "five_point_inflection_pole", "five_point_side_link_on_frame", "six_point",
                        "parallel_side_links"});
  if (kind == "line_mixed") return "mixed";
  return kind == "line_search" ? "search" : "symmetric_lambda";
}

void add_given(Draw& draw, const Sheet& sheet, const std::string& name, Json& task) {
  if (name == "four_point_pivots" || name == "pole_at_given_pivot")
    task["ground_pivots"] = {{"input", point(draw, sheet)}, {"output", point(draw, sheet)}};
  if (name == "ball_point_on_side_link" || name == "mixed") task["input_pivot"] = point(draw, sheet);
  if (name == "isosceles_trapezoid") task["half_frame"] = positive(draw, sheet);
  if (name == "four_point_cubic" || name == "five_point") task["point_ray_deg"] = ray(draw);
  if (name == "four_point_cubic") task["cubic_n"] = draw.chance(0.2) ? Json() : length(draw, sheet);
  if (name == "pole_at_fixed_pivot" || name == "pole_at_given_pivot") task["output_arm"] = length(draw, sheet);
  if (name == "parallel_side_links")
    for (const char* key : {"input_offset", "output_offset"}) task[key] = length(draw, sheet);
  if (name == "mixed") task["contacts"] = contacts(draw, sheet);
  if (name == "mixed" && draw.chance(0.5)) task["coupler_angle_deg"] = draw.between(-180, 180);
  if (name == "symmetric_lambda" || name == "search") task["stroke"] = positive(draw, sheet);
  if (name == "symmetric_lambda" && draw.chance(0.5)) task["crank_range_deg"] = draw.between(1, 269);
  if (name == "search") task["deviation"] = task["stroke"].get<double>() * draw.power_of_ten(-7, -1.1);
  constexpr std::array of_pole = {
      "four_point_cubic", "pole_at_fixed_pivot",        "pole_at_fixed_pivot_ball_point_on_frame",
      "five_point",       "five_point_inflection_pole", "five_point_side_link_on_frame",
      "six_point"};
  if (std::find(of_pole.begin(), of_pole.end(), name) != of_pole.end()) task["pole_distance"] = length(draw, sheet);
}

}  // namespace

Json drawn_line(Draw& draw, const Sheet& sheet, std::string_view kind) {
  const std::string name = drawn_case(draw, kind);
  Json task = {{"kind", "straight_line"},
               {"mechanism", "four_bar"},
               {"case", name == "pole_at_given_pivot" ? "pole_at_fixed_pivot" : name}};
  const Json through = point(draw, sheet);
  task["line"] = {{"point", through}, {"direction_deg", angle(draw)}};
  add_given(draw, sheet, name, task);
  return task;
}

}  // namespace linkwright::soak
