#include "region_figure.hpp"

#include <array>
#include <cmath>
#include <fmt/format.h>

#include "base64.hpp"
#include "linkwright/io/label.hpp"
#include "linkwright/io/number_text.hpp"
#include "palette.hpp"
#include "region_picture.hpp"
#include "region_scale.hpp"

namespace linkwright {
namespace {

constexpr int pixels_per_px = 2;
// px from the map to the axis, to the middles of the ∞ marks, the branches' names and the axis's title
constexpr double axis_distance = 8, mark_distance = 20, branch_distance = 35, title_distance = 54;

std::string css(std::uint32_t color) { return fmt::format("#{:06X}", color); }

/// A direction of the map: the other-side-link axis runs right below it, the driving one up at its left.
struct AxisPlace {
  Point start;  ///< px of the axis's zero
  Point along;  ///< unit vector of rising samples
  Point away;   ///< unit vector away from the map
  double turn;  ///< of texts, degrees
};

TextStyle axis_text(const AxisPlace& place, double size, std::string_view color, int weight = 400) {
  return {.size = size, .color = color, .anchor = "middle", .weight = weight, .turn = place.turn};
}

void draw_axis(SvgCanvas& svg, const RegionScale& scale, const AxisPlace& place, std::string_view color,
               std::string_view title) {
  const auto at = [&](double px, double away) { return place.start + px * place.along + away * place.away; };
  const Point to_baseline = place.turn == 0 ? Point{0, 4} : Point{4, 0};  // from the middle of a text's height
  for (const RegionScale::Block& block : scale.blocks()) {
    svg.line(at(block.from_px, axis_distance), at(block.to_px, axis_distance), stroke(color, 2));
    const std::string_view words = branch_label(block.branch);
    const double middle = (block.from_px + block.to_px) / 2;
    if (text_width(words, 11) > block.to_px - block.from_px) continue;
    svg.text(at(middle, branch_distance) + to_baseline, words, axis_text(place, 11, palette::ink2));
  }
  svg.text(at(scale.length() / 2, title_distance) + to_baseline, title, axis_text(place, 12, color, 650));

  double last = -100;
  for (const double px : scale.crossings_of_infinity()) {
    svg.line(at(px, axis_distance - 4), at(px, axis_distance + 4), stroke(palette::ink, 1.4));
    if (px - last < 14) continue;
    svg.text(at(px, mark_distance) + Point{0, 4}, "∞", {.size = 13, .color = palette::ink, .anchor = "middle"});
    last = px;
  }
}

/// Rings with numbers where the best linkages lie; dots where a ring would cover another.
void draw_best(SvgCanvas& svg, const Solution& solution, const RegionScale& input, const RegionScale& output,
               const PixelBox& map) {
  constexpr double ring = 9, closest = 2 * ring + 1;
  std::vector<Point> rings;
  std::vector<std::pair<Point, std::size_t>> dots;
  for (std::size_t i = 0; i < solution.linkages.size(); ++i) {
    const FourBarSolution& found = solution.linkages[i];
    const auto across = output.position(found.output.coordinate), up = input.position(found.input.coordinate);
    if (!across || !up) continue;  // outside the window
    const Point at{map.left + *across, map.bottom() - *up};
    bool is_free = true;
    for (const Point other : rings) is_free = is_free && std::abs(other - at) >= closest;
    is_free ? rings.push_back(at) : void();
    dots.emplace_back(at, is_free ? i + 1 : 0);
  }
  for (const auto& [at, number] : dots) {
    if (number == 0) svg.circle(at, 2.6, fill(palette::paper) + " " + stroke(palette::ink, 1.2));
  }
  for (const auto& [at, number] : dots) {
    if (number == 0) continue;
    svg.circle(at, ring, fill(palette::paper) + " " + stroke(palette::ink, 1.6));
    svg.text(at + Point{0, 4}, fmt::format("{}", number), {.size = 11, .anchor = "middle", .weight = 650});
  }
}

void draw_swatch(SvgCanvas& svg, Point corner, std::string_view attributes) {
  svg.rectangle(corner, 12, 12,
                fmt::format("rx=\"2.5\" {} {}", attributes, stroke("#000000", 0.8) + " stroke-opacity=\"0.35\""));
}

void draw_hatched_swatch(SvgCanvas& svg, Point corner) {
  draw_swatch(svg, corner, fill(css(palette::defect)));
  for (const double shift : {4.0, 9.0, 14.0, 19.0}) {
    const double over = std::max(0.0, shift - 12);
    svg.line(corner + Point{over, shift - over}, corner + Point{shift - over, over}, stroke("#A9B3BD", 1));
  }
}

}  // namespace

void draw_region(SvgCanvas& svg, const Solution& solution, const PixelBox& map) {
  const RegionMap& region = solution.region;
  if (region.rows() == 0) return;
  const LinkageFamily& family = *solution.given.family;
  const RegionScale input(family.axis(LinkageFamily::Side::input).branches, region.input_coordinates(),
                          region.input_dyads(), map.height);
  const RegionScale output(family.axis(LinkageFamily::Side::output).branches, region.output_coordinates(),
                           region.output_dyads(), map.width);
  const auto file = region_picture(solution, input, output, pixels_per_px).file();
  svg.png(map.corner(), map.width, map.height, base64(file));
  for (const RegionScale::Block& row : input.blocks()) {
    for (const RegionScale::Block& column : output.blocks()) {
      svg.rectangle({map.left + column.from_px, map.bottom() - row.to_px}, column.to_px - column.from_px,
                    row.to_px - row.from_px, "fill=\"none\" " + stroke(palette::line, 1));
    }
  }
  draw_axis(svg, input, {{map.left, map.bottom()}, {0, -1}, {-1, 0}, -90}, palette::input, "Driving side link, τ₁");
  draw_axis(svg, output, {{map.left, map.bottom()}, {1, 0}, {0, 1}, 0}, palette::output, "Other side link, τ₂");
  draw_best(svg, solution, input, output, map);
}

std::int64_t four_bars_in(const RegionCounts& counts) {
  return counts.pairs - counts.types[static_cast<std::size_t>(LinkageType::degenerate)];
}

void draw_region_legend(SvgCanvas& svg, const Solution& solution, Point corner, double width) {
  constexpr double line = 19, size = 12, swatch = 18;
  const double column = width / 2, number = column - 20;
  const auto entry = [&](std::size_t index) {
    return corner + Point{index < 5 ? 0 : column, line * static_cast<double>(index % 5)};
  };
  constexpr std::array<LinkageType, 8> shown = {LinkageType::crank_rocker,          LinkageType::rocker_crank,
                                                LinkageType::double_crank,          LinkageType::double_rocker,
                                                LinkageType::triple_rocker_ground,  LinkageType::triple_rocker_input,
                                                LinkageType::triple_rocker_coupler, LinkageType::triple_rocker_output};
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const auto type = static_cast<std::size_t>(shown[i]);
    draw_swatch(svg, entry(i), fill(css(palette::types[type])));
    svg.text(entry(i) + Point{swatch, 10.5}, label(shown[i]), {.size = size, .color = palette::ink});
    svg.text(entry(i) + Point{number, 10.5}, grouped_text(solution.counts.types[type]),
             {.size = size, .color = palette::ink2, .anchor = "end"});
  }
  const std::uint32_t washed = palette::mixed(palette::types[2], palette::white, 0.3);
  draw_swatch(svg, entry(8), fill(css(washed)));
  svg.text(entry(8) + Point{swatch, 10.5}, "Pale: requirement fails", {.size = size, .color = palette::ink});
  if (solution.requirements.no_defects) {
    svg.text(entry(8) + Point{number, 10.5}, grouped_text(solution.counts.defect_free - solution.meeting_requirements),
             {.size = size, .color = palette::ink2, .anchor = "end"});
  }
  draw_hatched_swatch(svg, entry(9));
  svg.text(entry(9) + Point{swatch, 10.5}, "Has a defect", {.size = size, .color = palette::ink});
  svg.text(entry(9) + Point{number, 10.5}, grouped_text(four_bars_in(solution.counts) - solution.counts.defect_free),
           {.size = size, .color = palette::ink2, .anchor = "end"});
}

}  // namespace linkwright
