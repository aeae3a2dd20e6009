#include "error_plot.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>

#include "drawing/palette.hpp"
#include "drawing/plot_scale.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/number_text.hpp"

namespace linkwright {
namespace {

/// A value over the input, both in degrees; nothing where the drive does not get to the input.
struct PlotPoint {
  double input = 0;
  std::optional<double> value;
};

PlotScale scale_of(const PixelBox& box, const std::vector<PlotPoint>& points) {
  PlotScale scale(box, points.front().input, points.back().input);
  for (const PlotPoint& point : points)
    if (point.value) scale.hold(*point.value);
  return scale;
}

PlotAxes axes_by_input(bool values_are_degrees) { return {"Input, degrees", palette::input, true, values_are_degrees}; }

void draw_gaps(SvgCanvas& svg, const PixelBox& box, const PlotScale& scale, const FunctionError& error) {
  for (const AngleRange& gap : error.unreached) {
    const double from = scale.x(degrees(gap.from)), to = scale.x(degrees(gap.to));
    svg.rectangle({from, box.top}, to - from, box.height, fill(fmt::format("#{:06X}", palette::defect), 0.8));
    constexpr std::string_view words = "not reached";
    if (to - from > text_width(words, 11) + 8)
      svg.text({(from + to) / 2, box.top + 16}, words, {.size = 11, .color = palette::ink2, .anchor = "middle"});
  }
}

void draw_curve(SvgCanvas& svg, const PlotScale& scale, const std::vector<PlotPoint>& points) {
  std::vector<Point> piece;
  const auto end_piece = [&] {
    svg.polyline(piece, stroke(palette::accent, 2) + " stroke-linejoin=\"round\"");
    piece.clear();
  };
  for (const PlotPoint& point : points) {
    if (point.value)
      piece.emplace_back(scale.x(point.input), scale.y(*point.value));
    else
      end_piece();
  }
  end_piece();
}

void draw_pair_mark(SvgCanvas& svg, Point at, std::size_t number) {
  svg.circle(at, 8, fill(palette::paper) + " " + stroke(palette::ink, 1.4));
  svg.text(at + Point{0, 4}, fmt::format("{}", number), {.size = 10.5, .anchor = "middle", .weight = 650});
}

/// The error as drawn where its magnitude is largest: that of the nearest sample carries the sign.
void draw_largest(SvgCanvas& svg, const PixelBox& box, const PlotScale& scale, const FunctionError& error) {
  if (!error.max_structural_error) return;
  const ErrorSample* nearest = nullptr;
  for (const ErrorSample& sample : error.samples)
    if (sample.generated && (nearest == nullptr ||
                             std::abs(sample.input - error.worst_input) < std::abs(nearest->input - error.worst_input)))
      nearest = &sample;
  if (nearest == nullptr || !nearest->generated) return;
  const double sign = *nearest->generated < nearest->wanted ? -1 : 1;
  const Point at{scale.x(degrees(error.worst_input)), scale.y(sign * degrees(*error.max_structural_error))};
  svg.circle(at, 3.6, fill(palette::bad));
  const bool to_the_left = at.real() > box.left + 0.6 * box.width;
  svg.text(at + Point{to_the_left ? -8.0 : 8.0, sign > 0 ? -2.0 : 10.0},
           fmt::format("{}°", significant_text(sign * degrees(*error.max_structural_error), 3)),
           {.size = 12,
            .color = palette::bad,
            .anchor = to_the_left ? "end" : "start",
            .weight = 650,
            .halo = palette::paper});
}

}  // namespace

void draw_error_plot(SvgCanvas& svg, const PixelBox& box, const FunctionError& error, const WantedFunction& wanted) {
  if (error.samples.size() < 2) return;
  std::vector<PlotPoint> points;
  for (const ErrorSample& sample : error.samples) {
    points.push_back({degrees(sample.input), std::nullopt});
    if (sample.generated) points.back().value = degrees(*sample.generated - sample.wanted);
  }
  PlotScale scale = scale_of(box, points);
  scale.hold(0);
  scale.widen();
  draw_plot_frame(svg, box, "Structural error of linkage 1: generated minus desired output, degrees");
  draw_plot_axes(svg, scale, axes_by_input(false));
  svg.line({box.left, scale.y(0)}, {box.right(), scale.y(0)}, stroke(palette::curve, 1.2));
  draw_gaps(svg, box, scale, error);
  draw_curve(svg, scale, points);
  for (std::size_t i = 0; i < wanted.pairs.size() && i < error.at_pairs.size(); ++i)
    draw_pair_mark(svg, {scale.x(degrees(wanted.pairs[i].input)), scale.y(degrees(error.at_pairs[i].value_or(0)))},
                   i + 1);
  draw_largest(svg, box, scale, error);
}

void draw_output_plot(SvgCanvas& svg, const PixelBox& box, const GeneratedFunction& generated,
                      const WantedFunction& wanted) {
  constexpr int steps = 180;
  constexpr double beyond = 0.06;  // of the range of the pairs
  const auto [first, last] =
      std::minmax_element(wanted.pairs.begin(), wanted.pairs.end(),
                          [](const AnglePair& a, const AnglePair& b) { return a.input < b.input; });
  const double range = std::max(last->input - first->input, radians(10));
  const double low = first->input - beyond * range, high = first->input + (1 + beyond) * range;
  std::vector<PlotPoint> points;
  double near = first->output;
  for (int i = 0; i <= steps; ++i) {
    const double input = low + (high - low) * i / steps;
    const auto output = generated.output_at(input, near);
    points.push_back({degrees(input), std::nullopt});
    if (!output) continue;
    near = *output;
    points.back().value = degrees(near);
  }
  PlotScale scale = scale_of(box, points);
  for (const AnglePair& pair : wanted.pairs) scale.hold(degrees(pair.output));
  scale.widen();
  draw_plot_frame(svg, box, "Function generated by linkage 1: output over input, degrees");
  draw_plot_axes(svg, scale, axes_by_input(true));
  draw_curve(svg, scale, points);
  for (std::size_t i = 0; i < wanted.pairs.size(); ++i)
    draw_pair_mark(svg, {scale.x(degrees(wanted.pairs[i].input)), scale.y(degrees(wanted.pairs[i].output))}, i + 1);
}

}  // namespace linkwright
