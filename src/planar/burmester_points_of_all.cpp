#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "linkwright/core/tolerance.hpp"
#include "linkwright/planar/burmester_points.hpp"
#include "planar/five_conditions.hpp"

namespace linkwright {
namespace {

// Digits that a task's decisions, and each of its points, may lack before the careful way is taken.
constexpr double least_margin = 1e-3;

BurmesterDyads careful(const FivePoses& poses) {
  std::vector<PrescribedPose> prescribed;
  for (const Pose& pose : poses) prescribed.push_back({pose, {}});
  const PoseConditions conditions = pose_conditions(prescribed);
  const BurmesterPoints found = burmester_points(conditions);
  BurmesterDyads result{.frame = conditions.frame};
  for (const BurmesterPoint& point : found.points) {
    const auto i = static_cast<std::size_t>(result.count++);
    result.dyads[i] = point.dyad;
    result.multiplicity[i] = point.multiplicity;
  }
  result.complex_roots = found.complex_roots;
  result.degenerate = found.degeneracy.has_value();
  return result;
}

struct FiniteDisplacements {
  std::array<Point, 4> a, r, q;  ///< user's unit
  double length = 0;             ///< characteristic length; 0 where the poses only translate, or do not move at all
};

FiniteDisplacements displacements(const FivePoses& poses) {
  FiniteDisplacements d;
  double sum_a = 0, sum_q = 0;
  for (std::size_t j = 0; j < 4; ++j) {
    const double half = (poses[j + 1].angle - poses[0].angle) / 2;
    const double s = std::sin(half), c = std::cos(half);
    d.a[j] = poses[j + 1].origin - poses[0].origin;
    d.r[j] = {c * c - s * s, 2 * s * c};
    d.q[j] = {2 * s * s, -2 * s * c};  // 1 − r without cancellation
    sum_a += std::norm(d.a[j]);
    sum_q += 4 * s * s;
  }
  constexpr double least = 4 * tolerance::pure_translation * tolerance::pure_translation;
  d.length = sum_q > least ? std::sqrt(sum_a / sum_q) : 0;
  return d;
}

ConditionRow unit_row(Point a, Point r, Point q) {
  constexpr double root_two = 1.4142135623730951;
  const double re = r.real() * a.real() + r.imag() * a.imag(), im = r.imag() * a.real() - r.real() * a.imag();
  const double square = a.real() * a.real() + a.imag() * a.imag(), k = square / 2;
  const double size = 1 / std::sqrt(2 * (q.real() * q.real() + q.imag() * q.imag()) + 2 * square + k * k);
  return {size * root_two * q.real(),
          -size * root_two * q.imag(),
          size * re,
          -size * im,
          -size * a.real(),
          -size * a.imag(),
          size * k};
}

// True where nothing called for care.
bool quickly(const FivePoses& poses, BurmesterDyads& result) {
  const FiniteDisplacements d = displacements(poses);
  if (!(d.length > 0)) return false;
  ConditionRows rows;
  for (std::size_t j = 0; j < 4; ++j) rows[j] = unit_row((1 / d.length) * d.a[j], d.r[j], d.q[j]);
  const DyadSpace space = dyad_space(rows);
  if (space.independence < least_margin) return false;
  const ConicMeeting meeting = dyads_in(space);
  if (meeting.common_component || meeting.margin < least_margin) return false;
  result.frame = {poses[0].origin, d.length};
  result.count = meeting.count;
  result.complex_roots = meeting.complex_points;
  for (std::size_t i = 0; i < static_cast<std::size_t>(meeting.count); ++i) {
    const Factors found = factors_of(space, meeting.places[i].point);
    if (found.margin < least_margin) return false;
    result.dyads[i] = found.dyad;
    result.multiplicity[i] = 1;
  }
  return true;
}

}  // namespace

void burmester_points_of_all(std::span<const FivePoses> tasks, std::span<BurmesterDyads> dyads) {
  assert(dyads.size() >= tasks.size());
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    BurmesterDyads& result = dyads[i];
    result = {};
    if (!quickly(tasks[i], result)) {
      result = careful(tasks[i]);
      continue;
    }
    const auto end = result.dyads.begin() + result.count;
    std::sort(result.dyads.begin(), end, comes_before);
    for (int k = 0; k < result.count; ++k) result.dyads[static_cast<std::size_t>(k)].coordinate = k + 0.5;
  }
}

}  // namespace linkwright
