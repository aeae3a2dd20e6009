#pragma once

#include <limits>
#include <string_view>

#include "drawing/plane_window.hpp"
#include "drawing/svg_canvas.hpp"

namespace linkwright {

/// Where the numbers of a plot lie in a rectangle of a picture: places from `left` to `right` across it, and up it
/// whatever values it is to hold.
class PlotScale {
 public:
  PlotScale(const PixelBox& box, double left, double right) : box_(box), left_(left), right_(right) {}

  /// Makes room for a value. There is one before anything else is asked.
  void hold(double value);
  /// Leaves room above and below.
  void widen();

  [[nodiscard]] double x(double place) const { return box_.left + box_.width * (place - left_) / (right_ - left_); }
  [[nodiscard]] double y(double value) const { return box_.bottom() - box_.height * (value - low_) / (high_ - low_); }
  [[nodiscard]] Point at(double place, double value) const { return {x(place), y(value)}; }
  [[nodiscard]] const PixelBox& box() const { return box_; }
  [[nodiscard]] double left() const { return left_; }
  [[nodiscard]] double right() const { return right_; }
  [[nodiscard]] double low() const { return low_; }
  [[nodiscard]] double high() const { return high_; }

 private:
  PixelBox box_;
  double left_, right_;
  double low_ = std::numeric_limits<double>::infinity(), high_ = -std::numeric_limits<double>::infinity();
};

/// The rectangle of a plot with its heading above (18 px).
void draw_plot_frame(SvgCanvas& svg, const PixelBox& box, std::string_view heading);

/// Numbers left of the plot (44 px) with lines across it, and numbers of the places below it with their title (34 px).
struct PlotAxes {
  std::string_view place_title, place_color;
  bool places_are_degrees = false, values_are_degrees = false;
};
void draw_plot_axes(SvgCanvas& svg, const PlotScale& scale, const PlotAxes& axes);

}  // namespace linkwright
