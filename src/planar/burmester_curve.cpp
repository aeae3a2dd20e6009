#include "linkwright/planar/burmester_curve.hpp"

#include <algorithm>
#include <cmath>

#include "algebra/binary_form.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/precondition.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

std::array<HomogeneousMatrix, 3> first_three(const std::vector<HomogeneousMatrix>& rows) {
  require(rows.size() == 3, "a Burmester curve is that of four positions");
  return {rows[0], rows[1], rows[2]};
}

std::array<HomogeneousMatrix, 3> transposed(const std::array<HomogeneousMatrix, 3>& m) {
  return {linkwright::transposed(m[0]), linkwright::transposed(m[1]), linkwright::transposed(m[2])};
}

// Rank below three leaves more than a curve: every point.
PlaneCubic cubic_of(const PoseConditions& conditions, const std::vector<HomogeneousMatrix>& rows, bool of_centers) {
  if (conditions.rank < 3) return {};
  const auto three = first_three(rows);
  return determinant_cubic(of_centers ? transposed(three) : three);
}

const std::vector<HomogeneousMatrix>& solving_rows(const PoseConditions& conditions) {
  return conditions.near_pole ? conditions.near_pole->rows : conditions.rows;
}

std::array<Homogeneous, 3> dyad_system(const std::array<HomogeneousMatrix, 3>& conditions, Homogeneous circle) {
  return {circle * conditions[0], circle * conditions[1], circle * conditions[2]};
}

// The vector that the three rows annihilate best: the longest of the cross products of their directions.
Homogeneous null_vector(std::array<Homogeneous, 3> rows) {
  for (Homogeneous& row : rows) row = normalized(row);
  const std::array<Homogeneous, 3> products = {cross(rows[0], rows[1]), cross(rows[1], rows[2]),
                                               cross(rows[2], rows[0])};
  return normalized(*std::max_element(products.begin(), products.end(),
                                      [](Homogeneous a, Homogeneous b) { return dot(a, a) < dot(b, b); }));
}

Homogeneous without_component(Homogeneous v, Homogeneous unit) { return v - dot(v, unit) * unit; }

// One step of least length towards Zᵀ M_k C = 0 on the unit spheres. False where the three conditions do not
// determine it (a whole line of partners): the pair stays as it is.
bool newton_step(const std::array<HomogeneousMatrix, 3>& conditions, Homogeneous& circle, Homogeneous& center) {
  std::array<Homogeneous, 3> by_circle, by_center;
  std::array<double, 3> residual;
  for (std::size_t k = 0; k < 3; ++k) {
    const Homogeneous mc = conditions[k] * center, zm = circle * conditions[k];
    residual[k] = dot(circle, mc);
    by_circle[k] = without_component(mc, circle);
    by_center[k] = without_component(zm, center);
  }
  HomogeneousMatrix gram;
  const auto inner = [&](std::size_t i, std::size_t j) {
    return dot(by_circle[i], by_circle[j]) + dot(by_center[i], by_center[j]);
  };
  for (std::size_t i = 0; i < 3; ++i) gram.row[i] = {inner(i, 0), inner(i, 1), inner(i, 2)};
  const double volume = determinant(gram.row[0], gram.row[1], gram.row[2]);
  if (!(volume > tolerance::dependent_rows)) return false;
  const Homogeneous r{residual[0], residual[1], residual[2]};
  const Homogeneous weight{determinant(r, gram.row[1], gram.row[2]) / volume,
                           determinant(gram.row[0], r, gram.row[2]) / volume,
                           determinant(gram.row[0], gram.row[1], r) / volume};
  circle = normalized(circle - (weight.w * by_circle[0] + weight.x * by_circle[1] + weight.y * by_circle[2]));
  center = normalized(center - (weight.w * by_center[0] + weight.x * by_center[1] + weight.y * by_center[2]));
  return true;
}

// Length run by both unit vectors together.
double run_between(const Dyad& a, const Dyad& b) {
  return great_circle(a.circle, b.circle) + great_circle(a.center, b.center);
}

constexpr std::array<std::string_view, 5> names = {"pole", "node", "center_at_infinity", "circle_at_infinity", "focus"};

class Marker {
 public:
  Marker(const std::vector<PrescribedPose>& poses, const BurmesterCurve& curve, const WorkingFrame& frame)
      : frame_(frame), poses_(frame.to_working(poses)), curve_(curve) {}

  void add_poles() {
    for (std::size_t i = 0; i < poses_.size(); ++i)
      for (std::size_t j = i + 1; j < poses_.size(); ++j) add_pole(i, j);
  }

  void add_node() {
    if (curve_.kind() != CubicKind::nodal) return;
    const Dyad dyad = curve_.dyad(0.25);
    marks_.push_back({CurveMark::Kind::node, {}, {0.25, 0.75}, user(dyad.center), user(dyad.circle)});
  }

  void add_points_at_infinity(std::span<const Dyad> polygon) {
    for (std::size_t i = 1; i < polygon.size(); ++i) {
      if (!on_one_branch(polygon[i - 1], polygon[i])) continue;
      add_crossing(polygon[i - 1], polygon[i], &Dyad::center, CurveMark::Kind::center_at_infinity);
      add_crossing(polygon[i - 1], polygon[i], &Dyad::circle, CurveMark::Kind::circle_at_infinity);
    }
  }

  void add_foci() {
    const auto center = curve_.center_curve().focus(), circle = curve_.circle_curve().focus();
    if (center || circle) marks_.push_back({CurveMark::Kind::focus, {}, {}, user(center), user(circle)});
  }

  [[nodiscard]] std::vector<CurveMark> take() { return std::move(marks_); }

 private:
  [[nodiscard]] std::optional<Point> user(std::optional<Point> p) const {
    return p ? std::optional(frame_.to_user(*p)) : std::nullopt;
  }
  [[nodiscard]] std::optional<Point> user(Homogeneous p) const { return user(finite_point(p)); }

  [[nodiscard]] bool on_one_branch(const Dyad& a, const Dyad& b) const {
    return std::any_of(curve_.branches().begin(), curve_.branches().end(), [&](const CurveBranch& branch) {
      return a.coordinate >= branch.from && b.coordinate > a.coordinate && b.coordinate < branch.to;
    });
  }

  /// The point that is at rest between two poses; at infinity between parallel ones.
  void add_pole(std::size_t i, std::size_t j) {
    const Pose &from = poses_[i].pose, &to = poses_[j].pose;
    const Point turned = direction(to.angle - from.angle), stay = Point{1, 0} - turned;
    CurveMark mark{CurveMark::Kind::pole, {static_cast<int>(i), static_cast<int>(j)}, {}, {}, {}};
    if (std::abs(stay) >= tolerance::pure_translation) {
      const Point pole = (to.origin - turned * from.origin) / stay;
      const Point in_body = displaced(pole, from, poses_.front().pose);
      mark.center = frame_.to_user(pole);
      mark.circle = frame_.to_user(in_body);
      add_coordinate(mark, curve_.circle_of(Homogeneous::of(pole)));
      add_coordinate(mark, Homogeneous::of(in_body));
    }
    marks_.push_back(std::move(mark));
  }

  void add_coordinate(CurveMark& mark, Homogeneous circle) const {
    if (const auto tau = curve_.coordinate_of(circle)) mark.tau.push_back(*tau);
  }

  /// Between two neighbours of the polygon w changes its sign, the vectors being taken the same way round.
  void add_crossing(Dyad low, Dyad high, Homogeneous Dyad::*point, CurveMark::Kind kind) {
    const Homogeneous reference = low.*point;
    const auto w_of = [&](const Dyad& dyad) {
      const Homogeneous p = dyad.*point;
      return dot(p, reference) < 0 ? -p.w : p.w;
    };
    const bool nowhere_finite = is_at_infinity(low.*point) && is_at_infinity(high.*point);
    if (nowhere_finite || (w_of(low) < 0) == (w_of(high) < 0)) return;
    constexpr int max_halvings = 60;
    for (int i = 0; i < max_halvings; ++i) {
      const double middle = (low.coordinate + high.coordinate) / 2;
      if (!(middle > low.coordinate && middle < high.coordinate)) break;
      const Dyad dyad = curve_.dyad(middle);
      ((w_of(dyad) < 0) == (w_of(low) < 0) ? low : high) = dyad;
    }
    const Dyad& nearer = std::abs((low.*point).w) < std::abs((high.*point).w) ? low : high;
    marks_.push_back({kind, {}, {nearer.coordinate}, user(nearer.center), user(nearer.circle)});
  }

  WorkingFrame frame_;
  std::vector<PrescribedPose> poses_;
  const BurmesterCurve& curve_;
  std::vector<CurveMark> marks_;
};

}  // namespace

BurmesterCurve::SolvingFrame::SolvingFrame(const PoseConditions& asked, const std::vector<HomogeneousMatrix>& rows)
    : conditions(first_three(rows)),
      circle_cubic(cubic_of(asked, rows, false)),
      center_cubic(cubic_of(asked, rows, true)),
      circle_curve(circle_cubic),
      center_curve(center_cubic) {}

BurmesterCurve::BurmesterCurve(const PoseConditions& conditions)
    : pole_frame_(conditions.near_pole ? std::optional(conditions.near_pole->frame) : std::nullopt),
      solving_(conditions, solving_rows(conditions)),
      circle_curve_(cubic_of(conditions, conditions.rows, false)),
      center_curve_(cubic_of(conditions, conditions.rows, true)),
      branches_(solving_.circle_curve.branches()) {
  if (kind() != CubicKind::every_point) find_partner_lines();
}

void BurmesterCurve::find_partner_lines() {
  const double first = coordinate_length();
  for (const Homogeneous circle : solving_.circle_curve.double_points()) {
    const auto rows = dyad_system(solving_.conditions, circle);
    const Homogeneous longest =
        *std::max_element(rows.begin(), rows.end(), [](Homogeneous a, Homogeneous b) { return dot(a, a) < dot(b, b); });
    double independent = 0;
    for (const Homogeneous row : rows) independent = std::max(independent, norm(cross(row, normalized(longest))));
    if (independent > tolerance::line_of_partners) continue;
    const Homogeneous line = normalized(longest);
    const double direction = std::hypot(line.x, line.y);
    const Homogeneous from = direction > tolerance::line_of_partners
                                 ? Homogeneous{0, -line.y / direction, line.x / direction}
                                 : Homogeneous{0, 1, 0};
    partner_lines_.push_back({circle, from, normalized(cross(line, from))});
    const double begin = first + static_cast<double>(partner_lines_.size()) - 1;
    branches_.push_back({"center_line", begin, begin + 1});
  }
}

Homogeneous BurmesterCurve::to_solving_frame(Homogeneous working) const {
  return pole_frame_ ? normalized(pole_frame_->to_working(working)) : working;
}

Homogeneous BurmesterCurve::to_working(Homogeneous seen) const {
  return pole_frame_ ? normalized(pole_frame_->to_user(seen)) : seen;
}

Homogeneous BurmesterCurve::center_of(Homogeneous circle) const {
  return to_working(null_vector(dyad_system(solving_.conditions, to_solving_frame(circle))));
}

Homogeneous BurmesterCurve::circle_of(Homogeneous center) const {
  return to_working(null_vector(dyad_system(transposed(solving_.conditions), to_solving_frame(center))));
}

// Two points of a line, orthonormal vectors in the solving frame.
std::array<Homogeneous, 2> BurmesterCurve::solving_points_of(Homogeneous line) const {
  const Homogeneous l = normalized(line);
  const Homogeneous aside = std::abs(l.w) < 0.5 ? Homogeneous{1, 0, 0} : Homogeneous{0, 1, 0};
  const Homogeneous p = cross(l, aside);
  const Homogeneous first = to_solving_frame(normalized(p)), other = to_solving_frame(normalized(cross(l, p)));
  return {first, normalized(without_component(other, first))};
}

namespace {

// Points of a cubic on the line through two orthonormal vectors; none where it holds the whole line.
std::vector<Homogeneous> points_on(const PlaneCubic& cubic, const std::array<Homogeneous, 2>& line) {
  const auto [p, q] = line;
  const double at_p = cubic(p), at_q = cubic(q), at_sum = cubic(p + q), at_difference = cubic(p - q);
  const std::array<double, 4> form = {at_p, (at_sum - at_difference) / 2 - at_q, (at_sum + at_difference) / 2 - at_p,
                                      at_q};
  double largest = 0;
  for (const double a : form) largest = std::max(largest, std::abs(a));
  std::vector<Homogeneous> points;
  if (!(largest > tolerance::vanishing_coefficient * cubic.largest_coefficient())) return points;
  for (const FormRoot& root : real_roots(form, tolerance::touching_line))
    points.push_back(std::cos(root.angle) * p + std::sin(root.angle) * q);
  return points;
}

}  // namespace

std::vector<double> BurmesterCurve::coordinates_of_circles_on(Homogeneous line) const {
  std::vector<double> coordinates;
  if (branches_.empty()) return coordinates;
  for (const Homogeneous circle : points_on(solving_.circle_cubic, solving_points_of(line)))
    if (const auto tau = solving_.circle_curve.coordinate_of(circle)) coordinates.push_back(*tau);
  return coordinates;
}

std::vector<double> BurmesterCurve::coordinates_of_centers_on(Homogeneous line) const {
  std::vector<double> coordinates;
  if (branches_.empty()) return coordinates;
  const std::array<Homogeneous, 2> points = solving_points_of(line);
  for (const Homogeneous center : points_on(solving_.center_cubic, points)) {
    const Homogeneous circle = null_vector(dyad_system(transposed(solving_.conditions), center));
    if (const auto tau = solving_.circle_curve.coordinate_of(circle)) coordinates.push_back(*tau);
  }
  const Homogeneous seen_line = cross(points[0], points[1]);
  const double own_length = coordinate_length() - static_cast<double>(partner_lines_.size());
  for (std::size_t i = 0; i < partner_lines_.size(); ++i) {
    const double t = std::atan2(-dot(seen_line, partner_lines_[i].from), dot(seen_line, partner_lines_[i].to)) / pi;
    coordinates.push_back(own_length + static_cast<double>(i) + wrap_period(t, 1));
  }
  return coordinates;
}

std::optional<double> BurmesterCurve::coordinate_of(Homogeneous circle) const {
  return solving_.circle_curve.coordinate_of(to_solving_frame(circle));
}

Dyad BurmesterCurve::dyad(double tau) const {
  require(coordinate_length() > 0, "the curve has coordinates");
  // The end itself is a coordinate: that of an isolated point.
  const bool inside = tau >= 0 && tau <= coordinate_length();
  const double on_curve = inside ? tau : wrap_period(tau, coordinate_length());
  const double own_length = coordinate_length() - static_cast<double>(partner_lines_.size());
  if (on_curve >= own_length && !partner_lines_.empty()) {
    const auto which = std::min(static_cast<std::size_t>(on_curve - own_length), partner_lines_.size() - 1);
    const PartnerLine& line = partner_lines_[which];
    const double t = pi * (on_curve - own_length - static_cast<double>(which));
    return {to_working(std::cos(t) * line.from + std::sin(t) * line.to), to_working(line.circle), on_curve};
  }
  Homogeneous circle = solving_.circle_curve.point(on_curve);
  Homogeneous center = null_vector(dyad_system(solving_.conditions, circle));
  for (int step = 0; step < 2; ++step)
    if (!newton_step(solving_.conditions, circle, center)) break;
  return {to_working(center), to_working(circle), on_curve};
}

double BurmesterCurve::residual(const Dyad& dyad) const {
  const Homogeneous circle = normalized(to_solving_frame(dyad.circle)),
                    center = normalized(to_solving_frame(dyad.center));
  double worst = 0;
  for (const HomogeneousMatrix& m : solving_.conditions) worst = std::max(worst, std::abs(dot(circle, m * center)));
  return worst;
}

std::vector<double> BurmesterCurve::samples(int count, Spacing spacing) const {
  require(count > 0, "there is a sample");
  if (coordinate_length() == 0) return {};
  if (spacing == Spacing::arc_length) return evenly_by_length(count);
  std::vector<double> coordinates;
  for (int i = 0; i < count; ++i) coordinates.push_back(coordinate_length() * (i + 0.5) / count);
  return coordinates;
}

/// Where one of the two points passes infinity: excursions of the curve lead there, however short in τ.
std::vector<Dyad> BurmesterCurve::dyads_at_infinity() const {
  const CircularCubic &circles = solving_.circle_curve, &centers = solving_.center_curve;
  std::vector<Dyad> found;
  if (const auto asymptote = circles.asymptote())
    found.push_back(dyad(*circles.coordinate_of(Homogeneous::at_infinity((*asymptote)[1]))));
  if (const auto asymptote = centers.asymptote(); asymptote && circles.kappa()) {
    const auto rows = dyad_system(transposed(solving_.conditions), Homogeneous::at_infinity((*asymptote)[1]));
    found.push_back(dyad(*circles.coordinate_of(null_vector(rows))));
  }
  return found;
}

/// Calls `visit(dyad, length run since the one before)` along all branches, sides being halved until they are short
/// enough and pass over none of the dyads at infinity.
template <class Visit>
void BurmesterCurve::walk(int first_sides, double longest_side, const Visit& visit) const {
  constexpr int deepest = 40;
  const std::vector<Dyad> knots = dyads_at_infinity();
  const auto passed_over = [&](const Dyad& from, const Dyad& to) {
    return std::find_if(knots.begin(), knots.end(), [&](const Dyad& knot) {
      return knot.coordinate > from.coordinate && knot.coordinate < to.coordinate &&
             run_between(from, knot) > longest_side;
    });
  };
  for (const CurveBranch& branch : branches_) {
    if (branch.from == branch.to) continue;
    // The end of a branch is its beginning: stop just short of it, or the next branch's beginning is met.
    const double step = (branch.to - branch.from) / first_sides, last = std::nextafter(branch.to, branch.from);
    Dyad at = dyad(branch.from);
    visit(at, 0.0);
    for (int side = 1; side <= first_sides; ++side) {
      std::vector<Dyad> ahead = {dyad(side == first_sides ? last : branch.from + side * step)};
      while (!ahead.empty()) {
        const double length = run_between(at, ahead.back()), width = ahead.back().coordinate - at.coordinate;
        if (length > longest_side && width > step * std::ldexp(1.0, -deepest)) {
          ahead.push_back(dyad(at.coordinate + width / 2));
          continue;
        }
        if (const auto knot = passed_over(at, ahead.back()); knot != knots.end()) {
          ahead.push_back(*knot);
          continue;
        }
        at = ahead.back();
        ahead.pop_back();
        visit(at, length);
      }
    }
  }
}

BurmesterCurve::ArcLengthTable BurmesterCurve::arc_length_table(double longest_side) const {
  constexpr int first_sides = 256;
  ArcLengthTable run;
  double total = 0;
  walk(first_sides, longest_side, [&](const Dyad& dyad, double length) {
    total += length;
    run.tau.push_back(dyad.coordinate);
    run.length.push_back(total);
  });
  return run;
}

std::vector<Dyad> BurmesterCurve::polygon(double longest_side) const {
  constexpr int first_sides = 64;
  std::vector<Dyad> corners;
  walk(first_sides, longest_side, [&](const Dyad& dyad, double /*length*/) { corners.push_back(dyad); });
  return corners;
}

std::vector<double> BurmesterCurve::evenly_by_length(int count) const {
  const auto [tau, run] = this->arc_length_table();
  std::vector<double> coordinates;
  std::size_t side = 1;
  for (int i = 0; i < count; ++i) {
    const double wanted = run.back() * (i + 0.5) / count;
    while (side + 1 < run.size() && run[side] < wanted) ++side;
    const double width = run[side] - run[side - 1];
    const double share = width > 0 ? (wanted - run[side - 1]) / width : 0.5;
    coordinates.push_back(tau[side - 1] + share * (tau[side] - tau[side - 1]));
  }
  return coordinates;
}

std::string_view name(CurveMark::Kind kind) { return names[static_cast<std::size_t>(kind)]; }

std::vector<CurveMark> curve_marks(const std::vector<PrescribedPose>& poses, const BurmesterCurve& curve,
                                   const WorkingFrame& frame, std::span<const Dyad> polygon) {
  if (curve.coordinate_length() == 0) return {};
  Marker marker(poses, curve, frame);
  marker.add_poles();
  marker.add_node();
  marker.add_points_at_infinity(polygon);
  marker.add_foci();
  return marker.take();
}

}  // namespace linkwright
