#include "linkwright/infinitesimal/motion_series.hpp"

#include <algorithm>

#include "linkwright/algebra/vector3.hpp"
#include "linkwright/core/precondition.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

// A turn and its rotation e^{if}, coefficient by coefficient.
struct TurnInTheMaking {
  RealSeries<motion_order> turn;
  ComplexSeries<motion_order> rotation = ComplexSeries<motion_order>::constant(1);

  // What the k-th coefficient of the rotation owes to those before: k E_k = i Σ j f_j E_{k−j}.
  [[nodiscard]] Point known_part(std::size_t k) const {
    Point sum{};
    for (std::size_t j = 1; j < k; ++j) sum += static_cast<double>(j) * turn.c[j] * rotation.c[k - j];
    return Point{-sum.imag(), sum.real()} / static_cast<double>(k);
  }
  void add(std::size_t k, Point known, double f) {
    turn.c[k] = f;
    rotation.c[k] = known + Point{0, f};
  }
};

}  // namespace

ComplexSeries<motion_order> MotionSeries::path_of(Point point) const {
  ComplexSeries<motion_order> moved = path + (point - path.c[0]) * rotation(turn);
  moved.c[0] = point;
  return moved;
}

std::optional<MotionSeries> MotionSeries::by_turn() const {
  if (turn.c[1] == 0) return std::nullopt;
  MotionSeries same{composed(path, inverse(turn)), RealSeries<motion_order>::variable(0), order};
  for (std::size_t k = order + 1; k <= motion_order; ++k) same.path.c[k] = 0;
  return same;
}

std::optional<LoopSeries> loop_series(const FourBar& four_bar) {
  const double size = four_bar.lengths().perimeter();
  const std::array<Point, 3> links = {(four_bar.input_moving - four_bar.input_fixed) / size,
                                      (four_bar.output_moving - four_bar.input_moving) / size,
                                      (four_bar.output_fixed - four_bar.output_moving) / size};
  const Vector3 along_x{links[0].real(), links[1].real(), links[2].real()},
      along_y{links[0].imag(), links[1].imag(), links[2].imag()};
  const Vector3 way = cross(along_x, along_y);
  const double square = dot(way, way);
  if (!(square > tolerance::collinear_links * tolerance::collinear_links)) return std::nullopt;
  Vector3 tangent = normalized(way);
  const double leading = std::abs(tangent.x) > tolerance::collinear_links   ? tangent.x
                         : std::abs(tangent.y) > tolerance::collinear_links ? tangent.y
                                                                            : tangent.z;
  if (leading < 0) tangent = -tangent;
  std::array<TurnInTheMaking, 3> turns{};
  for (std::size_t j = 0; j < 3; ++j) turns[j].add(1, {}, tangent[j]);
  for (std::size_t k = 2; k <= motion_order; ++k) {
    std::array<Point, 3> known;
    Point sum{};
    for (std::size_t j = 0; j < 3; ++j) sum += links[j] * (known[j] = turns[j].known_part(k));
    // i Σ zⱼ fⱼ = −sum, the shortest f.
    const Vector3 f = (-sum.imag() / square) * cross(along_y, way) + (sum.real() / square) * cross(way, along_x);
    for (std::size_t j = 0; j < 3; ++j) turns[j].add(k, known[j], f[j]);
  }
  return LoopSeries{turns[0].turn, turns[1].turn, turns[2].turn};
}

MotionSeries coupler_motion(const FourBar& four_bar, const LoopSeries& loop) {
  const Point arm = four_bar.input_moving - four_bar.input_fixed;
  ComplexSeries<motion_order> path = arm * rotation(loop.input);
  path.c[0] = four_bar.input_moving;
  return {path, loop.coupler};
}

MotionSeries prescribed_motion(const PrescribedPose& pose) {
  require(pose.derivatives.size() <= motion_order, "a motion is known to at most so many derivatives");
  MotionSeries motion;
  motion.path.c[0] = pose.pose.origin;
  motion.order = pose.derivatives.size();
  double factorial = 1;
  for (std::size_t k = 1; k <= motion.order; ++k) {
    factorial *= static_cast<double>(k);
    motion.path.c[k] = pose.derivatives[k - 1].origin / factorial;
    motion.turn.c[k] = pose.derivatives[k - 1].angle / factorial;
  }
  return motion;
}

}  // namespace linkwright
