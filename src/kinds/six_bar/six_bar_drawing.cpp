#include <algorithm>
#include <fmt/format.h>
#include <optional>

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
#include "six_bar_figure.hpp"
#include "six_bar_kind.hpp"

namespace linkwright {
namespace {

constexpr double margin = 76;

using namespace solution_sheet;
constexpr PixelBox side_card{836, 84, 580, 664};

std::string search_words(const SixBarSearchResult& search, int effort) {
  const std::string tried = search.interrupted ? fmt::format("stopped after {} of {} chains",
                                                             grouped_text(search.chains_tried), grouped_text(effort))
                                               : fmt::format("{} chains tried", grouped_text(search.chains_tried));
  return fmt::format("{0}{1}{2} six-bars{1}{3} driven{1}{4} of them free of defects", tried, separator,
                     grouped_text(search.six_bars), grouped_text(search.driven), grouped_text(search.defect_free));
}

std::string six_bar_subtitle(const Problem& problem, const SixBarAnswer& answer) {
  const std::string text = sentence_case(task_label(problem.task)) + std::string(separator);
  if (answer.search) return text + search_words(*answer.search, answer.options.effort);
  return text + fmt::format("{0} six-bars sampled{3}{1} free of defects{3}{2} meet the requirements",
                            grouped_text(linkages_in(answer.counts)), grouped_text(answer.counts.defect_free),
                            grouped_text(answer.meeting_requirements), separator);
}

/// What is seen where there is no six-bar: poses, the chain, the box.
std::vector<Point> points_of_task(const SixBarTask& task) {
  std::vector<Point> points;
  for (const PrescribedPose& pose : task.poses) points.push_back(pose.pose.origin);
  if (task.chain) points.insert(points.end(), {task.chain->a, task.chain->b, task.chain->d});
  if (!task.chain && task.box)
    points.insert(points.end(), {{task.box->x_low, task.box->y_low}, {task.box->x_high, task.box->y_high}});
  return points;
}

void draw_bare_task(SvgCanvas& svg, const PlaneWindow& window, const SixBarTask& task) {
  if (task.chain) {
    const Point a = window.to_px(task.chain->a), b = window.to_px(task.chain->b), d = window.to_px(task.chain->d);
    draw_ground_symbol(svg, a);
    draw_link(svg, b, d, body_color(2));
    draw_link(svg, a, b, body_color(1));
    draw_pin(svg, a, body_color(1));
    draw_pin(svg, b, body_color(2));
    draw_pin(svg, d, body_color(3));
  }
  for (std::size_t pose = task.poses.size(); pose-- > 0;)
    draw_pose(svg, window, task.poses[pose].pose, pose + 1, pose == 0);
}

/// Named where the body is not at first.
void draw_boxes(SvgCanvas& svg, const PlaneWindow& window, const SixBarTask& task, const Requirements& requirements) {
  const auto draw = [&](const std::optional<Box>& box, std::string_view name) {
    if (box) draw_box(svg, window, *box, name, BoxName::above);
  };
  if (!task.chain) draw(task.box, "all pivots");
  draw(requirements.ground_pivots_within, "fixed pivots");
  draw(requirements.moving_pivots_within, "moving pivots");
}

void draw_task_card(SvgCanvas& svg, const Problem& problem, const SixBarAnswer& answer) {
  const SixBarTask& task = answer.task;
  const bool is_found = !answer.linkages.empty();
  draw_card(svg, task_card, is_found ? "Best six-bar" : "The four positions");
  const PixelBox box{task_card.left + 1, task_card.top + 44, task_card.width - 2, task_card.height - 45};
  std::optional<SixBarScene> scene;
  if (is_found) scene = scene_of(answer.linkages.front(), task.poses);
  const PlaneWindow window(box, scene ? points_of_interest(*scene) : points_of_task(task), margin);
  svg.begin_clip(box.corner(), box.width, box.height);
  draw_grid(svg, window);
  draw_boxes(svg, window, task, answer.requirements);
  scene ? draw_six_bar(svg, window, *scene) : draw_bare_task(svg, window, task);
  draw_scale_bar(svg, window, {box.left + 22, box.bottom() - 20}, problem.length_unit);
  svg.end_group();
  const std::string dotted = stroke(palette::accent, 2, "0.1 4.5") + " stroke-linecap=\"round\"";
  if (scene) draw_line_key(svg, {task_card.left + 190, task_card.top + 24}, dotted, "path of the frame's origin");
}

DrawnRegion region_of(const SixBarAnswer& answer, std::string_view length_unit) {
  return drawn_region(answer, {axis_label(answer, Side::input, length_unit), body_color(4), {}},
                      {axis_label(answer, Side::output, length_unit), body_color(5), {}});
}

void draw_map_card(SvgCanvas& svg, const SixBarAnswer& answer, std::string_view length_unit) {
  draw_card(svg, side_card, "Solution region: every point is one six-bar");
  constexpr double side = 444, left_axis = 76;
  const PixelBox map{side_card.left + left_axis, side_card.top + 44, side, side};
  if (answer.chain) draw_region(svg, region_of(answer, length_unit), map);
  draw_region_legend(svg, answer, planar_linkages, {side_card.left + 18, map.bottom() + 70}, side_card.width - 24);
}

void draw_search_card(SvgCanvas& svg, const SixBarAnswer& answer) {
  draw_card(svg, side_card, answer.linkages.empty() ? "Nothing found" : "Best six-bars found");
  if (answer.linkages.empty()) return;
  const Point corner = side_card.corner() + Point{18, 62};
  const double inside = side_card.width - 36;
  draw_six_bar_table(svg, corner, inside, answer);
  constexpr double row_height = 23, gap = 40;
  const double table_height = row_height * static_cast<double>(std::min<std::size_t>(answer.linkages.size(), 10)) + gap;
  svg.text(corner + Point{0, table_height}, "The bodies of six-bar 1, and their hinges", {.size = 14, .weight = 650});
  draw_body_rows(svg, corner + Point{0, table_height - 10}, inside, answer.linkages.front().member.six_bar);
  const Point foot = corner + Point{0, table_height + 180};
  draw_wrapped(
      svg, foot,
      fmt::format("γ: least transmission angle over the task. Body 1 drives, about a; body 3 carries the frame. "
                  "Seed {}: the same seed finds the same six-bars.",
                  answer.options.seed),
      inside, 3, 13);
}

void draw_strip(SvgCanvas& svg, const SixBarAnswer& answer) {
  if (answer.linkages.empty()) {
    draw_card(svg, strip_card, "No six-bar to show");
    return draw_wrapped(svg, {strip_card.left + 18, strip_card.top + 54}, answer.reason.message, strip_card.width - 36,
                        2);
  }
  const SixBarSolution& best = answer.linkages.front();
  const SixBar& bars = best.member.six_bar;
  draw_card(svg, strip_card, "");
  const Point corner = strip_card.corner() + Point{18, -7};
  svg.text(corner + Point{0, 42}, row_label(best.row), {.size = 15, .weight = 650});
  if (best.rating.drive.defects.none()) {
    const std::string angle = fmt::format("{}°", rounded_text(degrees(best.rating.min_transmission_angle()), 1));
    const double beside = text_width(angle, 28) + 16;
    svg.text(corner + Point{0, 81}, angle, {.size = 28, .weight = 650});
    svg.text(corner + Point{beside, 69}, "minimum transmission", {.size = 12, .color = palette::ink2});
    svg.text(corner + Point{beside, 84}, "angle over the task", {.size = 12, .color = palette::ink2});
  } else {
    svg.text(corner + Point{0, 81}, "has a defect", {.size = 18, .color = palette::bad, .weight = 650});
  }
  svg.text(corner + Point{0, 106},
           fmt::format("driver: {}{}", drive_text(best.rating.drive), best.verified_by_driving ? ", checked" : ""),
           {.size = 13, .color = palette::ink2});
  draw_hinge_rows(svg, corner + Point{300, 0}, 205, bars, 0, 4);
  draw_hinge_rows(svg, corner + Point{535, 0}, 205, bars, 4, 7);
  draw_length_rows(svg, corner + Point{775, 0}, 165, bars, 0, 4);
  draw_length_rows(svg, corner + Point{970, 0}, 165, bars, 4, 8);
  draw_length_rows(svg, corner + Point{1165, 0}, 190, bars, 8, 10);
  NumberRows checks(svg, corner + Point{1165, 42}, 190);
  checks.row("link ratio", rounded_text(best.rating.shape.link_ratio, 2));
  checks.row("relative error", significant_text(best.residual, 2));
}

// ---- One six-bar

constexpr PixelBox sheet_card{linkage_sheet::border, 64, linkage_sheet::width - 2 * linkage_sheet::border, 516};
constexpr PixelBox sheet_strip{linkage_sheet::border, 596, linkage_sheet::width - 2 * linkage_sheet::border, 184};

void draw_sheet_strip(SvgCanvas& svg, const SixBar& six_bar) {
  draw_card(svg, sheet_strip, "");
  const Point corner = sheet_strip.corner() + Point{18, -9};
  draw_body_rows(svg, corner, 210, six_bar);
  draw_hinge_rows(svg, corner + Point{250, 0}, 230, six_bar, 0, SixBar::joint_count);
  draw_length_rows(svg, corner + Point{520, 0}, 190, six_bar, 0, 5);
  draw_length_rows(svg, corner + Point{735, 0}, 190, six_bar, 5, 10);
}

}  // namespace

std::string draw_sheet(const Problem& problem, const SixBarAnswer& answer) {
  SvgCanvas svg = solution_sheet::begin(problem, six_bar_subtitle(problem, answer));
  draw_task_card(svg, problem, answer);
  answer.search ? draw_search_card(svg, answer) : draw_map_card(svg, answer, problem.length_unit);
  draw_strip(svg, answer);
  return svg.file();
}

std::string draw_linkage(const StoredSixBar& linkage) {
  SvgCanvas svg =
      linkage_sheet::begin(linkage.title.empty() ? "Six-bar linkage" : linkage.title, row_label(linkage.row));
  draw_card(svg, sheet_card, "");
  const SixBarScene scene = scene_of(linkage);
  const PixelBox inside{sheet_card.left + 1, sheet_card.top + 1, sheet_card.width - 2, sheet_card.height - 2};
  const PlaneWindow window(inside, points_of_interest(scene), margin);
  svg.begin_clip(inside.corner(), inside.width, inside.height);
  draw_grid(svg, window);
  draw_six_bar(svg, window, scene);
  draw_scale_bar(svg, window, {sheet_card.left + 24, sheet_card.bottom() - 22}, linkage.length_unit);
  svg.end_group();
  draw_sheet_strip(svg, linkage.six_bar);
  return svg.file();
}

}  // namespace linkwright
