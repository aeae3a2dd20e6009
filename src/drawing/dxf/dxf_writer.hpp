#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "linkwright/algebra/point.hpp"
#include "linkwright/mechanism/pose.hpp"

namespace linkwright {

/// The layer of the positions of a linkage after the first.
inline constexpr std::string_view positions_layer = "POSITIONS";

struct DxfLayer {
  std::string_view name;
  int color = 7;  ///< AutoCAD colour index
};

/// Builds the text of a DXF file of version AC1015 (AutoCAD 2000): entities first, then file() puts the tables round
/// them.
class DxfWriter {
 public:
  /// `units`: value of $INSUNITS; `layers`: beside layer 0.
  DxfWriter(int units, std::vector<DxfLayer> layers) : units_(units), layers_(std::move(layers)) {}

  void line(std::string_view layer, Point from, Point to);
  void circle(std::string_view layer, Point center, double radius);
  /// Counter-clockwise from one angle to another, radians.
  void arc(std::string_view layer, Point center, double radius, double from, double to);
  void polyline(std::string_view layer, std::span<const Point> points, bool closed);
  /// Horizontal text, `position` its lower left corner; ASCII.
  void text(std::string_view layer, Point position, double height, std::string_view content);

  [[nodiscard]] std::string file() const;

 private:
  void begin_entity(std::string_view type, std::string_view layer);
  void include(Point point, double margin = 0);

  int units_;
  std::vector<DxfLayer> layers_;
  std::string entities_;
  unsigned next_handle_ = 0x100;  ///< smaller ones belong to the tables
  Point low_{1e300, 1e300}, high_{-1e300, -1e300};
};

/// $INSUNITS of a length unit.
[[nodiscard]] int insert_units(std::string_view unit);

/// A link: an outline with round ends, and the holes of its pins.
void draw_link(DxfWriter& dxf, std::string_view layer, Point from, Point to, double radius);

/// A pin on the ground, with its feet.
void draw_ground_pivot(DxfWriter& dxf, std::string_view layer, Point pivot, double radius);

/// A moving frame with its number.
void draw_frame(DxfWriter& dxf, std::string_view layer, const Pose& pose, std::size_t number, double size);

}  // namespace linkwright
