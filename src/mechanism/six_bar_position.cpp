#include "linkwright/mechanism/six_bar_position.hpp"

#include <algorithm>
#include <cmath>

#include "algebra/dense.hpp"
#include "linkwright/core/tolerance.hpp"
#include "six_bar_loops.hpp"

namespace linkwright {
namespace {

using Joints = std::array<Point, SixBar::joint_count>;

// The hinge by which a body depends on the one before it.
constexpr std::array<SixBar::JointIndex, SixBar::bodies> hanging = {SixBar::a, SixBar::a,  SixBar::b,
                                                                    SixBar::d, SixBar::c4, SixBar::c5};

/// Where a point of a body lies once its hanging hinge is in its place.
Point carried(const SixBar& six_bar, const SixBarTurns& turns, const Joints& joints, int body, Point point) {
  if (body == 0) return point;
  const auto i = static_cast<std::size_t>(body);
  return joints[hanging[i]] + turns[i] * (point - six_bar.at(hanging[i]));
}

}  // namespace

std::array<Point, SixBar::joint_count> joints_at(const SixBar& six_bar, const SixBarTurns& turns) {
  Joints joints{};
  joints[SixBar::a] = six_bar.at(SixBar::a);
  for (const auto j : {SixBar::b, SixBar::d, SixBar::c4, SixBar::z4, SixBar::c5, SixBar::z5}) {
    // Circle points as the body has them that the added link is tied to.
    const bool circle_point = j == SixBar::z4 || j == SixBar::z5;
    joints[j] = carried(six_bar, turns, joints, six_bar.joints[j].bodies[circle_point ? 1 : 0], six_bar.at(j));
  }
  return joints;
}

Pose guided_pose(const SixBar& six_bar, const SixBarTurns& turns, const Pose& reference) {
  const Joints joints = joints_at(six_bar, turns);
  return {carried(six_bar, turns, joints, SixBar::guided, reference.origin),
          reference.angle + std::arg(turns[SixBar::guided])};
}

double closure_error(const SixBar& six_bar, const SixBarTurns& turns) {
  const Joints joints = joints_at(six_bar, turns);
  double longest = 0, worst = 0;
  for (const SixBarLength& length : six_bar.lengths()) longest = std::max(longest, length.length);
  for (const auto& [body, joint] : {std::pair{4, SixBar::z4}, std::pair{5, SixBar::z5}})
    worst = std::max(worst, std::abs(carried(six_bar, turns, joints, body, six_bar.at(joint)) - joints[joint]));
  return longest > 0 ? worst / longest : 0;
}

SixBarTransmission six_bar_transmission(const SixBar& six_bar, const SixBarTurns& turns) {
  const SixBarLoops loops(six_bar);
  const LoopValues values(loops, turns);
  SixBarTransmission result = signs_of(loops, values);
  const std::array<double, 2> sines = sines_of(loops, values);
  result.sine = std::min(sines[0], sines[1]);
  return result;
}

std::optional<SixBarTurns> closed(const SixBar& six_bar, const SixBarTurns& guess) {
  constexpr int max_corrections = 20;
  const SixBarLoops loops(six_bar);
  SixBarTurns turns = guess;
  double error = 1;
  for (int step = 0; step < max_corrections; ++step) {
    const LoopValues at(loops, turns);
    error = std::max(std::abs(at.f), std::abs(at.g));
    if (error <= tolerance::closed_to_rounding) return turns;
    DenseMatrix<4, 4> jacobian;
    for (std::size_t i = 0; i < 4; ++i) {
      const Point u = at.u[i + 1], v = at.v[i + 1];
      jacobian[0][i] = -u.imag();
      jacobian[1][i] = u.real();
      jacobian[2][i] = -v.imag();
      jacobian[3][i] = v.real();
    }
    const auto change = solve(jacobian, {-at.f.real(), -at.f.imag(), -at.g.real(), -at.g.imag()});
    double square = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      square += change[i] * change[i];
      turns[i + 2] *= direction(change[i]);
    }
    if (!std::isfinite(square)) return std::nullopt;
    if (std::sqrt(square) < tolerance::closed_to_rounding) break;
  }
  return error <= tolerance::closed ? std::optional(turns) : std::nullopt;
}

}  // namespace linkwright
