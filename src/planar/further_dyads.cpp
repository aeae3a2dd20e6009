#include "further_dyads.hpp"

#include <algorithm>
#include <numbers>

namespace linkwright {
namespace {

Homogeneous point_in(const double (&numbers)[3][FurtherDyadBlock::size], std::size_t lane) {
  return {numbers[0][lane], numbers[1][lane], numbers[2][lane]};
}

// From a centre to a point that may be at infinity, in the upper half-plane.
Point upward_direction(Point from, Homogeneous to) {
  const Point way = to.vector() - to.w * from;
  return way.imag() < 0 || (way.imag() == 0 && way.real() < 0) ? -way : way;
}

Homogeneous line_of(const ConditionRow& row, Point c) {
  const double half = std::numbers::sqrt2 / 2;
  return {row[6] + row[4] * c.real() + row[5] * c.imag(), row[2] + half * (row[0] * c.real() - row[1] * c.imag()),
          row[3] + half * (row[0] * c.imag() + row[1] * c.real())};
}

}  // namespace

void FurtherDyadSolver::add(const ConditionRows& rows, Point center, Point circle) {
  const auto lane = static_cast<std::size_t>(block_.count++);
  for (std::size_t j = 0; j < rows.size(); ++j)
    for (std::size_t k = 0; k < rows[j].size(); ++k) block_.row[j][k][lane] = rows[j][k];
  block_.known_center[0][lane] = center.real();
  block_.known_center[1][lane] = center.imag();
  block_.known_circle[0][lane] = circle.real();
  block_.known_circle[1][lane] = circle.imag();
}

FurtherDyads FurtherDyadSolver::of(std::size_t task) const {
  FurtherDyads found;
  const Point center{block_.known_center[0][task], block_.known_center[1][task]};
  std::array<Point, FurtherDyadBlock::most> ways;
  for (std::size_t place = 0; place < FurtherDyadBlock::most; ++place) {
    if (!block_.real[place][task]) continue;
    const Dyad dyad{point_in(block_.center[place], task), point_in(block_.circle[place], task), 0};
    const Point way = upward_direction(center, dyad.center);
    std::size_t to = found.count++;
    for (; to > 0 && cross(way, ways[to - 1]) > 0; --to) {
      found.dyads[to] = found.dyads[to - 1];
      ways[to] = ways[to - 1];
    }
    found.dyads[to] = dyad;
    ways[to] = way;
  }
  return found;
}

Dyad partner_of(const ConditionRows& rows, Point center) {
  return {Homogeneous::of(center), normalized(cross(line_of(rows[0], center), line_of(rows[1], center))), 0};
}

}  // namespace linkwright
