#include "drawn_problem.hpp"

#include "drawn_loads.hpp"
#include "drawn_task.hpp"
#include "drawn_tolerances.hpp"
#include "linkwright/mechanism/linkage_type.hpp"
#include "linkwright/region/linkage_class.hpp"

namespace linkwright::soak {
namespace {

Json drawn_box(Draw& draw, const Sheet& sheet, double least, double most) {
  const Point middle = sheet.shift + sheet.scale * draw.point(2);
  const double width = sheet.scale * draw.power_of_ten(least, most),
               height = sheet.scale * draw.power_of_ten(least, most);
  return {{"x", {middle.real() - width, middle.real() + width}},
          {"y", {middle.imag() - height, middle.imag() + height}}};
}

Json drawn_types(Draw& draw, const LinkageClass& linkages) {
  Json types = Json::array();
  for (const LinkageType type : linkages.types)
    if (type != LinkageType::degenerate && draw.chance(0.4)) types.push_back(name(type));
  return types;
}

/// What can be required of any linkage.
Json drawn_verdicts(Draw& draw, const LinkageClass& linkages) {
  Json wanted = Json::object();
  if (draw.chance(0.25)) wanted["types"] = drawn_types(draw, linkages);
  if (draw.chance(0.4)) wanted["no_defects"] = draw.chance(0.3);
  // With a defect there is no transmission angle.
  if (draw.chance(0.3) && wanted.value("no_defects", true)) wanted["min_transmission_angle_deg"] = draw.between(0, 60);
  return wanted;
}

Json drawn_cone(Draw& draw) {
  const double x = draw.between(-1, 1), y = draw.between(-1, 1);
  return {{"axis", {x, y, draw.between(0.1, 1)}}, {"half_angle_deg", draw.between(5, 90)}};
}

Json drawn_spherical_requirements(Draw& draw) {
  Json wanted = drawn_verdicts(draw, spherical_linkages);
  if (draw.chance(0.4)) wanted["min_link_angle_deg"] = draw.chance(0.5) ? Json() : Json(draw.between(0, 30));
  if (draw.chance(0.2)) wanted["max_link_angle_deg"] = draw.chance(0.3) ? Json() : Json(draw.between(40, 90));
  if (draw.chance(0.15)) wanted["fixed_axes_within"] = drawn_cone(draw);
  if (draw.chance(0.15)) wanted["moving_axes_within"] = drawn_cone(draw);
  if (draw.chance(0.3)) wanted["respect_direction"] = draw.chance(0.5);
  return wanted;
}

Json drawn_line_requirements(Draw& draw, const Sheet& sheet) {
  Json wanted = Json::object();
  if (draw.chance(0.2)) wanted["types"] = drawn_types(draw, straight_line_linkages);
  if (draw.chance(0.3)) wanted["min_transmission_angle_deg"] = draw.between(0, 60);
  if (draw.chance(0.3)) wanted["max_link_ratio"] = draw.chance(0.6) ? Json() : Json(draw.power_of_ten(0.1, 2.5));
  if (draw.chance(0.3))
    wanted["max_length"] = draw.chance(0.6) ? Json() : Json(sheet.scale * draw.power_of_ten(-0.5, 3));
  if (draw.chance(0.2)) wanted["min_stroke"] = sheet.scale * draw.power_of_ten(-2, 0.5);
  if (draw.chance(0.2)) wanted["max_deviation"] = sheet.scale * draw.power_of_ten(-6, -1);
  if (draw.chance(0.1)) wanted["ground_pivots_within"] = drawn_box(draw, sheet, -0.5, 1.5);
  if (draw.chance(0.1)) wanted["moving_pivots_within"] = drawn_box(draw, sheet, -0.5, 1.5);
  return wanted;
}

Json drawn_line_options(Draw& draw, const Sheet& sheet, std::string_view kind) {
  Json options = Json::object();
  options["region_samples"] = draw.whole(8, 60);
  options["best"] = draw.whole(0, 3);
  if (draw.chance(0.6))
    options["objective"] =
        draw.one_of({"stroke", "deviation", "min_transmission_angle", "size", "velocity_uniformity"});
  if (draw.chance(0.4)) options["deviation"] = sheet.scale * draw.power_of_ten(-6, -1);
  if (draw.chance(0.4)) options["stroke"] = sheet.scale * draw.power_of_ten(-1, 1);
  if (draw.chance(0.5)) options["measure"] = draw.one_of({"tangent", "strip"});
  if (kind == "line_search") options["effort"] = draw.whole(1000, 20'000);
  return options;
}

Json drawn_requirements(Draw& draw, const Sheet& sheet) {
  Json wanted = drawn_verdicts(draw, planar_linkages);
  if (draw.chance(0.5)) wanted["max_link_ratio"] = draw.chance(0.6) ? Json() : Json(draw.power_of_ten(0.1, 2.5));
  if (draw.chance(0.5))
    wanted["max_length"] = draw.chance(0.6) ? Json() : Json(sheet.scale * draw.power_of_ten(-0.5, 3));
  if (draw.chance(0.3)) wanted["min_length"] = draw.chance(0.5) ? Json() : Json(sheet.scale * draw.power_of_ten(-4, 0));
  if (draw.chance(0.1)) wanted["ground_pivots_within"] = drawn_box(draw, sheet, -0.5, 1.5);
  if (draw.chance(0.1)) wanted["moving_pivots_within"] = drawn_box(draw, sheet, -0.5, 1.5);
  if (draw.chance(0.3)) wanted["respect_direction"] = draw.chance(0.5);
  return wanted;
}

Json drawn_path_requirements(Draw& draw, const Sheet& sheet) {
  Json wanted = drawn_requirements(draw, sheet);
  if (draw.chance(0.25)) wanted["full_turn"] = draw.chance(0.8);
  if (draw.chance(0.3)) {  // most pass their points with defects alone, and shall pass them
    wanted["no_defects"] = false;
    wanted.erase("min_transmission_angle_deg");
  }
  return wanted;
}

/// A part of the map: coordinates run over [0, 1] to [0, 3].
Json drawn_window(Draw& draw) {
  const Json rows = drawn_interval(draw, 0.9, 1);
  return Json::array({rows, drawn_interval(draw, 0.9, 1)});
}

Json drawn_options(Draw& draw, const Sheet& sheet, std::string_view kind) {
  Json options = Json::object();
  options["region_samples"] = draw.chance(0.1) ? draw.one_of({8, 9, 400}) : draw.whole(60, 200);
  if (draw.chance(0.3)) options["spacing"] = draw.one_of({"coordinate", "arc_length"});
  options["objective"] = draw.one_of({"min_transmission_angle", "link_ratio", "size"});
  if (kind.starts_with("sphere")) options["objective"] = draw.one_of({"min_transmission_angle", "link_angle"});
  if (kind.find("function") != std::string_view::npos && draw.chance(0.4)) options["objective"] = "structural_error";
  if (draw.chance(0.3)) options["best"] = draw.one_of({0, 1, 2, 30, 100});
  if (draw.chance(0.1)) options["window"] = drawn_window(draw);
  if (kind == "path_near") {
    options.erase("window");
    options["fit"] = {{"effort", draw.one_of({"quick", "quick", "standard"})},
                      {"measure", draw.chance(0.2) ? "least_largest" : "least_squares"}};
    if (draw.chance(0.2))
      options["fit"]["grashof_margin"] = draw.chance(0.5) ? Json() : Json(draw.power_of_ten(-6, -1));
    if (draw.chance(0.5)) options["objective"] = "path_error";
  }
  if (kind == "six_bar_search") {
    options["box"] = drawn_box(draw, sheet, 0, 1);
    options["effort"] = draw.whole(200, 3000);
    if (options.contains("best"))
      options["best"] = draw.one_of({0, 1, 2});  // each is refined by chains drawn at random
    options["seed"] = draw.whole(0, 1000);
  }
  return options;
}

/// Mixed four positions are drawn twice as often as others: most patterns, most trouble.
std::string_view drawn_kind(Draw& draw) {
  const auto number = static_cast<std::size_t>(draw.whole(0, static_cast<int>(kinds.size())));
  return number < kinds.size() ? kinds[number] : std::string_view("four_mixed");
}

}  // namespace

DrawnProblem drawn_problem(std::uint64_t seed, std::uint64_t index, std::optional<std::string_view> wanted_kind) {
  Draw draw(seed, index);
  const std::string_view any = drawn_kind(draw), kind = wanted_kind.value_or(any);
  const Sheet sheet = drawn_sheet(draw);
  Json problem = {{"linkwright", 1}, {"task", drawn_task(draw, sheet, kind)}};
  const bool is_line = kind.starts_with("line");
  problem["requirements"] = is_line                      ? drawn_line_requirements(draw, sheet)
                            : kind.starts_with("path")   ? drawn_path_requirements(draw, sheet)
                            : kind.starts_with("sphere") ? drawn_spherical_requirements(draw)
                                                         : drawn_requirements(draw, sheet);
  problem["options"] = is_line ? drawn_line_options(draw, sheet, kind) : drawn_options(draw, sheet, kind);
  add_tolerances(draw, sheet, kind, problem);
  add_loads(draw, sheet, kind, problem);
  return {kind, problem.dump() + "\n"};
}

}  // namespace linkwright::soak
