#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "linkwright/algebra/point.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/mechanism/pose.hpp"

namespace linkwright {

/// A shape in the drawing of another program that can be the outline of a body.
struct DrawnShape {
  std::vector<Point> corners;  ///< three or more, as drawn, y up, in the drawing's unit; curves are flattened
  bool closed = false;         ///< else a straight edge closes it
  bool frame = false;          ///< the edge of the sheet, or the border on it
  double width = 0, height = 0;
};

struct Drawing {
  std::vector<DrawnShape>
      shapes;  ///< one at least, 24 at most: closed ones, open chains, frames, each the largest first
  std::optional<double> unit_mm;  ///< millimetres to the drawing's unit, where the file says
  bool listed = false;            ///< the corners of its one shape are the points of a table
};

/// An element of an XML document. `children`: indices in the list of all.
struct XmlElement {
  std::string name;  ///< with its prefix
  std::map<std::string, std::string, std::less<>> attributes{};
  std::vector<std::size_t> children{};

  [[nodiscard]] std::string_view local_name() const {
    return std::string_view(name).substr(name.rfind(':') + 1);  // npos + 1 is 0
  }
  /// Empty where it is not there.
  [[nodiscard]] const std::string& attribute(std::string_view key) const {
    static const std::string none;
    const auto found = attributes.find(key);
    return found == attributes.end() ? none : found->second;
  }
};

/// The elements of a document in their order, each before those inside it; the first is the outermost.
using XmlElements = std::vector<XmlElement>;

/// The shapes of a drawing in ASCII DXF: lines, arcs, circles, ellipses, polylines with bulges and splines of the model
/// space, inserted blocks among them, what meets end to end joined. No chord leaves its curve by more than a thousandth
/// of the curve's size. What is no DXF, is cut off, has no shape or too many points (100 000) is a mistake: `not_dxf`,
/// `binary_dxf`, `dxf_group`, `dxf_cut_off`, `not_xml`, `not_svg`, `no_outline`, `drawing_of_too_much`.
[[nodiscard]] Result<Drawing> read_dxf_outlines(std::string_view text);

/// The same of an SVG: its paths, rectangles, circles, ellipses, lines and polygons where they are drawn.
[[nodiscard]] Result<Drawing> read_svg_outlines(const XmlElements& elements);
/// From its text; not in WebAssembly, where browsers read XML.
[[nodiscard]] Result<Drawing> read_svg_outlines(std::string_view text);

/// Points as a shape: closed where the last is the first again, which then is left out.
[[nodiscard]] Drawing drawing_of_points(std::vector<Point> points);

/// So many points evenly along a shape as it is drawn; of an open one with both ends.
[[nodiscard]] std::vector<Point> points_along(const DrawnShape& shape, int count);

inline constexpr std::size_t max_drawing_bytes = 16'000'000;
/// The same from a file of at most that size whose name ends in .dxf or .svg, or in .csv: read_point_table().
[[nodiscard]] Result<Drawing> read_outlines_file(const std::filesystem::path& path);

/// Lengths in a unit of that name to the drawing's unit; 1 where one of the two is not known.
[[nodiscard]] double drawing_scale(std::optional<double> unit_mm, std::string_view length_unit);

/// The shape as the outline of a body, in the moving frame: `scale` lengths to the drawing's unit, the drawing's origin
/// and x axis at `placed`. At most 200 corners, those left out that matter least; nine digits.
[[nodiscard]] std::vector<Point> body_outline(const DrawnShape& shape, double scale, const Pose& placed);

/// Where a shape goes that nobody has placed.
struct OutlineFit {
  double scale = 1;  ///< the same, or what brings a shape of quite another size to the task's
  Pose placed;       ///< the drawing's origin where it lies in or near the shape, else the shape's middle
  bool resized = false;
};

/// `size`: about how large the body may be, in the unit of `scale`; twenty times as large or as small is another size.
[[nodiscard]] OutlineFit fit_outline(const DrawnShape& shape, double scale, double size);

}  // namespace linkwright
