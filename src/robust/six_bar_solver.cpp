#include "robust/six_bar_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

constexpr int most_corrections = 30;
constexpr double least_share = 1.0 / 32;  // of the deviations, where they are too large to be made at once

Point unit(Point vector) { return vector / std::abs(vector); }

}  // namespace

/// Lengths that are made, ground pivots in their places, and the driver's normal.
struct SixBarSolver::Target {
  Values half_squares{};  ///< of the lengths
  Joints ground{};
  Point across;
};

SixBarSolver::SixBarSolver(const SixBarDistances& distances, const SixBarOutput& output, std::size_t position)
    : distances_(distances) {
  const SixBarTurns& turns = output.positions[position];
  nominal_.joints = joints_at(output.six_bar, turns);
  const auto [from, to] = distances.guided();
  nominal_.direction = unit(nominal_.joints[to] - nominal_.joints[from]);
  nominal_.origin = guided_pose(output.six_bar, turns, output.reference).origin;
  arm_ = (nominal_.origin - nominal_.joints[from]) * std::conj(nominal_.direction);
  for (const SixBarLength& length : distances.lengths()) longest_ = std::max(longest_, length.length);
  const auto inverse = distances.inverse(nominal_.joints);
  if (!inverse) return;
  positive_ = solve(distances.jacobian(nominal_.joints, distances.moving()), Values{}).determinant > 0;
  inverse_.emplace();
  for (std::size_t column = 0; column < distances.equations(); ++column)
    for (std::size_t row = 0; row < distances.equations(); ++row) (*inverse_)[column][row] = (*inverse)(row, column);
}

SixBarSolver::Target SixBarSolver::target(const SixBarDeviations& deviations, double share) const {
  Target target;
  const auto& lengths = distances_.lengths();
  for (std::size_t k = 0; k < lengths.size(); ++k) {
    const double length = lengths[k].length + share * deviations[k];
    target.half_squares[k] = 0.5 * length * length;
  }
  std::size_t parameter = lengths.size();
  for (const std::size_t pivot : distances_.ground()) {
    target.ground[pivot] = nominal_.joints[pivot] + share * Point{deviations[parameter], deviations[parameter + 1]};
    parameter += 2;
  }
  const Point driver = unit(nominal_.joints[SixBar::b] - nominal_.joints[SixBar::a]);
  target.across = Point{0, 1} * driver * direction(share * deviations[parameter + 2]);
  return target;
}

// Of the equations whose Jacobian at the nominal position is that of the distances.
SixBarSolver::Values SixBarSolver::errors(const Joints& joints, const Target& target) const {
  Values errors{};
  const auto& lengths = distances_.lengths();
  for (std::size_t k = 0; k < lengths.size(); ++k) {
    const Point bar = joints[lengths[k].joints[1]] - joints[lengths[k].joints[0]];
    errors[k] = (0.5 * std::norm(bar) - target.half_squares[k]) / lengths[k].length;
  }
  errors[lengths.size()] = dot(target.across, joints[SixBar::b] - joints[SixBar::a]);
  return errors;
}

// Newton's method with one derivative for all: it converges as fast as the deviations are small.
bool SixBarSolver::close_by(const Inverse& inverse, Joints& joints, const Target& target) const {
  const auto& moving = distances_.moving();
  double last = std::numeric_limits<double>::infinity();
  for (int step = 0; step < most_corrections; ++step) {
    const Values error = errors(joints, target);
    Values change{};
    for (std::size_t column = 0; column < equations; ++column)
      for (std::size_t row = 0; row < equations; ++row) change[row] += inverse[column][row] * error[column];
    double size = 0;
    for (std::size_t k = 0; k < moving.size(); ++k) {
      joints[moving[k]] -= Point{change[2 * k], change[2 * k + 1]};
      size = std::max({size, std::abs(change[2 * k]), std::abs(change[2 * k + 1])});
    }
    if (size <= tolerance::closed * longest_) return true;
    if (!(size <= 0.5 * last)) return false;
    last = size;
  }
  return false;
}

bool SixBarSolver::close_by_newton(Joints& joints, const Target& target) const {
  const auto& moving = distances_.moving();
  const auto& lengths = distances_.lengths();
  double last = std::numeric_limits<double>::infinity();
  for (int step = 0; step < most_corrections; ++step) {
    SmallMatrix jacobian = distances_.jacobian(joints, moving);
    for (std::size_t k = 0; k < lengths.size(); ++k) {
      const double share = std::abs(joints[lengths[k].joints[1]] - joints[lengths[k].joints[0]]) / lengths[k].length;
      for (std::size_t column = 0; column < jacobian.columns(); ++column) jacobian(k, column) *= share;
    }
    const auto [change, determinant] = solve(jacobian, errors(joints, target));
    double size = 0;
    for (std::size_t k = 0; k < moving.size(); ++k) {
      joints[moving[k]] -= Point{change[2 * k], change[2 * k + 1]};
      size = std::max({size, std::abs(change[2 * k]), std::abs(change[2 * k + 1])});
    }
    if (size <= tolerance::last_newton_correction * longest_) return (determinant > 0) == positive_;
    if (!(size <= 0.5 * last)) return false;
    last = size;
  }
  return false;
}

// The deviations made bit by bit.
std::optional<SixBarSolver::Joints> SixBarSolver::followed(const SixBarDeviations& deviations) const {
  Joints joints = nominal_.joints;
  double made = 0;
  for (double share = 1; made < 1;) {
    const Target there = target(deviations, made + share);
    Joints next = joints;
    for (const std::size_t pivot : distances_.ground()) next[pivot] = there.ground[pivot];
    if (close_by_newton(next, there)) {
      joints = next;
      made += share;
    } else {
      share /= 2;
    }
    if (share < least_share) return std::nullopt;
  }
  return joints;
}

// Lengths above zero, and bodies of three hinges that are triangles.
bool SixBarSolver::can_be_made(const SixBarDeviations& deviations) const {
  const auto& lengths = distances_.lengths();
  const auto made = [&](std::size_t k) { return lengths[k].length + deviations[k]; };
  for (std::size_t k = 0; k < lengths.size(); ++k)
    if (!(made(k) > 0)) return false;
  return std::none_of(distances_.triangles().begin(), distances_.triangles().end(), [&](std::size_t k) {
    const double half = (made(k) + made(k + 1) + made(k + 2)) / 2;
    return half <= made(k) || half <= made(k + 1) || half <= made(k + 2);
  });
}

std::optional<SixBarSolver::State> SixBarSolver::made(const SixBarDeviations& deviations) const {
  if (!inverse_ || !can_be_made(deviations)) return std::nullopt;
  const Target there = target(deviations, 1);
  Joints joints = nominal_.joints;
  for (const std::size_t pivot : distances_.ground()) joints[pivot] = there.ground[pivot];
  if (!close_by(*inverse_, joints, there)) {
    const auto found = followed(deviations);
    if (!found) return std::nullopt;
    joints = *found;
  }
  const auto [from, to] = distances_.guided();
  const Point direction = unit(joints[to] - joints[from]);
  const std::size_t point = distances_.parameters() - 3;
  const Point arm = arm_ + Point{deviations[point], deviations[point + 1]};
  return State{joints, joints[from] + arm * direction, direction};
}

}  // namespace linkwright
