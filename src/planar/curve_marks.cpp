#include "linkwright/planar/curve_marks.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

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
