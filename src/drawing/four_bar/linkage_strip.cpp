#include <cmath>
#include <fmt/format.h>
#include <string>

#include "drawing/number_rows.hpp"
#include "drawing/palette.hpp"
#include "files/axis_label.hpp"
#include "linkage_figure.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/label.hpp"
#include "linkwright/files/number_text.hpp"

namespace linkwright {
namespace {

std::string pivot_text(Point pivot, int decimals) {
  return fmt::format("{}, {}", rounded_text(pivot.real(), decimals), rounded_text(pivot.imag(), decimals));
}

}  // namespace

void draw_type_name(SvgCanvas& svg, Point corner, LinkageType type) {
  const std::uint32_t color = palette::types[static_cast<std::size_t>(type)];
  svg.rectangle(corner + Point{0, 19}, 14, 14,
                fmt::format("rx=\"3\" {} {}", fill(fmt::format("#{:06X}", color)),
                            stroke("#000000", 0.8) + " stroke-opacity=\"0.35\""));
  svg.text(corner + Point{22, 31}, label(type), {.size = 15, .weight = 650});
}

void draw_type(SvgCanvas& svg, Point corner, const DefectReport& report) {
  draw_type_name(svg, corner, report.type);
  if (!report.defects.none()) {
    svg.text(corner + Point{0, 70}, "has a defect", {.size = 18, .color = palette::bad, .weight = 650});
    return;
  }
  const std::string angle = fmt::format("{}°", rounded_text(degrees(report.min_transmission_angle), 1));
  svg.text(corner + Point{0, 70}, angle, {.size = 28, .weight = 650});
  svg.text(corner + Point{text_width(angle, 28) + 16, 58}, "minimum transmission",
           {.size = 12, .color = palette::ink2});
  svg.text(corner + Point{text_width(angle, 28) + 16, 73}, "angle over the task", {.size = 12, .color = palette::ink2});
}

std::string rotation_text(const DefectReport& report) {
  if (report.sense == DriveSense::none) return "–";
  return fmt::format("{}° {}", rounded_text(degrees(report.sweep), 1), label(report.sense));
}

void draw_card(SvgCanvas& svg, const PixelBox& card, std::string_view heading) {
  svg.rectangle(card.corner(), card.width, card.height,
                fmt::format("rx=\"10\" {} {}", fill(palette::paper), stroke(palette::line, 1)));
  svg.text(card.corner() + Point{18, 29}, heading, {.size = 14, .weight = 650});
}

void draw_wrapped(SvgCanvas& svg, Point position, std::string_view text, double width, int lines, double size) {
  const double leading = std::floor(1.5 * size);
  for (int line = 0; line < lines && !text.empty(); ++line) {
    std::size_t end = text.size();
    const bool is_last = line + 1 == lines;
    while (!is_last && text_width(text.substr(0, end), size) > width) {
      const std::size_t space = text.substr(0, end).rfind(' ');
      if (space == std::string_view::npos || space == 0) break;
      end = space;
    }
    svg.text(position + Point{0, leading * line}, fit_text(text.substr(0, end), size, width), {.size = size});
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

void draw_length_rows(SvgCanvas& svg, Point corner, double width, const LinkLengths& lengths, std::string_view unit) {
  const int decimals = length_decimals(lengths.longest());
  const auto length = [&](double value) { return fmt::format("{} {}", rounded_text(value, decimals), unit); };
  NumberRows rows(svg, corner, width);
  rows.row("ground", length(lengths.ground), palette::ink3);
  rows.row("input", length(lengths.input), palette::input);
  rows.row("coupler", length(lengths.coupler), palette::body);
  rows.row("output", length(lengths.output), palette::output);
}

void draw_pivot_rows(SvgCanvas& svg, Point corner, double width, const FourBar& four_bar, int position) {
  const int decimals = length_decimals(four_bar.lengths().longest());
  const std::string moving = fmt::format("its moving pivot, position {}", position);
  NumberRows rows(svg, corner, width);
  rows.row("fixed pivot of the input", pivot_text(four_bar.input_fixed, decimals), palette::input);
  rows.row(moving, pivot_text(four_bar.input_moving, decimals), palette::input);
  rows.row("fixed pivot of the output", pivot_text(four_bar.output_fixed, decimals), palette::output);
  rows.row(moving, pivot_text(four_bar.output_moving, decimals), palette::output);
}

namespace {

std::string small_angle(double radians) { return fmt::format("{}°", significant_text(degrees(radians), 3)); }

/// What is read at a coordinate of an axis: "β₁ = 258.5°", "number 3", or τ.
std::string place_text(const FourBarFamily& family, Side side, double tau) {
  const AxisQuantity quantity = family.axis(side).quantity;
  if (quantity == AxisQuantity::burmester_point || quantity == AxisQuantity::layer)
    return fmt::format("{}", static_cast<int>(std::floor(tau)) + 1);
  if (!has_values(quantity)) return rounded_text(tau, 4);
  const double value = family.axis_value(side, tau);
  return is_angle(quantity) ? rounded_text(value, 2) + "°" : significant_text(value, 5);
}

std::string_view place_name(const FourBarFamily& family) {
  if (family.has_cognates()) return "cranks, its own and its cognate's";
  switch (family.axis(Side::output).quantity) {
    case AxisQuantity::burmester_point:
      return "dyads, by their numbers";
    case AxisQuantity::layer:
      return "place and number of the linkage";
    case AxisQuantity::side_direction:
      return "directions β₁ and β₂";
    case AxisQuantity::side_length:
      return "direction β₁ and length R₂";
    case AxisQuantity::output_scale:
      return "coupler τ and output scale";
    case AxisQuantity::pair_output:
      return "coupler τ and free output angle";
    case AxisQuantity::nothing:
      if (family.axis(Side::input).quantity == AxisQuantity::fitted_curve) return "which of the nearest linkages";
      return family.axis(Side::input).is_discrete() ? "which of the linkages" : "coupler τ";
    case AxisQuantity::center_x:
      return "ground pivot, x and y";
    case AxisQuantity::circle_x:
      return "moving pivot, x and y";
    case AxisQuantity::realisation:
      return "path, and which of its four-bars";
    case AxisQuantity::arm_difference:
      return "sum and difference of the arm, u and v";
    case AxisQuantity::center_on_line:
    case AxisQuantity::circle_on_line:
      return "places of the pivots on the line";
    default:
      return "coordinates on the curves, τ₁ and τ₂";
  }
}

void add_place(NumberRows& checks, const FourBarAnswer& answer) {
  const FourBarFamily& family = *answer.given.family;
  const FourBarSolution& found = answer.linkages.front();
  const AxisQuantity across = family.axis(Side::output).quantity;
  std::string text = place_text(family, Side::input, found.input.coordinate);
  if (across != AxisQuantity::nothing) {
    const std::string other = place_text(family, Side::output, found.output.coordinate);
    const bool is_plane = across == AxisQuantity::center_x || across == AxisQuantity::circle_x;
    text = is_plane ? other + ", " + text : text + ", " + other;
  }
  checks.row(place_name(family), text);
}

void add_motion_checks(NumberRows& checks, const FourBarAnswer& answer) {
  const FourBarSolution& found = answer.linkages.front();
  checks.row("link ratio, longest to shortest", rounded_text(found.lengths.longest() / found.lengths.shortest(), 2));
  checks.row("input rotation range", rotation_text(found.report));
  if (found.pose_error)
    checks.row("error at the relaxed position",
               fmt::format("{} and {}", significant_text(found.pose_error->distance, 3),
                           small_angle(found.pose_error->angle)));
  else
    add_place(checks, answer);
  const std::string_view verified = found.verified_by_driving ? ", verified by simulation" : "";
  if (found.near)
    checks.row("error at the near poses, mean square",
               fmt::format("{} and {}{}", significant_text(found.near->error.position_rms, 3),
                           small_angle(found.near->error.angle_rms), verified));
  else if (found.fit)
    checks.row("points from the path, mean square",
               fmt::format("{} %{}", significant_text(100 * found.fit->error.rms_over_diagonal, 2), verified));
  else
    checks.row("relative error at the positions", fmt::format("{}{}", significant_text(found.residual, 2), verified));
}

void add_function_checks(NumberRows& checks, const FourBarAnswer& answer, const FunctionError& error) {
  const FourBarSolution& found = answer.linkages.front();
  const bool has_function = !error.samples.empty();
  if (error.max_structural_error)
    checks.row("largest structural error", fmt::format("{} at input {}°", small_angle(*error.max_structural_error),
                                                       rounded_text(degrees(error.worst_input), 1)));
  else
    checks.row("link ratio, longest to shortest", rounded_text(found.lengths.longest() / found.lengths.shortest(), 2));
  checks.row("input rotation range", rotation_text(found.report));
  add_place(checks, answer);
  const std::string_view reach = !has_function || error.unreached.empty() ? "" : ", not the whole range";
  checks.row("error at the pairs, by simulation",
             (error.reaches_pairs ? significant_text(degrees(error.precision_error), 2) + "°" : "not reached") +
                 std::string(reach));
}

void draw_ways_out(SvgCanvas& svg, const PixelBox& card, const std::vector<RelaxedPosition>& ways,
                   std::string_view unit) {
  const double left = card.left + card.width / 2, column = card.width / 2 - 18;
  svg.text({left, card.top + 29}, "Alternatives: relaxing one position", {.size = 14, .weight = 650});
  constexpr double leading = 14.5, first = 45;
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const RelaxedPosition& way = ways[i];
    const std::string words = way.linkage
                                  ? fmt::format("error {}{}{} and {}", significant_text(way.pose_error.distance, 3),
                                                unit.empty() ? "" : " ", unit, small_angle(way.pose_error.angle))
                              : way.reason ? way.reason->message
                                           : "nothing was found";
    const Point at{left, card.top + first + leading * static_cast<double>(i)};
    svg.text(at, fmt::format("position {}", way.pose + 1), {.size = 12, .color = palette::ink2});
    svg.text(at + 76.0, fit_text(words, 12, column - 76), {.size = 12});
  }
}

constexpr std::string_view nothing_heading = "No linkage to show";
constexpr Point reason_corner{18, 54};

}  // namespace

void draw_reason_strip(SvgCanvas& svg, const PixelBox& card, const MotionAnswer& answer, std::string_view unit) {
  draw_card(svg, card, nothing_heading);
  const Point corner = card.corner() + reason_corner;
  if (answer.relaxed.empty()) return draw_wrapped(svg, corner, answer.reason.message, card.width - 36, 2);
  draw_wrapped(svg, corner - Point{0, 4}, answer.reason.message, card.width / 2 - 40, 4, 12.5);
  draw_ways_out(svg, card, answer.relaxed, unit);
}

void draw_reason_strip(SvgCanvas& svg, const PixelBox& card, const FourBarAnswer& answer, std::string_view /*unit*/) {
  draw_card(svg, card, nothing_heading);
  draw_wrapped(svg, card.corner() + reason_corner, answer.reason.message, card.width - 36, 2);
}

void draw_linkage_strip(SvgCanvas& svg, const PixelBox& card, const FourBarAnswer& answer, std::string_view unit) {
  const FourBarSolution& found = answer.linkages.front();
  draw_card(svg, card, "");
  const Point corner = card.corner() + Point{18, -7};
  draw_type(svg, corner + Point{0, 11}, found.report);
  draw_length_rows(svg, corner + Point{320, 0}, 176, found.lengths, unit);
  draw_pivot_rows(svg, corner + Point{546, 0}, 344, found.four_bar, answer.given.reference_position());

  NumberRows checks(svg, corner + Point{940, 0}, 416);
  found.function ? add_function_checks(checks, answer, *found.function) : add_motion_checks(checks, answer);
}

}  // namespace linkwright
