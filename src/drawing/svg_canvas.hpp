#pragma once

#include <span>
#include <string>
#include <string_view>

#include "linkwright/algebra/point.hpp"

namespace linkwright {

/// Text as it stands in XML: escaped, characters that XML does not know left out.
[[nodiscard]] std::string xml_text(std::string_view text);

/// About how wide a text of the system's font is, px.
[[nodiscard]] double text_width(std::string_view text, double size);

/// The text, cut with "…" to about `width` px.
[[nodiscard]] std::string fit_text(std::string_view text, double size, double width);

struct TextStyle {
  double size = 13;
  std::string_view color = "#101418";
  std::string_view anchor = "start";  ///< start, middle, end
  int weight = 400;
  double turn = 0;             ///< degrees, clockwise about the position
  std::string_view halo = {};  ///< colour of an outline that keeps the text legible on lines
};

/// An SVG picture as it grows. Coordinates in px, x to the right, y down. `attributes` are SVG's own: fill, stroke, ….
class SvgCanvas {
 public:
  SvgCanvas(double width, double height, std::string_view title);

  void line(Point from, Point to, std::string_view attributes);
  void polyline(std::span<const Point> points, std::string_view attributes);
  void polygon(std::span<const Point> points, std::string_view attributes);
  void circle(Point center, double radius, std::string_view attributes);
  void rectangle(Point corner, double width, double height, std::string_view attributes);
  void text(Point position, std::string_view content, const TextStyle& style = {});
  void png(Point corner, double width, double height, std::string_view base64);

  /// Everything until end_group() shares attributes.
  void begin_group(std::string_view attributes);
  void end_group();
  /// Everything until end_group() is cut at a rectangle.
  void begin_clip(Point corner, double width, double height);

  [[nodiscard]] std::string file() const;

 private:
  std::string content_;
  double width_, height_;
  std::string title_;
  int clips_ = 0;
};

/// Attributes of a line: colour, width, and a dash pattern if any.
[[nodiscard]] std::string stroke(std::string_view color, double width, std::string_view dashes = {});

/// Attributes of an area.
[[nodiscard]] std::string fill(std::string_view color, double opacity = 1);

}  // namespace linkwright
