#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <initializer_list>
#include <string>
#include <string_view>

#include "linkwright/files/outline_file.hpp"

// Drawings of other programs, and what is read of them.
namespace linkwright::testing {

/// A group: its code, and its value as it is written.
struct Group {
  int code;
  std::string value;

  Group(int its_code, std::string_view text) : code(its_code), value(text) {}
  Group(int its_code, const char* text) : code(its_code), value(text) {}
  Group(int its_code, int number) : code(its_code), value(std::to_string(number)) {}
  Group(int its_code, double number) : code(its_code), value(fmt::format("{}", number)) {}
};
inline std::string groups(std::initializer_list<Group> list) {
  std::string text;
  for (const Group& group : list) text += fmt::format("{}\r\n{}\r\n", group.code, group.value);
  return text;
}
inline std::string section(std::string_view name, std::string_view content) {
  return groups({{0, "SECTION"}, {2, name}}) + std::string(content) + groups({{0, "ENDSEC"}});
}
inline std::string dxf_of(std::string_view sections) { return std::string(sections) + groups({{0, "EOF"}}); }
inline std::string dxf(std::string_view entities) { return dxf_of(section("ENTITIES", entities)); }

inline std::string line(Point from, Point to) {
  return groups({{0, "LINE"}, {8, "0"}, {10, from.real()}, {20, from.imag()}, {11, to.real()}, {21, to.imag()}});
}
inline std::string arc(Point center, double radius, double from_deg, double to_deg) {
  return groups({{0, "ARC"}, {10, center.real()}, {20, center.imag()}, {40, radius}, {50, from_deg}, {51, to_deg}});
}
/// x, y and bulge.
using Vertex = std::array<double, 3>;
inline std::string polyline(std::initializer_list<Vertex> vertices, bool closed = true) {
  std::string text = groups({{0, "LWPOLYLINE"}, {90, double(vertices.size())}, {70, closed ? 1.0 : 0.0}});
  for (const auto& [x, y, bulge] : vertices) text += groups({{10, x}, {20, y}, {42, bulge}});
  return text;
}
inline std::string rectangle(double x, double y, double width, double height) {
  return polyline({{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}});
}

inline std::string svg(std::string_view inside, std::string_view attributes = "") {
  return fmt::format(R"(<?xml version="1.0"?><svg xmlns:xlink="http://www.w3.org/1999/xlink" {}>{}</svg>)", attributes,
                     inside);
}

inline Drawing drawing_in(const Result<Drawing>& read) {
  EXPECT_TRUE(read.ok()) << (read.ok() ? "" : read.errors()[0].message);
  return read.ok() ? *read : Drawing{{{{0, 1, Point(0, 1)}}}, {}};
}
/// The one shape that there is.
inline DrawnShape shape_in(const Result<Drawing>& read) {
  const Drawing drawing = drawing_in(read);
  EXPECT_EQ(drawing.shapes.size(), 1u);
  return drawing.shapes[0];
}
inline DrawnShape dxf_shape(std::string_view entities) { return shape_in(read_dxf_outlines(dxf(entities))); }
inline DrawnShape svg_shape(std::string_view inside) { return shape_in(read_svg_outlines(svg(inside))); }

using Edges = std::array<double, 4>;
/// Left, right, bottom, top, at three decimals.
inline Edges edges(const DrawnShape& shape) {
  Edges found = {1e300, -1e300, 1e300, -1e300};
  for (const Point p : shape.corners)
    found = {std::min(found[0], p.real()), std::max(found[1], p.real()), std::min(found[2], p.imag()),
             std::max(found[3], p.imag())};
  for (double& value : found) value = std::round(1000 * value) / 1000 + 0.0;
  return found;
}
/// Of the mistake; empty where there is none.
inline std::string code_of(const Result<Drawing>& read) { return read.ok() ? "" : read.errors()[0].code; }

inline double area(const std::vector<Point>& corners) {
  double twice = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point a = corners[i], b = corners[(i + 1) % corners.size()];
    twice += a.real() * b.imag() - a.imag() * b.real();
  }
  return std::abs(twice / 2);
}

}  // namespace linkwright::testing
