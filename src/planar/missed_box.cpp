#include "linkwright/planar/missed_box.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <span>

#include "linkwright/algebra/line_search.hpp"

namespace linkwright {
namespace {

constexpr auto input = Side::input;

Point nearest_in(const Box& box, Point p) {
  return {std::clamp(p.real(), box.x_low, box.x_high), std::clamp(p.imag(), box.y_low, box.y_high)};
}

double distance_to(const Box& box, Point p) { return std::abs(p - nearest_in(box, p)); }

/// Between two corners of the polygon, where the curve may come closer to the box than at either.
struct Stretch {
  double from = 0, to = 0;  ///< τ
  double distance = 0;      ///< of its chord
};

/// One of the two curves of a family against a box.
class CurveBesideBox {
 public:
  /// `corners`: the family's polygon.
  CurveBesideBox(const FourBarFamily& family, std::span<const Dyad> corners, Homogeneous Dyad::*end, const Box& box)
      : family_(family), corners_(corners), end_(end), box_(box) {}

  /// The closest point; nothing where the family has none.
  [[nodiscard]] std::optional<Point> nearest() const {
    std::optional<Point> best;
    for (const Stretch& stretch : closest_stretches())
      if (const auto p = nearest_on(stretch); p && (!best || distance_to(box_, *p) < distance_to(box_, *best)))
        best = p;
    return best;
  }

 private:
  static constexpr int turns = 34;  // to a ten-millionth of the way

  [[nodiscard]] std::optional<Point> point_of(const Dyad& dyad) const {
    const auto p = finite_point(dyad.*end_);
    return p ? std::optional(family_.frame().to_user(*p)) : std::nullopt;
  }
  [[nodiscard]] std::optional<Point> at(double tau) const {
    const auto dyad = family_.dyad(input, tau);
    return dyad ? point_of(*dyad) : std::nullopt;
  }

  /// The chord leaves the curve by far less than its length: a few of the closest hold the closest point.
  [[nodiscard]] std::vector<Stretch> closest_stretches() const {
    constexpr std::size_t few = 6;
    std::vector<Stretch> stretches;
    for (std::size_t i = 1; i < corners_.size(); ++i) {
      const Dyad &a = corners_[i - 1], &b = corners_[i];
      const auto p = point_of(a), q = point_of(b);
      if (p && q && b.coordinate <= std::floor(a.coordinate) + 1)
        stretches.push_back({a.coordinate, b.coordinate, chord_distance(*p, *q)});
    }
    const auto kept = stretches.begin() + static_cast<std::ptrdiff_t>(std::min(few, stretches.size()));
    std::partial_sort(stretches.begin(), kept, stretches.end(),
                      [](const Stretch& a, const Stretch& b) { return a.distance < b.distance; });
    stretches.erase(kept, stretches.end());
    return stretches;
  }

  /// The distance from a box is convex along a line.
  [[nodiscard]] double chord_distance(Point p, Point q) const {
    const auto distance_at = [&](double share) { return distance_to(box_, p + share * (q - p)); };
    return distance_at(least_between(0, 1, turns, distance_at));
  }

  [[nodiscard]] std::optional<Point> nearest_on(const Stretch& stretch) const {
    const auto distance_at = [&](double tau) {
      const auto p = at(tau);
      return p ? distance_to(box_, *p) : Requirements::unlimited;
    };
    return at(least_between(stretch.from, stretch.to, turns, distance_at));
  }

  const FourBarFamily& family_;
  std::span<const Dyad> corners_;
  Homogeneous Dyad::*end_;
  Box box_;
};

/// "12 left of and 60 below it"
std::string way_text(Point beyond) {
  const auto along = [](double by, std::string_view back, std::string_view ahead) {
    return by == 0 ? std::string() : fmt::format("{:.3g} {}", std::abs(by), by < 0 ? back : ahead);
  };
  const std::string x = along(beyond.real(), "left of", "right of"), y = along(beyond.imag(), "below", "above");
  return fmt::format("{}{}{} it", x, x.empty() || y.empty() ? "" : " and ", y);
}

}  // namespace

std::vector<MissedBox> missed_boxes(const FourBarFamily& family, const Requirements& wanted) {
  if (!family.is_symmetric() || family.axis(input).quantity != AxisQuantity::curve_coordinate) return {};
  if (!wanted.ground_pivots_within && !wanted.moving_pivots_within) return {};
  const std::vector<Dyad> corners = family.polygon(input);
  std::vector<MissedBox> found;
  const auto look = [&](const std::optional<Box>& box, RequirementKind kind, Homogeneous Dyad::*end) {
    if (!box) return;
    const bool of_ground = kind == RequirementKind::ground_pivots_within;
    const PivotWindows window = of_ground ? PivotWindows{*box, std::nullopt} : PivotWindows{std::nullopt, *box};
    const auto arcs = family.arcs_within(input, window);
    if (!arcs || !arcs->are_all || !arcs->arcs.empty()) return;
    if (const auto nearest = CurveBesideBox(family, corners, end, *box).nearest())
      found.push_back({kind, *nearest, *nearest - nearest_in(*box, *nearest)});
  };
  look(wanted.ground_pivots_within, RequirementKind::ground_pivots_within, &Dyad::center);
  look(wanted.moving_pivots_within, RequirementKind::moving_pivots_within, &Dyad::circle);
  return found;
}

std::string missed_box_text(const MissedBox& missed) {
  return fmt::format("The {} curve does not enter {}; nearest is ({:.4g}, {:.4g}), {}.",
                     missed.box == RequirementKind::ground_pivots_within ? "centre-point" : "circle-point",
                     key(missed.box), missed.nearest.real(), missed.nearest.imag(), way_text(missed.beyond));
}

}  // namespace linkwright
