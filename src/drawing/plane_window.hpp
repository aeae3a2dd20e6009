#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "linkwright/algebra/point.hpp"

namespace linkwright {

/// A rectangle of a picture, px, y down.
struct PixelBox {
  double left = 0, top = 0, width = 0, height = 0;
  [[nodiscard]] Point corner() const { return {left, top}; }
  [[nodiscard]] double right() const { return left + width; }
  [[nodiscard]] double bottom() const { return top + height; }
};

/// Shows a part of the fixed frame in a rectangle of a picture, the same scale both ways.
class PlaneWindow {
 public:
  /// The smallest part that holds all `points` with `margin` px round them.
  PlaneWindow(const PixelBox& box, std::span<const Point> points, double margin);

  [[nodiscard]] const PixelBox& box() const { return box_; }
  [[nodiscard]] double scale() const { return scale_; }  ///< px per unit of the user's length
  [[nodiscard]] Point to_px(Point p) const;
  [[nodiscard]] Point to_user(Point px) const;

  /// The part of a straight stretch (px) inside the rectangle, a little beyond its borders; nothing outside.
  [[nodiscard]] std::optional<std::pair<Point, Point>> clipped(Point from, Point to) const;
  /// A path (px) cut into the pieces that can be seen.
  [[nodiscard]] std::vector<std::vector<Point>> clipped(std::span<const Point> path) const;

 private:
  PixelBox box_;
  double scale_ = 1;
  Point center_{};
};

/// The largest of 1, 2, 5 × 10ⁿ that is not larger.
[[nodiscard]] double round_length(double length);

}  // namespace linkwright
