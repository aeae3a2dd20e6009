#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <string>
#include <vector>

#include "drawing/palette.hpp"
#include "drawing/plot_scale.hpp"
#include "linkwright/files/number_text.hpp"
#include "straight_line_figure.hpp"

namespace linkwright {
namespace {

using PathStates = std::vector<StraightPath::State>;

// The path over the usable length and the stroke, and a little beyond.
PathStates states_about(const StraightLineSolution& found, const UsableLine& usable) {
  constexpr double beyond = 0.15;
  constexpr int count = 281;
  double from = usable.from, to = usable.to;
  if (found.stroke) {
    from = std::min(from, found.stroke->from);
    to = std::max(to, found.stroke->to);
  }
  PathLimits limits;
  limits.from = from - beyond * (to - from);
  limits.to = to + beyond * (to - from);
  const auto path = StraightPath::of(found.linkage, found.task.line.direction, limits);
  return path ? path->states(count) : PathStates{};
}

// Both borders of the strip: about the line, or as the deviation has it over the usable length.
struct Strip {
  double low = 0, high = 0;
};
Strip strip_of(const PathStates& states, const UsableLine& usable, double deviation, LineMeasure measure) {
  if (measure == LineMeasure::tangent) return {-deviation, deviation};
  double low = 0, high = 0;
  for (const auto& state : states)
    if (state.s >= usable.from && state.s <= usable.to) {
      low = std::min(low, state.e);
      high = std::max(high, state.e);
    }
  return {(low + high) / 2 - deviation, (low + high) / 2 + deviation};
}

PlotScale scale_of(const PixelBox& box, const PathStates& states, const Strip& strip,
                   const StraightLineSolution& found) {
  constexpr double room = 0.3;
  const double margin = room * (strip.high - strip.low);
  PlotScale scale(box, states.front().s, states.back().s);
  scale.hold(0);
  scale.hold(strip.low - margin);
  scale.hold(strip.high + margin);
  for (const auto& state : states)
    if (found.stroke && state.s >= found.stroke->from && state.s <= found.stroke->to)
      for (const double room_for_it : {-1.15, 1.15}) scale.hold(room_for_it * std::abs(state.e));
  return scale;
}

void draw_strip(SvgCanvas& svg, const PlotScale& scale, const Strip& strip) {
  const PixelBox& box = scale.box();
  const double top = scale.y(strip.high), bottom = scale.y(strip.low);
  svg.rectangle({box.left, top}, box.width, bottom - top, fill(palette::good, 0.08));
  for (const double y : {top, bottom}) svg.line({box.left, y}, {box.right(), y}, stroke(palette::good, 1.2, "5 4"));
  if (bottom - top < 14) return;
  const TextStyle style{.size = 11, .color = palette::good, .weight = 650};
  svg.text({box.right() + 6, top + 4}, "+δ", style);
  svg.text({box.right() + 6, bottom + 4}, "−δ", style);
}

void draw_end(SvgCanvas& svg, const PlotScale& scale, double s, PathEnd end) {
  const PixelBox& box = scale.box();
  svg.line({scale.x(s), box.top}, {scale.x(s), box.bottom()}, stroke(palette::accent, 1.2, "2 3"));
  if (end != PathEnd::turn) return;
  const bool to_the_left = scale.x(s) > box.left + box.width / 2;
  svg.text({scale.x(s) + (to_the_left ? -6.0 : 6.0), box.bottom() - 7}, "turns back",
           {.size = 11, .color = palette::accent, .anchor = to_the_left ? "end" : "start", .halo = palette::paper});
}

void draw_stretch(SvgCanvas& svg, const PlotScale& scale, const PathStates& states, const UsableLine& range,
                  const std::string& attributes) {
  std::vector<Point> curve;
  for (const auto& state : states)
    if (state.s >= range.from && state.s <= range.to) curve.push_back(scale.at(state.s, state.e));
  svg.polyline(curve, attributes + " stroke-linejoin=\"round\"");
}

void draw_contact(SvgCanvas& svg, Point at, int points) {
  svg.circle(at, 8, fill(palette::paper) + " " + stroke(palette::ink, 1.4));
  svg.text(at + Point{0, 4}, fmt::format("{}", points), {.size = 10.5, .anchor = "middle", .weight = 650});
}

// How many points path and line have in common where.
void draw_contacts(SvgCanvas& svg, const PlotScale& scale, const StraightLineSolution& found) {
  const auto* mixed = std::get_if<straight_cases::MixedContacts>(&found.task.given);
  if (mixed == nullptr) return draw_contact(svg, scale.at(0, 0), found.contact.points);
  const double first = mixed->contacts.front().s;
  for (const PlacedContact& contact : mixed->contacts)
    draw_contact(svg, scale.at(contact.s - first, 0), contact.multiplicity);
}

// The stroke that is asked for, on the lower edge.
void draw_stroke_bar(SvgCanvas& svg, const PlotScale& scale, const StrokeReport& stroke_report) {
  const double left = scale.x(stroke_report.from), right = scale.x(stroke_report.to), y = scale.box().bottom();
  svg.line({left, y}, {right, y}, stroke(palette::ink, 3));
  svg.text({(left + right) / 2, y - 6},
           fmt::format("stroke, off the line by {} at most", significant_text(stroke_report.max_deviation, 3)),
           {.size = 11, .color = palette::ink, .anchor = "middle", .halo = palette::paper});
}

std::string heading_of(const PlotScale& scale, std::string_view unit) {
  const PixelBox& box = scale.box();
  const double magnified = (box.height / (scale.high() - scale.low())) / (box.width / (scale.right() - scale.left()));
  return fmt::format("Deviation of C from the line, to the left of its direction{}{}, magnified {}-fold",
                     unit.empty() ? "" : ", ", unit, significant_text(magnified, 2));
}

}  // namespace

void draw_deviation_plot(SvgCanvas& svg, const PixelBox& box, const StraightLineSolution& found, LineMeasure measure,
                         std::string_view length_unit) {
  const UsableLine& usable = found.counted(measure);
  const PathStates states = states_about(found, usable);
  if (states.empty() || !(states.back().s > states.front().s) || !(found.deviation > 0)) return;
  const Strip strip = strip_of(states, usable, found.deviation, measure);
  const PlotScale scale = scale_of(box, states, strip, found);
  const std::string title =
      fmt::format("Way s of the point along the line{}{}", length_unit.empty() ? "" : ", ", length_unit);
  draw_plot_frame(svg, box, heading_of(scale, length_unit));
  draw_strip(svg, scale, strip);
  draw_plot_axes(svg, scale, {title, palette::ink2});
  svg.line({box.left, scale.y(0)}, {box.right(), scale.y(0)}, stroke(palette::curve, 1.2));
  svg.begin_clip(box.corner(), box.width, box.height);
  draw_end(svg, scale, usable.from, usable.begin);
  draw_end(svg, scale, usable.to, usable.end);
  draw_stretch(svg, scale, states, {scale.left(), scale.right()}, stroke(palette::accent, 1.2));
  draw_stretch(svg, scale, states, usable, stroke(palette::accent, 2.6));
  svg.end_group();
  if (found.stroke) draw_stroke_bar(svg, scale, *found.stroke);
  draw_contacts(svg, scale, found);
}

}  // namespace linkwright
