#include "drawn_tolerances.hpp"

#include <algorithm>

namespace linkwright::soak {
namespace {

bool is_of(std::string_view kind, std::string_view part) { return kind.find(part) != std::string_view::npos; }

/// Mostly what a workshop does; one in six what nobody would ask.
double drawn_size(Draw& draw, double scale) {
  return draw.chance(1.0 / 6) ? scale * draw.power_of_ten(-14, 4) : scale * draw.power_of_ten(-6, -1);
}

double drawn_angle(Draw& draw) { return draw.chance(0.1) ? draw.between(0, 90) : draw.power_of_ten(-5, 0.5); }

Json drawn_lengths(Draw& draw, double scale) {
  if (draw.chance(0.5)) return drawn_size(draw, scale);
  Json lengths = Json::object();
  for (const char* link : {"input", "coupler", "output", "ground_pivots", "point"})
    if (draw.chance(0.7)) lengths[link] = draw.chance(0.3) ? 0.0 : drawn_size(draw, scale);
  return lengths;
}

Json drawn_limit(Draw& draw, const Sheet& sheet, std::string_view kind) {
  if (is_of(kind, "line")) return {{"deviation", drawn_size(draw, sheet.scale)}};
  if (is_of(kind, "sphere") || is_of(kind, "function") || draw.chance(0.3)) return {{"angle_deg", drawn_angle(draw)}};
  return {{"position", drawn_size(draw, sheet.scale)}};
}

Json drawn_tolerances(Draw& draw, const Sheet& sheet, std::string_view kind) {
  Json tolerances = Json::object();
  if (is_of(kind, "sphere")) {
    tolerances["link_angle_deg"] = drawn_angle(draw);
  } else {
    tolerances["length"] = drawn_lengths(draw, sheet.scale);
    if (draw.chance(0.3)) tolerances["clearance"] = drawn_size(draw, sheet.scale);
  }
  if (draw.chance(0.4)) tolerances["driver_deg"] = drawn_angle(draw);
  if (draw.chance(0.6)) tolerances["distribution"] = draw.one_of({"normal", "truncated_normal", "uniform"});
  if (draw.chance(0.3)) tolerances["turning_length"] = draw.chance(0.4) ? 0.0 : sheet.scale * draw.power_of_ten(-2, 2);
  if (draw.chance(0.5)) tolerances["limit"] = drawn_limit(draw, sheet, kind);
  if (draw.chance(0.4)) tolerances["cost"] = {{"exponent", draw.power_of_ten(-1, 1)}};
  tolerances["samples"] = draw.whole(1000, 5000);
  tolerances["seed"] = draw.whole(0, 1'000'000'000);
  return tolerances;
}

/// Each cell that meets all else is sampled, and paths along a line are traced for each.
void keep_map_small(std::string_view kind, Json& options) {
  const int most = is_of(kind, "six_bar") ? 12 : is_of(kind, "line") ? 20 : 40;
  options["region_samples"] = std::min(options.value("region_samples", most), most);
}

void add_what_goes_by_them(Draw& draw, const Sheet& sheet, std::string_view kind, bool has_limit, Json& problem) {
  const double unit = is_of(kind, "sphere") || is_of(kind, "function") ? 1 : sheet.scale;
  Json &options = problem["options"], &wanted = problem["requirements"];
  if (draw.chance(0.3)) options["objective"] = has_limit && draw.chance(0.5) ? "yield" : "tolerance_error";
  if (draw.chance(0.3)) wanted["max_tolerance_error"] = unit * draw.power_of_ten(-5, 1);
  if (has_limit && draw.chance(0.3)) wanted["min_yield"] = draw.between(0, 1);
  if (!is_of(kind, "six_bar") && draw.chance(0.2))
    options["pareto"] = {"min_transmission_angle", has_limit && draw.chance(0.4) ? "yield" : "tolerance_error"};
}

}  // namespace

void add_tolerances(Draw& draw, const Sheet& sheet, std::string_view kind, Json& problem) {
  if (!draw.chance(0.4)) return;
  problem["tolerances"] = drawn_tolerances(draw, sheet, kind);
  const bool has_limit = problem["tolerances"].contains("limit");
  if (has_limit || is_of(kind, "line")) keep_map_small(kind, problem["options"]);
  if (!is_of(kind, "search")) add_what_goes_by_them(draw, sheet, kind, has_limit, problem);
}

}  // namespace linkwright::soak
