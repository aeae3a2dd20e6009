#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "drawing/plane_window.hpp"
#include "drawing/svg_canvas.hpp"
#include "linkwright/algebra/vector3.hpp"
#include "linkwright/attitude/displacement.hpp"

namespace linkwright {

/// Where a vector lies in the picture: an orthographic view from above and in front, z upwards, x to the lower left, y
/// to the right. Plane coordinates in the vector's own unit, y upwards.
[[nodiscard]] Point seen(Vector3 r);

/// Unit vector towards the one who looks.
[[nodiscard]] Vector3 towards_viewer();

/// A part of a picture that shows space. Nothing is hidden by anything else. Labels are set by finish(), where they
/// cover neither each other nor, if possible, lines.
class SpaceFigure {
 public:
  /// Shows all `points` in the rectangle with `margin` px round them.
  SpaceFigure(SvgCanvas& svg, const PixelBox& box, std::span<const Vector3> points, double margin);

  void line(Vector3 from, Vector3 to, std::string_view color, double width, std::string_view dashes = {});
  void arrow(Vector3 from, Vector3 to, std::string_view color, double width, std::string_view dashes = {});
  void path(std::span<const Vector3> points, std::string_view color, double width, std::string_view dashes = {});
  /// A path that ends in an arrow head.
  void arrow_along(std::span<const Vector3> points, std::string_view color, double width);
  /// The area between a centre and a path.
  void sector(Vector3 center, std::span<const Vector3> rim, std::string_view color);
  void dot(Vector3 at, std::string_view color);

  /// Three arrows of a length from the displacement's origin; `names` "x₀", "y₀", "z₀" at their tips.
  void triad(const Displacement& frame, double length, std::string_view color, double width,
             const std::array<std::string, 3>& names);

  /// A text beside the place, if possible on the side away from `from`.
  void label(Vector3 at, std::string text, std::string_view color, Vector3 from = {}, double size = 14);

  /// Sets the labels; once, at the end.
  void finish();

 private:
  struct Label {
    Point at, away;  ///< px; unit vector of the preferred direction
    std::string text;
    std::string_view color;
    double size = 14;
  };

  [[nodiscard]] Point to_px(Vector3 r) const { return window_.to_px(seen(r)); }
  void keep_clear(Point from, Point to);
  void head(Point tip, Point direction, std::string_view color, double width);
  [[nodiscard]] PixelBox place(const Label& label, const std::vector<PixelBox>& taken) const;
  [[nodiscard]] double cost(const PixelBox& box, const std::vector<PixelBox>& taken) const;

  SvgCanvas* svg_;
  PlaneWindow window_;
  std::vector<Point> obstacles_;  ///< points of lines, px
  std::vector<Label> labels_;
};

/// An angle in degrees, as captions have it.
[[nodiscard]] std::string degrees_text(double angle);

/// Points of the arc that `from` (a point relative to `center`) describes about the unit axis by the angle, with a
/// slide along the axis; ends included.
[[nodiscard]] std::vector<Vector3> helix(Vector3 center, Vector3 axis, Vector3 from, double angle, double slide = 0);

}  // namespace linkwright
