#include <algorithm>
#include <string>

#include "drawn_kinds.hpp"
#include "linkwright/core/angle.hpp"

namespace linkwright::soak {
namespace {

using Pattern = std::vector<int>;

void add_ground_pivots(Draw& draw, const Sheet& sheet, Json& task) {
  if (draw.chance(0.3)) return;
  task["ground_pivots"] = {{"input", written_point(sheet, sheet.shift + sheet.scale * draw.point(2))},
                           {"output", written_point(sheet, sheet.shift + sheet.scale * draw.point(2))}};
}

/// Turning on by steps, scattered, on a dial of round numbers, or nearly equal.
Json drawn_angles(Draw& draw, const Pattern& pattern) {
  const int kind = draw.whole(0, 4);
  const double step = draw.one_of({5.0, 10.0, 15.0, 45.0}), close = draw.power_of_ten(-6, 0);
  const double wild = draw.chance(0.4) ? draw.power_of_ten(-3, 4) : 1;
  double input = draw.between(-180, 180), output = draw.between(-180, 180);
  if (kind == 3) input = output = 0;
  Json pairs = Json::array();
  for (const int multiplicity : pattern) {
    Json pair = {{"input_deg", input}, {"output_deg", output}};
    for (int m = 1; m < multiplicity; ++m)
      pair["derivatives"].push_back({{"input", draw.between(-2, 2)}, {"output", wild * draw.between(-2, 2)}});
    pairs.push_back(std::move(pair));
    input += kind == 4 ? close * draw.between(0.1, 1) : kind == 3 ? step * draw.whole(1, 3) : draw.between(2, 40);
    output += kind == 4 ? close * draw.between(-1, 1) : kind == 3 ? step * draw.whole(-3, 3) : draw.between(-40, 40);
    if (kind == 0) input = draw.between(-180, 180);
    if (kind == 0) output = draw.between(-180, 180);
  }
  return pairs;
}

Json drawn_free(Draw& draw, int pairs) {
  if (draw.chance(0.5)) {
    Json free = Json::object({{"number", "output_scale"}});
    const double low = draw.power_of_ten(-3, 1);
    if (draw.chance(0.7)) free["range"] = Json::array({low, low * draw.power_of_ten(0.01, 2)});
    return free;
  }
  const double low = draw.between(-200, 200);
  return {
      {"number", "pair_output"}, {"pair", draw.whole(1, pairs)}, {"range", {low, low + draw.power_of_ten(-2, 2.5)}}};
}

/// An expression and a range over which it exists.
void add_expression(Draw& draw, Json& function) {
  const double low = draw.power_of_ten(-3, 2), high = low * (1 + draw.power_of_ten(-2, 2));
  switch (draw.whole(0, 3)) {
    case 0:
      function["expression"] = draw.one_of({"x^2", "x^0.5", "sqrt", "x^-1", "x^2.5", "log", "ln", "x^-3.7"});
      function["x"] = Json::array({low, high});
      break;
    case 1:
      function["expression"] = draw.one_of({"sin", "cos", "exp", "x", "x^3"});
      function["x"] = drawn_interval(draw, 4, 8);
      break;
    case 2:
      function["expression"] = draw.one_of({"sin_deg", "cos_deg"});
      function["x"] = drawn_interval(draw, 180, 360);
      break;
    default:
      function["expression"] = draw.one_of({"tan", "tan_deg"});
      function["x"] = function["expression"] == "tan" ? Json::array({-1.2, draw.between(-1, 1.4)})
                                                      : Json::array({-60, draw.between(-45, 80)});
  }
}

void add_table(Draw& draw, Json& function) {
  const int rows = draw.chance(0.05) ? 3000 : draw.whole(2, draw.chance(0.3) ? 400 : 12), kind = draw.whole(0, 2);
  const double size = draw.power_of_ten(-3, 4);
  double x = draw.between(-size, size), y = draw.between(-1, 1);
  Json table = Json::array();
  for (int row = 0; row < rows; ++row) {
    table.push_back(Json::array({x, y}));
    x += size * draw.power_of_ten(-3, 0);
    y += kind == 0 ? draw.between(0, 1) : kind == 1 ? draw.between(-1, 1) : std::sin(0.1 * row);
  }
  function["table"] = std::move(table);
  if (draw.chance(0.5)) function["interpolation"] = draw.one_of({"linear", "monotone_cubic"});
}

Json drawn_dial(Draw& draw) {
  const double sweep = draw.chance(0.3) ? 30.0 * draw.whole(1, 12) : draw.power_of_ten(-1, 2.55);
  const double from = draw.chance(0.1) ? draw.power_of_ten(3, 8.9) : draw.chance(0.5) ? 0 : draw.between(-360, 360);
  return Json::array({from, from + (draw.chance(0.3) ? -sweep : sweep)});
}

void add_precision_points(Draw& draw, Json& function) {
  if (draw.chance(0.5)) function["points"] = draw.whole(4, 5);
  if (draw.chance(0.6)) function["spacing"] = draw.one_of({"chebyshev", "even"});
  if (draw.chance(0.1) && function.contains("x")) {
    const double low = function["x"][0], high = function["x"][1];
    Json points = Json::array();
    for (const double t : {0.05, 0.3, 0.6, 0.97}) points.push_back(low + (high - low) * (t + draw.between(0, 0.02)));
    function["spacing"] = std::move(points);
    function.erase("points");
  }
}

}  // namespace

Json drawn_pairs(Draw& draw, const Sheet& sheet, std::string_view kind) {
  Pattern pattern = {1, 1, 1, 1};
  if (kind == "pairs_mixed" || (kind == "pairs_free" && draw.chance(0.3)))
    pattern = draw.one_of<Pattern>({{2, 1, 1}, {1, 2, 1}, {1, 1, 2}, {2, 2}, {3, 1}, {1, 3}, {4}});
  if (kind == "pairs_five")
    pattern = draw.one_of<Pattern>({{1, 1, 1, 1, 1}, {1, 1, 1, 1, 1}, {2, 1, 1, 1}, {1, 2, 2}, {1, 3, 1}, {4, 1}, {5}});
  Json task = {{"kind", "function"}, {"mechanism", "four_bar"}, {"pairs", drawn_angles(draw, pattern)}};
  add_ground_pivots(draw, sheet, task);
  if (kind == "pairs_free") task["free"] = drawn_free(draw, static_cast<int>(pattern.size()));
  return task;
}

Json drawn_function(Draw& draw, const Sheet& sheet, std::string_view kind) {
  Json function = Json::object();
  if (kind == "function_table") {
    add_table(draw, function);
  } else {
    add_expression(draw, function);
  }
  function["input_range_deg"] = drawn_dial(draw);
  function["output_range_deg"] = drawn_dial(draw);
  add_precision_points(draw, function);
  Json task = {{"kind", "function"}, {"mechanism", "four_bar"}, {"function", std::move(function)}};
  add_ground_pivots(draw, sheet, task);
  const Json& made = task["function"];
  const bool five = (made.contains("points") && made["points"] == 5);
  if (!five && draw.chance(0.3)) task["free"] = drawn_free(draw, 4);
  return task;
}

}  // namespace linkwright::soak
