#pragma once

#include <string_view>

#include "palette.hpp"
#include "svg_canvas.hpp"

namespace linkwright {

/// Rows of a name on the left and a value on the right.
class NumberRows {
 public:
  NumberRows(SvgCanvas& svg, Point corner, double width) : svg_(svg), corner_(corner), width_(width) {}

  void row(std::string_view name, std::string_view value, std::string_view role_color = {}) {
    constexpr double row_height = 21, first_row = 38;
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

}  // namespace linkwright
