#include "region_figure.hpp"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <optional>

#include "axis_ticks.hpp"
#include "files/json/base64.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/label.hpp"
#include "linkwright/files/number_text.hpp"
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

  [[nodiscard]] Point at(double px, double distance) const { return start + px * along + distance * away; }
  /// From the middle of a text's height to its base line.
  [[nodiscard]] Point to_baseline() const { return turn == 0 ? Point{0, 4} : Point{4, 0}; }
};

AxisPlace below(const PixelBox& map) { return {{map.left, map.bottom()}, {1, 0}, {0, 1}, 0}; }
AxisPlace left_of(const PixelBox& map) { return {{map.left, map.bottom()}, {0, -1}, {-1, 0}, -90}; }

/// One axis of the map.
struct DrawnAxis {
  const RegionScale& scale;
  std::string title;
  std::string_view color;
  std::vector<AxisTick> ticks;
  bool on_sphere = false;
};

TextStyle axis_text(const AxisPlace& place, double size, std::string_view color, int weight = 400) {
  return {.size = size, .color = color, .anchor = "middle", .weight = weight, .turn = place.turn};
}

void draw_blocks(SvgCanvas& svg, const DrawnAxis& axis, const AxisPlace& place) {
  for (const RegionScale::Block& block : axis.scale.blocks()) {
    svg.line(place.at(block.from_px, axis_distance), place.at(block.to_px, axis_distance), stroke(axis.color, 2));
    const std::string_view words = axis.on_sphere ? cone_branch_label(block.branch) : branch_label(block.branch);
    const double middle = (block.from_px + block.to_px) / 2;
    if (words.empty() || text_width(words, 11) > block.to_px - block.from_px) continue;
    svg.text(place.at(middle, branch_distance) + place.to_baseline(), words, axis_text(place, 11, palette::ink2));
  }
}

/// Of a few grounded links: their numbers.
void draw_numbers(SvgCanvas& svg, const DrawnAxis& axis, const AxisPlace& place) {
  for (const RegionScale::Block& block : axis.scale.blocks()) {
    svg.line(place.at(block.from_px, axis_distance), place.at(block.to_px, axis_distance), stroke(axis.color, 2));
    const int number = static_cast<int>(std::floor(axis.scale.coordinates()[block.first])) + 1;
    svg.text(place.at((block.from_px + block.to_px) / 2, mark_distance + 4) + Point{0, 4}, fmt::format("{}", number),
             {.size = 14, .color = axis.color, .anchor = "middle", .weight = 650});
  }
}

void draw_ticks(SvgCanvas& svg, const DrawnAxis& axis, const AxisPlace& place) {
  for (const AxisTick& tick : axis.ticks) {
    svg.line(place.at(tick.px, axis_distance), place.at(tick.px, axis_distance + 4), stroke(axis.color, 1.2));
    svg.text(place.at(tick.px, mark_distance) + place.to_baseline(), tick.text, axis_text(place, 10.5, palette::ink2));
  }
}

void draw_infinities(SvgCanvas& svg, const DrawnAxis& axis, const AxisPlace& place) {
  double last = -100;
  for (const double px : axis.scale.crossings_of_infinity()) {
    svg.line(place.at(px, axis_distance - 4), place.at(px, axis_distance + 4), stroke(palette::ink, 1.4));
    if (px - last < 14) continue;
    svg.text(place.at(px, mark_distance) + Point{0, 4}, "∞", {.size = 13, .color = palette::ink, .anchor = "middle"});
    last = px;
  }
}

void draw_axis(SvgCanvas& svg, const DrawnAxis& axis, const AxisPlace& place, bool is_discrete = false) {
  is_discrete ? draw_numbers(svg, axis, place) : draw_blocks(svg, axis, place);
  svg.text(place.at(axis.scale.length() / 2, title_distance) + place.to_baseline(), axis.title,
           axis_text(place, 12, axis.color, 650));
  draw_ticks(svg, axis, place);
  if (!is_discrete) draw_infinities(svg, axis, place);
}

/// Rings with numbers where the best linkages lie; dots where a ring would cover another.
void draw_best(SvgCanvas& svg, const std::vector<MapPoint>& best,
               const std::function<std::optional<Point>(MapPoint)>& to_px) {
  constexpr double ring = 9, closest = 2 * ring + 1;
  std::vector<Point> rings;
  std::vector<std::pair<Point, std::size_t>> dots;
  for (std::size_t i = 0; i < best.size(); ++i) {
    const auto at = to_px(best[i]);  // nothing outside the window
    if (!at) continue;
    bool is_free = true;
    for (const Point other : rings) is_free = is_free && std::abs(other - *at) >= closest;
    is_free ? rings.push_back(*at) : void();
    dots.emplace_back(*at, is_free ? i + 1 : 0);
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

/// What a large cell says: its type above the middle, the transmission angle or the defect below.
void draw_cell_text(SvgCanvas& svg, const RegionMap& region, std::size_t cell, Point middle, double width) {
  constexpr double size = 11, leading = 13;
  const LinkageType type = region.type(cell);
  if (type == LinkageType::degenerate) return;
  const TextStyle style{.size = size, .color = palette::ink, .anchor = "middle", .weight = 650, .halo = palette::paper};
  std::string_view words = short_label(type);
  const std::size_t comma = text_width(words, size) > width - 8 ? words.find(", ") : std::string_view::npos;
  double y = comma == std::string_view::npos ? -16 : -16 - leading;
  if (comma != std::string_view::npos) {
    svg.text(middle + Point{0, y}, words.substr(0, comma + 1), style);
    words.remove_prefix(comma + 2);
    y += leading;
  }
  svg.text(middle + Point{0, y}, words, style);
  const Defects defects = region.defects(cell);
  const std::string verdict = defects.circuit()  ? "circuit defect"
                              : defects.branch() ? "branch defect"
                              : defects.order()
                                  ? "order defect"
                                  : fmt::format("γ {}°", rounded_text(degrees(region.min_transmission_angle(cell)), 1));
  svg.text(middle + Point{0, 25}, verdict, style);
}

void draw_frames(SvgCanvas& svg, const RegionScale& up, const RegionScale& across, const PixelBox& map) {
  for (const RegionScale::Block& row : up.blocks()) {
    for (const RegionScale::Block& column : across.blocks()) {
      svg.rectangle({map.left + column.from_px, map.bottom() - row.to_px}, column.to_px - column.from_px,
                    row.to_px - row.from_px, "fill=\"none\" " + stroke(palette::line, 1));
    }
  }
}

void draw_cell_texts(SvgCanvas& svg, const RegionMap& region, const RegionScale& up, const RegionScale& across,
                     const PixelBox& map, bool lies_on_its_side) {
  for (const RegionScale::Block& row : up.blocks()) {
    for (const RegionScale::Block& column : across.blocks()) {
      const Point middle{map.left + (column.from_px + column.to_px) / 2, map.bottom() - (row.from_px + row.to_px) / 2};
      const std::size_t cell =
          lies_on_its_side ? region.index(column.first, row.first) : region.index(row.first, column.first);
      draw_cell_text(svg, region, cell, middle, column.to_px - column.from_px);
    }
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

/// Scales of the map's rows and columns over so many px.
struct MapScales {
  RegionScale input, output;
};

MapScales scales_of(const DrawnRegion& region, double input_length, double output_length) {
  const RegionMap& map = region.found.region;
  return {RegionScale(region.input.label.branches, map.input_coordinates(), region.input.dyads, input_length),
          RegionScale(region.output.label.branches, map.output_coordinates(), region.output.dyads, output_length)};
}

DrawnAxis axis_of(const DrawnRegion& region, const RegionScale& scale, Side side) {
  const DrawnRegion::Axis& axis = side == Side::input ? region.input : region.output;
  return {scale, axis.label.title, axis.color, axis_ticks(scale, region.family, side),
          &region.family.linkages() == &spherical_linkages};
}

/// The picture of a map of one column, its rows from left to right.
PngImage on_its_side(const PngImage& image) {
  PngImage turned{image.height, image.width, image.colors, {}};
  turned.pixels.reserve(image.pixels.size());
  for (std::size_t y = 0; y < turned.height; ++y)
    for (std::size_t x = 0; x < turned.width; ++x)
      turned.pixels.push_back(image.pixels[(image.height - 1 - x) * image.width + y]);
  return turned;
}

void draw_ribbon(SvgCanvas& svg, const DrawnRegion& region, const PixelBox& map) {
  const auto [along, thick] = scales_of(region, map.width, map.height);
  const PngImage picture = region_picture(region.found, region.family, along, thick, pixels_per_px);
  svg.png(map.corner(), map.width, map.height, base64(on_its_side(picture).file()));
  draw_frames(svg, thick, along, map);
  const bool is_discrete = is_board(&region.family);
  draw_axis(svg, axis_of(region, along, Side::input), below(map), is_discrete);
  if (is_discrete) draw_cell_texts(svg, region.found.region, thick, along, map, true);
  draw_best(svg, region.best, [&, &scale = along](MapPoint place) -> std::optional<Point> {
    const auto px = scale.position(place.input);
    if (!px) return std::nullopt;
    return Point{map.left + *px, map.top + map.height / 2};
  });
}

}  // namespace

bool is_ribbon(const LinkageFamily* family) {
  return family && family->axis(Side::output).quantity == AxisQuantity::nothing;
}

bool is_board(const LinkageFamily* family) {
  return family && family->axis(Side::input).is_discrete() && family->axis(Side::output).is_discrete();
}

void draw_region(SvgCanvas& svg, const DrawnRegion& region, const PixelBox& map) {
  if (region.found.region.rows() == 0) return;
  if (is_ribbon(&region.family)) return draw_ribbon(svg, region, map);
  const auto [input, output] = scales_of(region, map.height, map.width);
  svg.png(map.corner(), map.width, map.height,
          base64(region_picture(region.found, region.family, input, output, pixels_per_px).file()));
  draw_frames(svg, input, output, map);
  const bool is_discrete = is_board(&region.family);
  draw_axis(svg, axis_of(region, input, Side::input), left_of(map), region.family.axis(Side::input).is_discrete());
  draw_axis(svg, axis_of(region, output, Side::output), below(map), region.family.axis(Side::output).is_discrete());
  if (is_discrete) draw_cell_texts(svg, region.found.region, input, output, map, false);
  draw_best(svg, region.best, [&, &up = input, &across = output](MapPoint place) -> std::optional<Point> {
    const auto x = across.position(place.output), y = up.position(place.input);
    if (!x || !y) return std::nullopt;
    return Point{map.left + *x, map.bottom() - *y};
  });
}

std::int64_t linkages_in(const RegionCounts& counts) {
  return counts.pairs - counts.types[static_cast<std::size_t>(LinkageType::degenerate)];
}

void draw_region_legend(SvgCanvas& svg, const Findings& found, const LinkageClass& of, Point corner, double width) {
  constexpr double line = 19, size = 12, swatch = 18;
  const double column = width / 2, number = column - 20;
  const std::size_t shown = of.types.size() - 2;  // the last two are change points and what is none
  const std::size_t rows = (shown + 3) / 2;
  const auto entry = [&](std::size_t index) {
    return corner + Point{index < rows ? 0 : column, line * static_cast<double>(index % rows)};
  };
  for (std::size_t i = 0; i < shown; ++i) {
    const auto type = static_cast<std::size_t>(of.types[i]);
    draw_swatch(svg, entry(i), fill(css(palette::types[type])));
    svg.text(entry(i) + Point{swatch, 10.5}, label(of.types[i]), {.size = size, .color = palette::ink});
    svg.text(entry(i) + Point{number, 10.5}, grouped_text(found.counts.types[type]),
             {.size = size, .color = palette::ink2, .anchor = "end"});
  }
  const std::uint32_t washed = palette::mixed(palette::types[2], palette::white, 0.3);
  draw_swatch(svg, entry(shown), fill(css(washed)));
  svg.text(entry(shown) + Point{swatch, 10.5}, "Pale: requirement fails", {.size = size, .color = palette::ink});
  if (found.requirements.no_defects) {
    svg.text(entry(shown) + Point{number, 10.5}, grouped_text(found.counts.defect_free - found.meeting_requirements),
             {.size = size, .color = palette::ink2, .anchor = "end"});
  }
  draw_hatched_swatch(svg, entry(shown + 1));
  svg.text(entry(shown + 1) + Point{swatch, 10.5}, "Has a defect", {.size = size, .color = palette::ink});
  svg.text(entry(shown + 1) + Point{number, 10.5}, grouped_text(linkages_in(found.counts) - found.counts.defect_free),
           {.size = size, .color = palette::ink2, .anchor = "end"});
}

}  // namespace linkwright
