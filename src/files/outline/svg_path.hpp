#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "linkwright/algebra/point.hpp"
#include "strokes.hpp"

namespace linkwright {

/// p → (a x + c y + e, b x + d y + f): SVG's matrix(a b c d e f).
struct SvgMatrix {
  double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;

  Point operator()(Point p) const { return {a * p.real() + c * p.imag() + e, b * p.real() + d * p.imag() + f}; }
  /// First `inner`, then this.
  SvgMatrix operator*(const SvgMatrix& inner) const;
};

/// Of a `transform` attribute; functions that it does not know, or with a wrong count of numbers, do nothing.
[[nodiscard]] SvgMatrix read_transform(std::string_view text);

/// The numbers in a text, whatever stands between them.
[[nodiscard]] std::vector<double> read_numbers(std::string_view text);

/// The number that an attribute begins with, 0 where there is none.
[[nodiscard]] double attribute_number(std::string_view text);

/// Draws the data of a path as far as they can be read.
void draw_path(std::string_view data, const SvgMatrix& placed, StrokeCollector& collector);

}  // namespace linkwright
