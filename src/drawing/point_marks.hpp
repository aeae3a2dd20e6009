#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "plane_window.hpp"
#include "svg_canvas.hpp"

namespace linkwright {

/// Marks points of the plane as they are added, and names them when all are known; those outside the window are left
/// out.
class PointMarks {
 public:
  /// Names keep clear of `taken` (px) and of the marks.
  PointMarks(SvgCanvas& svg, const PlaneWindow& window, std::vector<Point> taken)
      : svg_(svg), window_(window), taken_(std::move(taken)) {}

  void add(Point at, std::string name, std::string_view color);
  void square(Point at, std::string_view color);
  /// Of a point that is drawn already.
  void name_only(Point at, std::string name, std::string_view color);

  void name();

 private:
  [[nodiscard]] bool is_seen(Point px) const;

  struct Named {
    Point px;
    std::string name;
    std::string_view color;
  };
  SvgCanvas& svg_;
  const PlaneWindow& window_;
  std::vector<Point> taken_;
  std::vector<Named> named_;
};

/// The square of a mark about a place (px), for keys.
void draw_square_mark(SvgCanvas& svg, Point px, std::string_view color);

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
