#include <fmt/format.h>

#include "drawing/four_bar/linkage_figure.hpp"
#include "drawing/number_rows.hpp"
#include "drawing/palette.hpp"
#include "drawing/region_figure.hpp"
#include "drawing/sheet.hpp"
#include "drawing/straight_line/straight_line_figure.hpp"
#include "drawing/svg_canvas.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/count_text.hpp"
#include "linkwright/files/label.hpp"
#include "linkwright/files/number_text.hpp"
#include "linkwright/files/task_label.hpp"
#include "straight_line_kind.hpp"

namespace linkwright {
namespace {

using namespace solution_sheet;
constexpr PixelBox line_map_card{836, 84, 580, 664};

std::string line_subtitle(const StraightLineAnswer& answer) {
  const std::string text = sentence_case(task_label(answer.task));
  if (answer.counts.pairs == 0) return text;
  return text + fmt::format("{0}{1} four-bars sampled{0}{2} {3} the requirements", separator,
                            grouped_text(linkages_in(answer.counts)), grouped_text(answer.meeting_requirements),
                            answer.meeting_requirements == 1 ? "meets" : "meet");
}

std::string length_text(double value, std::string_view unit, int digits = 4) {
  return fmt::format("{}{}{}", significant_text(value, digits), unit.empty() ? "" : " ", unit);
}

// The layers lie one above the other, each over the whole axis.
AxisLabel label_of_axis(const StraightLineAnswer& answer, Side side, std::string_view length_unit) {
  AxisLabel label = axis_label(answer, side, length_unit);
  label.branches = answer.family()->axis(side).branches;
  if (label.branches.size() == 1) label.branches.front().name = "range";
  return label;
}

DrawnRegion region_of(const StraightLineAnswer& answer, std::string_view length_unit) {
  return drawn_region(answer, {label_of_axis(answer, Side::input, length_unit), palette::input, {}},
                      {label_of_axis(answer, Side::output, length_unit), palette::output, {}});
}

// ---- The best linkages, small

constexpr double least_width = 240, least_height = 190, caption_height = 40, gap = 14;

struct GalleryGrid {
  std::size_t columns = 1, rows = 1;
};

// As large as so many pictures can be.
GalleryGrid grid_of(const PixelBox& box, std::size_t count) {
  const auto fitting = [](double room, double least) {
    return std::max<std::size_t>(1, static_cast<std::size_t>((room + gap) / (least + gap)));
  };
  const std::size_t most_rows = fitting(box.height, least_height), most_columns = fitting(box.width, least_width);
  const std::size_t rows = std::min(count, most_rows);
  return {std::min((count + rows - 1) / rows, most_columns), rows};
}

void draw_entry(SvgCanvas& svg, const PixelBox& box, const StraightLineAnswer& answer, std::size_t index,
                std::string_view unit) {
  const StraightLineSolution& found = answer.linkages[index];
  const LineMeasure measure = answer.options.line.measure;
  const PixelBox picture{box.left, box.top + caption_height, box.width, box.height - caption_height};
  // Of a search each is of a case of its own.
  const std::string kind = answer.search ? std::string(name(found.task.given)) : std::string(label(found.type));
  svg.text({box.left, box.top + 12}, fit_text(fmt::format("{}  {}", index + 1, kind), 12, 0.92 * box.width),
           {.size = 12, .weight = 650});
  const std::string words =
      fmt::format("{}{}{} within ±{}, {} points", significant_text(found.counted(measure).length(), 4),
                  unit.empty() ? "" : " ", unit, significant_text(found.deviation, 3), found.contact.points);
  svg.text({box.left, box.top + 29}, fit_text(words, 11.5, box.width), {.size = 11.5, .color = palette::ink2});
  draw_small_scene(svg, picture, line_scene(found, measure));
  svg.rectangle(picture.corner(), picture.width, picture.height, "fill=\"none\" " + stroke(palette::line, 1));
}

// The best linkages small, side by side in a rectangle of a picture, each with what it is and its usable length: as
// many as can be told apart there.
void draw_gallery(SvgCanvas& svg, const PixelBox& box, const StraightLineAnswer& answer, std::string_view length_unit) {
  if (answer.linkages.empty()) return;
  const auto [columns, rows] = grid_of(box, answer.linkages.size());
  const auto share = [](double room, std::size_t parts) {
    return (room - gap * static_cast<double>(parts - 1)) / static_cast<double>(parts);
  };
  const double width = share(box.width, columns), height = share(box.height, rows);
  for (std::size_t i = 0; i < std::min(columns * rows, answer.linkages.size()); ++i) {
    const auto row = static_cast<double>(i / columns), column = static_cast<double>(i % columns);
    draw_entry(svg, {box.left + column * (width + gap), box.top + row * (height + gap), width, height}, answer, i,
               length_unit);
  }
}

// ---- The best linkage and its deviation

// What is given, where no linkage shows it.
std::vector<Point> given_pivots(const StraightLineCase& given) {
  return std::visit(
      [](const auto& of) -> std::vector<Point> {
        if constexpr (requires { of.input_pivot; })
          return {of.input_pivot};
        else if constexpr (requires { of.output; })
          return {of.input, of.output};
        else
          return {};
      },
      given);
}

void draw_given(SvgCanvas& svg, const PlaneWindow& window, const StraightLineTask& task) {
  draw_wanted_line(svg, window, task.line);
  for (const Point pivot : given_pivots(task.given)) {
    draw_ground_symbol(svg, window.to_px(pivot));
    draw_pin(svg, window.to_px(pivot), palette::ink2);
  }
  svg.circle(window.to_px(task.line.point), 4.5, fill(palette::accent) + " " + stroke(palette::paper, 1.6));
}

std::vector<Point> given_points(const StraightLineTask& task) {
  std::vector<Point> points = given_pivots(task.given);
  const double reach = size_of(task);
  for (const double side : {-1.0, 0.0, 1.0}) points.push_back(task.line.point + side * reach * task.line.direction);
  return points;
}

void draw_boxes(SvgCanvas& svg, const PlaneWindow& window, const Requirements& wanted) {
  if (wanted.ground_pivots_within) draw_box(svg, window, *wanted.ground_pivots_within, "fixed pivots");
  if (wanted.moving_pivots_within) draw_box(svg, window, *wanted.moving_pivots_within, "moving pivots");
}

void draw_line_card(SvgCanvas& svg, const StraightLineAnswer& answer, std::string_view unit) {
  constexpr double heading = 44, plot_height = 150, above_plot = 30, below_plot = 46, left_of_plot = 70,
                   right_of_plot = 44;
  const bool is_found = !answer.linkages.empty();
  draw_card(svg, task_card, is_found ? "Best linkage" : "The line");
  const double plot_room = is_found ? plot_height + above_plot + below_plot : 0;
  const PixelBox box{task_card.left + 1, task_card.top + heading, task_card.width - 2,
                     task_card.height - heading - 1 - plot_room};
  const std::optional<LineScene> scene =
      is_found ? std::optional(line_scene(answer.linkages.front(), answer.options.line.measure)) : std::nullopt;
  const PlaneWindow window(box, scene ? points_of_interest(*scene) : given_points(answer.task), 40);
  svg.begin_clip(box.corner(), box.width, box.height);
  draw_grid(svg, window);
  draw_boxes(svg, window, answer.requirements);
  if (scene) {
    draw_line_background(svg, window, *scene);
    draw_tracing_linkage(svg, window, *scene);
  } else {
    draw_given(svg, window, answer.task);
  }
  draw_scale_bar(svg, window, {box.left + 22, box.bottom() - 20}, unit);
  svg.end_group();
  if (!scene) return;
  draw_line_keys(svg, {task_card.right(), task_card.top + 24});
  draw_deviation_plot(svg,
                      {task_card.left + left_of_plot, box.bottom() + above_plot,
                       task_card.width - left_of_plot - right_of_plot, plot_height},
                      answer.linkages.front(), answer.options.line.measure, unit);
}

// ---- The map, or what stands in its place

void draw_line_map(SvgCanvas& svg, const StraightLineAnswer& answer, std::string_view unit) {
  constexpr double side = 444, left_axis = 76, ribbon = 72, axis = 70;
  const PixelBox map{line_map_card.left + left_axis, line_map_card.top + 44, side,
                     is_ribbon(answer.family()) ? ribbon : side};
  draw_region(svg, region_of(answer, unit), map);
  const double legend_top = line_map_card.top + 44 + side + axis;
  draw_region_legend(svg, answer, straight_line_linkages, {line_map_card.left + 18, legend_top},
                     line_map_card.width - 24);
  if (!is_ribbon(answer.family())) return;
  const double top = map.bottom() + axis;
  draw_gallery(svg, {line_map_card.left + 18, top, line_map_card.width - 36, legend_top - 16 - top}, answer, unit);
}

void draw_line_map_card(SvgCanvas& svg, const StraightLineAnswer& answer, std::string_view unit) {
  const bool has_map = answer.family() != nullptr && answer.region.rows() > 0 && !is_board(answer.family());
  draw_card(svg, line_map_card,
            has_map         ? "Solution region: every point is one four-bar"
            : answer.search ? "The best of all cases"
                            : "The linkages of this task");
  if (has_map) return draw_line_map(svg, answer, unit);
  if (!answer.linkages.empty())
    return draw_gallery(
        svg, {line_map_card.left + 18, line_map_card.top + 48, line_map_card.width - 36, line_map_card.height - 66},
        answer, unit);
  svg.text({line_map_card.left + line_map_card.width / 2, line_map_card.top + line_map_card.height / 2},
           "There are none, and no number is left open that would make a map.",
           {.size = 14, .color = palette::ink2, .anchor = "middle"});
}

// ---- The best linkage in numbers

void draw_usable_length(SvgCanvas& svg, Point corner, const StraightLineSolution& found, LineMeasure measure,
                        std::string_view unit) {
  draw_type_name(svg, corner, found.type);
  const std::string length = length_text(found.counted(measure).length(), unit);
  svg.text(corner + Point{0, 70}, length, {.size = 28, .weight = 650});
  const Point beside = corner + Point{text_width(length, 28) + 30, 58};
  svg.text(beside, "usable length", {.size = 12, .color = palette::ink2});
  svg.text(beside + Point{0, 15}, fmt::format("within ±{}", length_text(found.deviation, unit, 3)),
           {.size = 12, .color = palette::ink2});
}

void draw_point_rows(SvgCanvas& svg, Point corner, const StraightLineSolution& found, std::string_view unit) {
  const int decimals = length_decimals(found.linkage.longest());
  const auto length = [&](double value) {
    return fmt::format("{}{}{}", rounded_text(value, decimals), unit.empty() ? "" : " ", unit);
  };
  NumberRows rows(svg, corner, 232);
  rows.row("C to input pin", length(found.point_to_input()), palette::input);
  rows.row("C to output pin", length(found.point_to_output()), palette::output);
  rows.row("points of contact",
           fmt::format("{}{}", found.contact.points, found.contact.points == 4 ? ", Ball's point" : ""));
  rows.row("strip, ± δ", length_text(found.deviation, unit, 4));
}

void draw_usable_rows(SvgCanvas& svg, Point corner, const StraightLineSolution& found, LineMeasure measure,
                      std::string_view unit) {
  NumberRows rows(svg, corner, 268);
  rows.row("usable, beside the line", length_text(found.usable.length(), unit));
  rows.row("usable, in the best strip", length_text(found.usable_strip.length(), unit));
  rows.row("over the longest link", significant_text(found.counted(measure).length() / found.linkage.longest(), 3));
  const double deviation = found.worth().deviation;
  rows.row(found.asks_stroke ? "largest deviation, stroke" : "largest deviation over it",
           std::isfinite(deviation) ? length_text(deviation, unit, 3) : "turns back before");
}

std::string place_of_line(const StraightLineFamily& family, const MapNumbers& place) {
  const bool has_second = family.axis(Side::output).quantity != AxisQuantity::nothing;
  const std::string layer(branch_label(family.layer_name(place.layer)));
  if (family.axis(Side::input).quantity == AxisQuantity::nothing) return layer.empty() ? "–" : layer;
  std::string text = significant_text(place.at[0], 5);
  if (has_second) text += ", " + significant_text(place.at[1], 5);
  return layer.empty() ? text : text + ", " + layer;
}

void draw_drive_rows(SvgCanvas& svg, Point corner, const StraightLineSolution& found,
                     const StraightLineAnswer& answer) {
  const StrokeReport& over = found.judged();
  NumberRows rows(svg, corner, 286);
  rows.row("least transmission angle over it", rounded_text(degrees(over.min_transmission_angle), 1) + "°");
  rows.row("velocity, (max − min) / mean",
           over.drive ? significant_text(over.drive->nonuniformity(over.to - over.from), 2) : "–");
  rows.row("input rotation over it",
           over.drive ? rounded_text(degrees(std::abs(over.drive->sweep)), 1) + "°" : "turns back");
  const StraightLineFamily family(found.task, answer.options.line);
  rows.row(answer.search ? "place on its case's map" : "place on the map", place_of_line(family, found.place));
}

void draw_line_strip(SvgCanvas& svg, const StraightLineAnswer& answer, std::string_view unit) {
  if (answer.linkages.empty()) {
    draw_card(svg, strip_card, "No linkage to show");
    return draw_wrapped(svg, strip_card.corner() + Point{18, 54}, answer.reason.message, strip_card.width - 36, 2);
  }
  const StraightLineSolution& best = answer.linkages.front();
  const LineMeasure measure = answer.options.line.measure;
  draw_card(svg, strip_card, "");
  const Point corner = strip_card.corner() + Point{18, -7};
  draw_usable_length(svg, corner + Point{0, 11}, best, measure, unit);
  draw_length_rows(svg, corner + Point{308, 0}, 168, best.lengths, unit);
  draw_point_rows(svg, corner + Point{512, 0}, best, unit);
  draw_usable_rows(svg, corner + Point{776, 0}, best, measure, unit);
  draw_drive_rows(svg, corner + Point{1072, 0}, best, answer);
}

}  // namespace

std::string draw_sheet(const Problem& problem, const StraightLineAnswer& answer) {
  SvgCanvas svg = solution_sheet::begin(problem, line_subtitle(answer));
  draw_line_card(svg, answer, problem.length_unit);
  draw_line_map_card(svg, answer, problem.length_unit);
  draw_line_strip(svg, answer, problem.length_unit);
  return svg.file();
}

}  // namespace linkwright
