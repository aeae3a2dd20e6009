#pragma once

#include <string_view>
#include <vector>

#include "svg_canvas.hpp"

namespace linkwright {

/// Names points of a figure, each where there is most room about it.
class PointNames {
 public:
  /// What names keep clear of, px.
  explicit PointNames(std::vector<Point> obstacles) : obstacles_(std::move(obstacles)) {}

  void draw(SvgCanvas& svg, Point pin, std::string_view name, std::string_view color);

 private:
  std::vector<Point> obstacles_;
};

}  // namespace linkwright
