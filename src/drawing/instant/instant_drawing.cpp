#include <algorithm>
#include <fmt/format.h>

#include "drawing/four_bar/linkage_figure.hpp"
#include "drawing/number_rows.hpp"
#include "drawing/palette.hpp"
#include "drawing/sheet.hpp"
#include "instant_figure.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/drawing/svg_drawing.hpp"
#include "linkwright/files/number_text.hpp"
#include "linkwright/files/task_label.hpp"
#include "linkwright/mechanism/position.hpp"

namespace linkwright {
namespace {

constexpr PixelBox instant_card{linkage_sheet::border, 64, linkage_sheet::width - 2 * linkage_sheet::border, 592};
constexpr double key_height = 40;
constexpr PixelBox instant_scene{instant_card.left + 1, instant_card.top + 1, instant_card.width - 2,
                                 instant_card.height - 2 - key_height};
constexpr PixelBox instant_strip{linkage_sheet::border, 672, linkage_sheet::width - 2 * linkage_sheet::border, 108};

// Finds room for what is drawn and for what an instant adds, of which the farthest runs out of the picture.
PlaneWindow window_of(std::vector<Point> points, const InstantAnalysis& analysis) {
  constexpr double most_beyond = 2.2, margin = 64;
  Point low = points.front(), high = low;
  for (const Point p : points) {
    low = {std::min(low.real(), p.real()), std::min(low.imag(), p.imag())};
    high = {std::max(high.real(), p.real()), std::max(high.imag(), p.imag())};
  }
  const double extent = std::abs(high - low);
  const auto* turning = analysis.instant ? std::get_if<TurningInstant>(&*analysis.instant) : nullptr;
  const double reach = most_beyond / 2 * (extent > 0 ? extent : turning ? 2 * turning->diameter : 2);
  const auto more = instant_points(analysis, (low + high) / 2.0, reach);
  points.insert(points.end(), more.begin(), more.end());
  return {instant_scene, points, margin};
}

std::string point_text(const std::optional<Point>& point, int decimals) {
  if (!point) return "–";
  return fmt::format("{}, {}", rounded_text(point->real(), decimals), rounded_text(point->imag(), decimals));
}

void draw_turning_rows(SvgCanvas& svg, const TurningInstant& instant, const InstantAnalysis& analysis,
                       std::string_view unit, int decimals) {
  NumberRows poles(svg, instant_strip.corner() + Point{18, -9}, 280);
  poles.row("pole P", point_text(instant.pole, decimals));
  poles.row("inflection pole W", point_text(instant.inflection_pole(), decimals));
  poles.row("Ball's point U", point_text(analysis.ball_point, decimals));
  poles.row("acceleration pole J", point_text(analysis.acceleration_pole, decimals));
  NumberRows frame(svg, instant_strip.corner() + Point{340, -9}, 280);
  frame.row("inflection circle, diameter", fmt::format("{} {}", rounded_text(instant.diameter, decimals), unit));
  frame.row("pole tangent", rounded_text(degrees(std::arg(instant.tangent)), 2) + "°");
  frame.row("cubic, m and n", fmt::format("{}, {}", significant_text(instant.m(), 4, 1 / instant.diameter),
                                          significant_text(instant.n(), 4, 1 / instant.diameter)));
  frame.row("Burmester points", instant.fourth ? fmt::format("{}", analysis.burmester_points.size()) : "–");
}

void draw_path_rows(SvgCanvas& svg, const InstantAnalysis& analysis, std::string_view unit, int decimals) {
  NumberRows rows(svg, instant_strip.corner() + Point{662, -9}, 280);
  if (analysis.rates) {
    rows.row("rate of the body", significant_text(analysis.rates->velocity, 5, 1));
    rows.row("acceleration of the body", significant_text(analysis.rates->acceleration, 5, 1));
  }
  if (!analysis.point) return;
  const auto center = analysis.point->center ? finite_point(*analysis.point->center) : std::nullopt;
  rows.row(
      "C, radius of curvature",
      center ? fmt::format("{} {}", rounded_text(std::abs(*center - analysis.point->point), decimals), unit) : "–");
  rows.row("C, contact with its tangent", fmt::format("{} points", analysis.point->contact_points));
}

// Of what has no inflection circle.
std::string words_of(const InstantAnalysis& analysis) {
  if (!analysis.instant) return analysis.degenerate.message;
  if (std::holds_alternative<PivotingInstant>(*analysis.instant))
    return "the body turns about the pole as about a pivot, and all paths are circles about it";
  return analysis.notes.empty() ? "the body does not turn now, and the pole is at infinity"
                                : analysis.notes.front().message;
}

// Numbers, or in their place why they are few.
void draw_instant_strip(SvgCanvas& svg, const InstantAnalysis& analysis, std::string_view unit, double size) {
  draw_card(svg, instant_strip, "");
  const int decimals = length_decimals(size);
  const auto* turning = analysis.instant ? std::get_if<TurningInstant>(&*analysis.instant) : nullptr;
  if (turning)
    draw_turning_rows(svg, *turning, analysis, unit, decimals);
  else
    draw_wrapped(svg, instant_strip.corner() + Point{18, 30}, sentence_case(words_of(analysis)) + ".", 600, 3, 13);
  draw_path_rows(svg, analysis, unit, decimals);
}

// Scale bar, and below the scene what its lines are.
void end_scene(SvgCanvas& svg, const PlaneWindow& window, const InstantAnalysis& analysis, std::string_view unit) {
  draw_scale_bar(svg, window, {instant_scene.left + 24, instant_scene.bottom() - 18}, unit);
  svg.end_group();
  const Point left{instant_scene.left, instant_scene.bottom()};
  svg.line(left, left + instant_scene.width, stroke(palette::line, 1));
  draw_instant_key(svg, left + Point{24, key_height / 2}, analysis);
}

void draw_scene(SvgCanvas& svg, const FourBar& bars, const InstantAnalysis& analysis, std::string_view unit) {
  std::vector<Point> pivots = {bars.input_fixed, bars.input_moving, bars.output_fixed, bars.output_moving};
  if (analysis.point) pivots.push_back(analysis.point->point);
  const PlaneWindow window = window_of(pivots, analysis);
  svg.begin_clip(instant_scene.corner(), instant_scene.width, instant_scene.height);
  draw_grid(svg, window);
  draw_instant_curves(svg, window, analysis);
  if (analysis.point) {
    draw_traced_path(svg, window, path_of_cycle(bars, analysis.point->point), true);
    draw_body(svg, window, bars, analysis.point->point);
  }
  draw_bars(svg, window, bars);
  std::vector<Point> taken;
  for (const Point pivot : pivots) taken.push_back(window.to_px(pivot));
  draw_instant_points(svg, window, analysis, taken);
  draw_pins(svg, window, bars);
  end_scene(svg, window, analysis, unit);
}

void draw_scene(SvgCanvas& svg, const PrescribedInstant& instant) {
  const PlaneWindow window = window_of({instant.pose.pose.origin}, instant.analysis);
  svg.begin_clip(instant_scene.corner(), instant_scene.width, instant_scene.height);
  draw_grid(svg, window);
  draw_instant_curves(svg, window, instant.analysis);
  draw_direction(svg, window, instant.pose);
  draw_pose(svg, window, instant.pose.pose, 1, true);
  draw_instant_points(svg, window, instant.analysis, {window.to_px(instant.pose.pose.origin)});
  end_scene(svg, window, instant.analysis, instant.length_unit);
}

}  // namespace

std::string draw_instant(const LinkageAnalysis& analysis) {
  const StoredLinkage& linkage = analysis.linkage;
  const LinkageInstant& instant = *analysis.instant;
  const std::string at = rounded_text(degrees(configuration_of(instant.four_bar).input_angle), 2);
  SvgCanvas svg = linkage_sheet::begin(linkage.title.empty() ? "Four-bar linkage" : linkage.title,
                                       fmt::format("instant at an input angle of {}°", at));
  draw_card(svg, instant_card, "");
  draw_scene(svg, instant.four_bar, instant.analysis, linkage.length_unit);
  draw_instant_strip(svg, instant.analysis, linkage.length_unit, analysis.lengths.longest());
  return svg.file();
}

std::string draw_instant(const PrescribedInstant& instant) {
  SvgCanvas svg = linkage_sheet::begin(instant.title.empty() ? "Prescribed motion" : instant.title,
                                       "instant of the prescribed motion");
  draw_card(svg, instant_card, "");
  draw_scene(svg, instant);
  const auto* turning = instant.analysis.instant ? std::get_if<TurningInstant>(&*instant.analysis.instant) : nullptr;
  draw_instant_strip(svg, instant.analysis, instant.length_unit, turning ? turning->diameter : 1);
  return svg.file();
}

}  // namespace linkwright
