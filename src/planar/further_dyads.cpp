#include "further_dyads.hpp"

#include <algorithm>
#include <numbers>

#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

Homogeneous point_in(const double (&numbers)[3][ArmBlock::size], std::size_t lane) {
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

FurtherDyadSolver::FurtherDyadSolver(std::span<const PathPlace> path, bool arm_drives, Simd simd)
    : path_(path), kernel_(arm_kernel.for_simd(simd)) {
  block_.places = static_cast<int>(path.size());
  block_.has_rows = path.size() < ArmBlock::most_places;
  block_.arm_drives = arm_drives;
  block_.zero_share = tolerance::change_point;
  block_.infinity = (1 + 1e-6) * tolerance::infinity;  // finite_point() has what is finite by this
  for (std::size_t j = 0; j < path.size(); ++j) {
    block_.place[j][0] = path[j].jet.front().real();
    block_.place[j][1] = path[j].jet.front().imag();
  }
}

void FurtherDyadSolver::add(Point pivot, const ArmMotion& motion, std::uint8_t senses, std::uint8_t half_turn_senses) {
  const auto lane = static_cast<std::size_t>(block_.count++);
  const auto put = [lane](double(&to)[2][ArmBlock::size], Point value) {
    to[0][lane] = value.real();
    to[1][lane] = value.imag();
  };
  put(block_.pivot, pivot);
  for (std::size_t j = 0; j < path_.size(); ++j) {
    put(block_.link[j], motion.link[j]);
    put(block_.turn[j], motion.turn[j]);
  }
  block_.senses[lane] = senses;
  block_.half_turn_senses[lane] = half_turn_senses;
  if (!block_.has_rows) return;
  const ConditionRows rows = condition_rows(path_, motion);
  for (std::size_t j = 0; j < rows.size(); ++j)
    for (std::size_t k = 0; k < rows[j].size(); ++k) block_.row[j][k][lane] = rows[j][k];
}

FurtherDyads FurtherDyadSolver::of(std::size_t arm) const {
  FurtherDyads found;
  const Point pivot{block_.pivot[0][arm], block_.pivot[1][arm]};
  std::array<Point, ArmBlock::most_dyads> ways;
  for (std::uint8_t place = 0; place < ArmBlock::most_dyads; ++place) {
    if (!block_.real[place][arm]) continue;
    const Point way = upward_direction(pivot, point_in(block_.center[place], arm));
    std::size_t to = found.count++;
    for (; to > 0 && cross(way, ways[to - 1]) > 0; --to) {
      found.at[to] = found.at[to - 1];
      ways[to] = ways[to - 1];
    }
    found.at[to] = place;
    ways[to] = way;
  }
  return found;
}

Dyad FurtherDyadSolver::dyad(std::size_t arm, std::size_t at) const {
  return {point_in(block_.center[at], arm), point_in(block_.circle[at], arm), 0};
}

PairJudgement FurtherDyadSolver::judged(std::size_t arm, std::size_t at) const {
  const double longest = block_.longest[at][arm];
  return {static_cast<LinkageType>(block_.type[at][arm]),
          Defects{block_.defects[at][arm]},
          block_.versine[at][arm],
          block_.full_versine[at][arm],
          longest / block_.shortest[at][arm],
          longest};
}

Dyad partner_of(const ConditionRows& rows, Point center) {
  return {Homogeneous::of(center), normalized(cross(line_of(rows[0], center), line_of(rows[1], center))), 0};
}

}  // namespace linkwright
