#include "linkage_strip.hpp"

#include <cmath>
#include <fmt/format.h>
#include <string>

#include "linkwright/core/angle.hpp"
#include "linkwright/io/label.hpp"
#include "linkwright/io/number_text.hpp"
#include "palette.hpp"

namespace linkwright {
namespace {

constexpr double row_height = 21, first_row = 38;

double gamma_deg(double worst_cosine) { return degrees(std::acos(std::min(1.0, std::abs(worst_cosine)))); }

/// Rows of a name on the left and a value on the right.
class NumberRows {
 public:
  NumberRows(SvgCanvas& svg, Point corner, double width) : svg_(svg), corner_(corner), width_(width) {}

  void row(std::string_view name, std::string_view value, std::string_view role_color = {}) {
    const Point left = corner_ + Point{0, first_row + row_height * rows_++};
    const double indent = role_color.empty() ? 0 : 22;
    if (!role_color.empty())
      svg_.line(left + Point{0, -4}, left + Point{14, -4}, stroke(role_color, 4) + " stroke-linecap=\"round\"");
    svg_.text(left + indent, name, {.size = 13, .color = palette::ink2});
    svg_.text(left + width_, value, {.size = 13, .anchor = "end"});
  }

 private:
  SvgCanvas& svg_;
  Point corner_;
  double width_;
  int rows_ = 0;
};

void draw_type(SvgCanvas& svg, Point corner, const FourBarSolution& found) {
  const std::uint32_t color = palette::types[static_cast<std::size_t>(found.report.type)];
  svg.rectangle(corner + Point{0, 19}, 14, 14,
                fmt::format("rx=\"3\" {} {}", fill(fmt::format("#{:06X}", color)),
                            stroke("#000000", 0.8) + " stroke-opacity=\"0.35\""));
  svg.text(corner + Point{22, 31}, label(found.report.type), {.size = 15, .weight = 650});
  if (!found.report.defects.none()) {
    svg.text(corner + Point{0, 70}, "has a defect", {.size = 18, .color = palette::bad, .weight = 650});
    return;
  }
  const std::string angle = fmt::format("{}°", rounded_text(gamma_deg(found.report.worst_transmission_cosine), 1));
  svg.text(corner + Point{0, 70}, angle, {.size = 28, .weight = 650});
  svg.text(corner + Point{text_width(angle, 28) + 16, 58}, "least transmission", {.size = 12, .color = palette::ink2});
  svg.text(corner + Point{text_width(angle, 28) + 16, 73}, "angle over the task", {.size = 12, .color = palette::ink2});
}

std::string pivot_text(Point pivot, int decimals) {
  return fmt::format("{}, {}", rounded_text(pivot.real(), decimals), rounded_text(pivot.imag(), decimals));
}

std::string drive_text(const DefectReport& report) {
  if (report.sense == DriveSense::none) return "–";
  return fmt::format("{}° {}", rounded_text(degrees(report.sweep), 1), label(report.sense));
}

}  // namespace

void draw_card(SvgCanvas& svg, const PixelBox& card, std::string_view heading) {
  svg.rectangle(card.corner(), card.width, card.height,
                fmt::format("rx=\"10\" {} {}", fill(palette::paper), stroke(palette::line, 1)));
  svg.text(card.corner() + Point{18, 29}, heading, {.size = 14, .weight = 650});
}

void draw_wrapped(SvgCanvas& svg, Point position, std::string_view text, double width, int lines) {
  constexpr double size = 15, leading = 22;
  for (int line = 0; line < lines && !text.empty(); ++line) {
    std::size_t end = text.size();
    const bool is_last = line + 1 == lines;
    while (!is_last && text_width(text.substr(0, end), size) > width) {
      const std::size_t space = text.substr(0, end).rfind(' ');
      if (space == std::string_view::npos || space == 0) break;
      end = space;
    }
    svg.text(position + Point{0, leading * line}, fitted(text.substr(0, end), size, width), {.size = size});
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

void draw_pivot_rows(SvgCanvas& svg, Point corner, double width, const FourBar& four_bar) {
  const int decimals = length_decimals(four_bar.lengths().longest());
  NumberRows rows(svg, corner, width);
  rows.row("fixed pivot of the input", pivot_text(four_bar.input_center, decimals), palette::input);
  rows.row("its moving pivot, position 1", pivot_text(four_bar.input_circle, decimals), palette::input);
  rows.row("fixed pivot of the output", pivot_text(four_bar.output_center, decimals), palette::output);
  rows.row("its moving pivot, position 1", pivot_text(four_bar.output_circle, decimals), palette::output);
}

void draw_linkage_strip(SvgCanvas& svg, const PixelBox& card, const FourBarSolution& found, std::string_view unit) {
  draw_card(svg, card, "");
  const Point corner = card.corner() + Point{18, -7};
  draw_type(svg, corner + Point{0, 11}, found);
  draw_length_rows(svg, corner + Point{320, 0}, 176, found.lengths, unit);
  draw_pivot_rows(svg, corner + Point{546, 0}, 344, found.four_bar);

  NumberRows checks(svg, corner + Point{940, 0}, 416);
  checks.row("link ratio, longest to shortest", rounded_text(found.lengths.longest() / found.lengths.shortest(), 2));
  checks.row("driver turns through the task", drive_text(found.report));
  checks.row("place on the curves, τ₁ and τ₂",
             fmt::format("{}, {}", rounded_text(found.input.coordinate, 4), rounded_text(found.output.coordinate, 4)));
  checks.row("relative error at the positions", fmt::format("{}{}", significant_text(found.residual, 2),
                                                            found.verified_by_driving ? ", checked by driving" : ""));
}

}  // namespace linkwright
