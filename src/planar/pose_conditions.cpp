#include "linkwright/planar/pose_conditions.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "algebra/binary_form.hpp"
#include "algebra/dense.hpp"
#include "linkwright/core/precondition.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

// 1 − e^{iφ} through the half angle: exact for small turns.
Point one_minus_direction(double phi) { return Point{0, -2 * std::sin(phi / 2)} * direction(phi / 2); }

// The displacement from position 1 and its derivatives: Z(t) = a(t) + r(t) z, q = 1 − r; index = order of derivative.
struct PlanarDisplacement {
  std::vector<Point> a, r, q;
};

PlanarDisplacement displacement(const Pose& from, const PrescribedPose& to) {
  const std::size_t orders = to.derivatives.size() + 1;
  require(orders <= binomial.size(), "a pose has at most four derivatives");
  PlanarDisplacement d;
  const double phi = to.pose.angle - from.angle;
  d.a.push_back(to.pose.origin - from.origin);
  d.r.push_back(direction(phi));
  d.q.push_back(one_minus_direction(phi));
  // r' = iθ'r, differentiated by the product rule.
  for (std::size_t m = 0; m + 1 < orders; ++m) {
    Point sum = 0;
    for (std::size_t k = 0; k <= m; ++k) sum += binomial[m][k] * to.derivatives[k].angle * d.r[m - k];
    d.r.push_back(Point{0, 1} * sum);
    d.a.push_back(to.derivatives[m].origin);
    d.q.push_back(-d.r.back());
  }
  return d;
}

// m-th derivative of the matrix M of f = (|Z(t) − C|² − |z − C|²)/2 = Zᵀ M C.
HomogeneousMatrix condition_matrix(const PlanarDisplacement& d, std::size_t m) {
  Point b = 0;
  double k = 0;
  for (std::size_t i = 0; i <= m; ++i) {
    b += binomial[m][i] * d.r[i] * std::conj(d.a[m - i]);
    k += binomial[m][i] * dot(d.a[i], d.a[m - i]) / 2;
  }
  const Point a = d.a[m], q = d.q[m];
  return {{{{k, -a.real(), -a.imag()}, {b.real(), q.real(), q.imag()}, {-b.imag(), -q.imag(), q.real()}}}};
}

double root_mean_square(const std::vector<Point>& values) {
  double sum = 0;
  for (const Point v : values) sum += std::norm(v);
  return values.empty() ? 0 : std::sqrt(sum / static_cast<double>(values.size()));
}

// Position 1 itself is no condition; its derivatives are.
std::size_t first_order(std::size_t pose) { return pose == 0 ? 1 : 0; }

struct Lengths {
  double a = 0, q = 0;
};

std::vector<PlanarDisplacement> displacements(const std::vector<PrescribedPose>& poses) {
  std::vector<PlanarDisplacement> found;
  for (const PrescribedPose& pose : poses) found.push_back(displacement(poses.front().pose, pose));
  return found;
}

Lengths typical_lengths(const std::vector<PlanarDisplacement>& moves) {
  std::vector<Point> a, q;
  for (std::size_t j = 0; j < moves.size(); ++j)
    for (std::size_t m = first_order(j); m < moves[j].a.size(); ++m) {
      a.push_back(moves[j].a[m]);
      q.push_back(moves[j].q[m]);
    }
  return {root_mean_square(a), root_mean_square(q)};
}

using MatrixRow = std::array<double, 9>;  ///< the elements of a 3 × 3 matrix

MatrixRow unit_row(const HomogeneousMatrix& matrix) {
  MatrixRow row;
  double square = 0;
  for (std::size_t i = 0; i < 9; ++i) {
    const Homogeneous& r = matrix.row[i / 3];
    row[i] = std::array{r.w, r.x, r.y}[i % 3];
    square += row[i] * row[i];
  }
  if (square > 0)
    for (double& element : row) element /= std::sqrt(square);
  return row;
}

// Unit rows, so that the singular values tell how the conditions lie to each other and not how long the moves are.
// `lowest_order`: of the derivatives taken, by pose.
template <class LowestOrder>
RowSpace space_of_rows(const std::vector<PlanarDisplacement>& moves, const LowestOrder& lowest_order) {
  std::vector<MatrixRow> rows;
  for (std::size_t j = 0; j < moves.size(); ++j)
    for (std::size_t m = lowest_order(j); m < moves[j].a.size(); ++m)
      rows.push_back(unit_row(condition_matrix(moves[j], m)));
  return row_space(rows);
}

HomogeneousMatrix as_matrix(const MatrixRow& v) {
  return {{{{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7], v[8]}}}};
}

// The point c for which Σ|a − q c|² is least: the pole of all, where they share one.
Point common_pole(const std::vector<PlanarDisplacement>& moves) {
  Point sum = 0;
  double weight = 0;
  for (std::size_t j = 0; j < moves.size(); ++j)
    for (std::size_t m = first_order(j); m < moves[j].a.size(); ++m) {
      sum += std::conj(moves[j].q[m]) * moves[j].a[m];
      weight += std::norm(moves[j].q[m]);
    }
  return sum / weight;
}

// `moves` of the working frame, `condition` of their rows there.
std::optional<PoleFrame> view_from_pole(std::vector<PlanarDisplacement> moves, double condition) {
  PoleFrame view;
  view.frame.origin = common_pole(moves);
  for (std::size_t j = 0; j < moves.size(); ++j) {
    for (std::size_t m = 0; m < moves[j].a.size(); ++m) moves[j].a[m] -= moves[j].q[m] * view.frame.origin;
    view.deviation = std::max(view.deviation, std::abs(moves[j].a.front()));
  }
  const Lengths left = typical_lengths(moves);
  view.frame.scale = left.a / left.q;
  if (!(view.frame.scale > 0 && view.frame.scale < tolerance::near_common_pole)) return std::nullopt;
  for (PlanarDisplacement& move : moves)
    for (Point& a : move.a) a /= view.frame.scale;

  const RowSpace space = space_of_rows(moves, first_order);
  // Poses that merely lie close together have their poles close together, too: their condition is the inverse square of
  // that distance, and seen from there still its inverse. Worth while are two digits, and no more than the two and a
  // half that rows of well spread poses lose.
  constexpr double worth_while = 1e-2, ordinary = 300;
  const double seen = space.values.front() / space.values.back();
  if (!(seen < std::min(worth_while * condition, ordinary))) return std::nullopt;
  for (const MatrixRow& row : space.vectors) view.rows.push_back(as_matrix(row));
  return view;
}

}  // namespace

Homogeneous WorkingFrame::to_user(Homogeneous p) const {
  const Point v = scale * p.vector() + p.w * origin;
  return {p.w, v.real(), v.imag()};
}

Homogeneous WorkingFrame::to_working(Homogeneous p) const {
  const Point v = (p.vector() - p.w * origin) / scale;
  return {p.w, v.real(), v.imag()};
}

FourBar WorkingFrame::to_user(const FourBar& bars) const {
  return {to_user(bars.input_fixed), to_user(bars.input_moving), to_user(bars.output_fixed),
          to_user(bars.output_moving)};
}

Dyad WorkingFrame::to_user(const Dyad& dyad) const {
  return {to_user(dyad.center), to_user(dyad.circle), dyad.coordinate};
}

std::optional<Point> WorkingFrame::finite_user_point(Homogeneous user) const {
  const auto point = finite_point(to_working(user));
  return point ? std::optional(to_user(*point)) : std::nullopt;
}

std::vector<PrescribedPose> WorkingFrame::to_working(const std::vector<PrescribedPose>& poses) const {
  std::vector<PrescribedPose> result = poses;
  for (PrescribedPose& pose : result) {
    pose.pose.origin = to_working(pose.pose.origin);
    for (PoseDerivative& derivative : pose.derivatives) derivative.origin /= scale;
  }
  return result;
}

double PoseConditions::condition() const {
  return singular_values.empty() ? 1 : singular_values.front() / singular_values.back();
}

namespace {

bool only_translate(const Lengths& typical) { return typical.q < tolerance::pure_translation; }

double scale_of(const Lengths& typical) {
  const double scale = only_translate(typical) ? typical.a : typical.a / typical.q;
  return scale > 0 ? scale : 1;
}

}  // namespace

double characteristic_length(const std::vector<PrescribedPose>& poses) {
  return scale_of(typical_lengths(displacements(poses)));
}

PoseConditions pose_conditions(const std::vector<PrescribedPose>& poses) {
  require(position_count(poses) >= 2, "conditions are those of two positions or more");
  PoseConditions conditions;
  const Lengths typical = typical_lengths(displacements(poses));
  conditions.only_translations = only_translate(typical);
  conditions.frame = {poses.front().pose.origin, scale_of(typical)};

  const std::vector<PlanarDisplacement> moves = displacements(conditions.frame.to_working(poses));
  const RowSpace space = space_of_rows(moves, first_order);
  conditions.singular_values = space.values;
  for (std::size_t k = 0; k < space.values.size(); ++k) {
    conditions.rows.push_back(as_matrix(space.vectors[k]));
    if (space.values[k] >= tolerance::dependent_rows * space.values.front()) ++conditions.rank;
  }
  if (conditions.rows.size() == 3 && conditions.are_independent() && !conditions.only_translations)
    conditions.near_pole = view_from_pole(moves, conditions.condition());
  return conditions;
}

std::vector<HomogeneousMatrix> derivative_conditions(const std::vector<PrescribedPose>& poses,
                                                     const WorkingFrame& frame) {
  if (position_count(poses) == static_cast<int>(poses.size())) return {};
  const RowSpace space =
      space_of_rows(displacements(frame.to_working(poses)), [](std::size_t) -> std::size_t { return 1; });
  std::vector<HomogeneousMatrix> conditions;
  for (std::size_t k = 0; k < space.values.size(); ++k)
    if (space.values[k] >= tolerance::dependent_rows * space.values.front())
      conditions.push_back(as_matrix(space.vectors[k]));
  return conditions;
}

double residual_of(const Dyad& dyad, const std::vector<HomogeneousMatrix>& rows) {
  const Homogeneous circle = normalized(dyad.circle), center = normalized(dyad.center);
  double worst = 0;
  for (const HomogeneousMatrix& row : rows) worst = std::max(worst, std::abs(dot(circle, row * center)));
  return worst;
}

}  // namespace linkwright
