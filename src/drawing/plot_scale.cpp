#include "plot_scale.hpp"

#include <algorithm>

#include "axis_ticks.hpp"
#include "linkwright/files/number_text.hpp"
#include "palette.hpp"

namespace linkwright {

void PlotScale::hold(double value) {
  low_ = std::min(low_, value);
  high_ = std::max(high_, value);
}

void PlotScale::widen() {
  constexpr double smallest = 1e-12;  // rounding is no curve
  const double room = 0.12 * std::max(high_ - low_, smallest);
  low_ -= room;
  high_ += room;
}

void draw_plot_frame(SvgCanvas& svg, const PixelBox& box, std::string_view heading) {
  svg.text({box.left, box.top - 8}, heading, {.size = 12, .weight = 650});
  svg.rectangle(box.corner(), box.width, box.height, fill(palette::paper) + " " + stroke(palette::line, 1));
}

void draw_plot_axes(SvgCanvas& svg, const PlotScale& scale, const PlotAxes& axes) {
  constexpr double size = 11;
  const PixelBox& box = scale.box();
  for (const double value : even_ticks(scale.low(), scale.high(), box.height, 24, axes.values_are_degrees)) {
    svg.line({box.left, scale.y(value)}, {box.right(), scale.y(value)}, stroke(palette::grid, 1));
    svg.text({box.left - 7, scale.y(value) + 4}, significant_text(value, 3),
             {.size = size, .color = palette::ink2, .anchor = "end"});
  }
  for (const double place : even_ticks(scale.left(), scale.right(), box.width, 48, axes.places_are_degrees)) {
    svg.line({scale.x(place), box.bottom()}, {scale.x(place), box.bottom() + 4}, stroke(palette::ink2, 1));
    svg.text({scale.x(place), box.bottom() + 17}, significant_text(place, 4),
             {.size = size, .color = palette::ink2, .anchor = "middle"});
  }
  svg.text({box.left + box.width / 2, box.bottom() + 34}, axes.place_title,
           {.size = 12, .color = axes.place_color, .anchor = "middle", .weight = 650});
}

}  // namespace linkwright
