#include <algorithm>
#include <fmt/format.h>

#include "drawing/four_bar/linkage_figure.hpp"
#include "drawing/number_rows.hpp"
#include "drawing/palette.hpp"
#include "drawing/region_figure.hpp"
#include "drawing/sheet.hpp"
#include "drawing/svg_canvas.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/drawing/svg_drawing.hpp"
#include "linkwright/files/label.hpp"
#include "linkwright/files/number_text.hpp"
#include "linkwright/files/task_label.hpp"
#include "spherical_figure.hpp"
#include "spherical_kind.hpp"

namespace linkwright {
namespace {

using namespace solution_sheet;
constexpr PixelBox map_card{836, 84, 580, 664};

std::string spherical_subtitle(const Problem& problem, const SphericalAnswer& answer) {
  const std::string text = sentence_case(task_label(problem.task));
  if (answer.counts.pairs == 0) return text;
  return text + std::string(separator) +
         fmt::format("{0} four-bars sampled{3}{1} free of defects{3}{2} meet the requirements",
                     grouped_text(linkages_in(answer.counts)), grouped_text(answer.counts.defect_free),
                     grouped_text(answer.meeting_requirements), separator);
}

void draw_task_keys(SvgCanvas& svg, Point corner, const SphericalScene& scene) {
  constexpr double leading = 22;
  double y = 0;
  const auto key = [&](const std::string& attributes, std::string_view name) {
    draw_line_key(svg, corner + Point{0, y}, attributes, name);
    y += leading;
  };
  if (!scene.fixed_cone.empty()) {
    key(fixed_cone_stroke(), "cone of fixed axes");
    key(moving_cone_stroke(), "cone of moving axes, position 1");
  }
  if (!scene.dyads.empty()) {
    const Point left = corner + Point{0, y};
    svg.circle(left + Point{8, 0}, 4, fill(palette::paper) + " " + stroke(palette::ink2, 1.5));
    svg.circle(left + Point{22, 0}, 4, fill(palette::ink2));
    svg.text(left + Point{37, 4}, "fixed and moving axis of a dyad", {.size = 12, .color = palette::ink2});
    y += leading;
  }
  if (!scene.path.empty()) key(marker_path_stroke(), "path of the coupler's middle");
  key(stroke(palette::line, 1.2), "coordinate planes, fixed frame");
  if (!scene.dead_points.empty()) draw_dead_point_key(svg, corner + Point{0, y});
}

void draw_task_card(SvgCanvas& svg, const SphericalAnswer& answer,
                    const std::vector<PrescribedOrientation>& orientations) {
  const SphericalScene scene = scene_of(answer, orientations);
  draw_card(svg, task_card, scene.bars ? "Best spherical four-bar" : "The orientations");
  const SphereView front = front_view(scene, task_card.corner() + Point{290, 326}, 262);
  const SphereView above = view_from_above(front, task_card.corner() + Point{668, 480}, 108);
  draw_scene(svg, front, scene);
  draw_caption(svg, front, scene.bars ? front_view_words : "from in front");
  draw_scene(svg, above, scene);
  draw_caption(svg, above, view_from_above_words);
  draw_fixed_frame(svg, front, task_card.corner() + Point{48, 618});
  draw_fixed_frame(svg, above, task_card.corner() + Point{532, 618});
  draw_task_keys(svg, task_card.corner() + Point{550, 60}, scene);
}

void draw_map_card(SvgCanvas& svg, const Problem& problem, const SphericalMotionAnswer& answer) {
  draw_card(svg, map_card,
            is_board(answer.family()) ? "Solution region: every cell is a pair of dyads"
                                      : "Solution region: every point is one four-bar");
  constexpr double side = 444, left_axis = 76;
  const PixelBox map{map_card.left + left_axis, map_card.top + 44, side, side};
  if (answer.family()) draw_region(svg, region_of(answer, problem.length_unit), map);
  draw_region_legend(svg, answer, spherical_linkages, {map_card.left + 18, map.bottom() + 70}, map_card.width - 24);
}

std::string angle_of(double angle) { return rounded_text(degrees(angle), 2) + "°"; }

void draw_angle_rows(SvgCanvas& svg, Point corner, double row_width, const LinkAngles& angles) {
  NumberRows rows(svg, corner, row_width);
  rows.row("ground", angle_of(angles.ground), palette::ink3);
  rows.row("input", angle_of(angles.input), palette::input);
  rows.row("coupler", angle_of(angles.coupler), palette::body);
  rows.row("output", angle_of(angles.output), palette::output);
}

void draw_axis_rows(SvgCanvas& svg, Point corner, double row_width, const SphericalFourBar& bars) {
  const auto axis = [](Vector3 v) {
    return fmt::format("{}, {}, {}", rounded_text(v.x, 4), rounded_text(v.y, 4), rounded_text(v.z, 4));
  };
  NumberRows rows(svg, corner, row_width);
  rows.row("fixed axis of the input, G₁", axis(bars.input_fixed), palette::input);
  rows.row("its moving axis W₁, position 1", axis(bars.input_moving), palette::input);
  rows.row("fixed axis of the output, G₂", axis(bars.output_fixed), palette::output);
  rows.row("its moving axis W₂, position 1", axis(bars.output_moving), palette::output);
}

/// Where on the map: numbers of dyads, or coordinates.
void add_coordinates(NumberRows& checks, const SphericalAnswer& answer, const SphericalSolution& best) {
  const bool counted = answer.family()->axis(Side::input).is_discrete();
  const auto text = [&](double coordinate) {
    return counted ? fmt::format("{}", static_cast<int>(coordinate) + 1) : rounded_text(coordinate, 4);
  };
  checks.row(counted ? "dyads, by their numbers" : "coordinates on the curves, τ₁ and τ₂",
             text(best.input.coordinate) + ", " + text(best.output.coordinate));
}

void draw_strip(SvgCanvas& svg, const SphericalAnswer& answer) {
  if (answer.linkages.empty()) {
    draw_card(svg, strip_card, "No linkage to show");
    return draw_wrapped(svg, {strip_card.left + 18, strip_card.top + 54}, answer.reason.message, strip_card.width - 36,
                        2);
  }
  const SphericalSolution& best = answer.linkages.front();
  draw_card(svg, strip_card, "");
  const Point corner = strip_card.corner() + Point{18, -7};
  draw_type(svg, corner + Point{0, 11}, best.report);
  draw_angle_rows(svg, corner + Point{310, 0}, 150, best.angles);
  draw_axis_rows(svg, corner + Point{504, 0}, 400, best.four_bar);
  NumberRows checks(svg, corner + Point{954, 0}, 402);
  checks.row("least link angle", angle_of(best.angles.shortest()));
  checks.row("input rotation range", rotation_text(best.report));
  add_coordinates(checks, answer, best);
  checks.row("error at the orientations",
             significant_text(best.residual, 2) + (best.verified_by_driving ? ", verified by simulation" : ""));
}

// ---- One linkage

constexpr PixelBox sheet_card{linkage_sheet::border, 64, linkage_sheet::width - 2 * linkage_sheet::border, 580};
constexpr PixelBox sheet_strip{linkage_sheet::border, 660, linkage_sheet::width - 2 * linkage_sheet::border, 120};

void draw_sheet_views(SvgCanvas& svg, const SphericalScene& scene) {
  draw_views(svg, scene, sheet_card.corner() + Point{252, 250}, sheet_card.corner() + Point{708, 250}, 218);
  const Point keys = sheet_card.corner() + Point{360, 552};
  draw_line_key(svg, keys, marker_path_stroke(), "path of the coupler's middle");
  if (!scene.dead_points.empty()) draw_dead_point_key(svg, keys + Point{270, 0});
}

}  // namespace

std::string draw_sheet(const Problem& problem, const SphericalMotionAnswer& answer) {
  SvgCanvas svg = solution_sheet::begin(problem, spherical_subtitle(problem, answer));
  draw_task_card(svg, answer, answer.task.orientations);
  draw_map_card(svg, problem, answer);
  draw_strip(svg, answer);
  return svg.file();
}

std::string draw_linkage(const StoredSphericalFourBar& linkage) {
  SvgCanvas svg = linkage_sheet::begin(linkage.title.empty() ? "Spherical four-bar linkage" : linkage.title,
                                       label(linkage_type(linkage.four_bar.angles())));
  draw_card(svg, sheet_card, "");
  draw_sheet_views(svg, scene_of(linkage));
  draw_card(svg, sheet_strip, "");
  draw_angle_rows(svg, sheet_strip.corner() + Point{18, -9}, 230, linkage.four_bar.angles());
  draw_axis_rows(svg, sheet_strip.corner() + Point{400, -9}, 540, linkage.four_bar);
  return svg.file();
}

}  // namespace linkwright
