#include "linkwright/mechanism/body_rates.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

constexpr std::size_t to_a_body = 3;  // numbers: in a plane drift x, drift y and turning; about a centre the turning

/// Rows of coefficients with a right side each.
using Rows = std::vector<std::vector<double>>;

/// Gauss with pivots; nothing where the rows are dependent.
std::optional<std::vector<double>> solved(Rows rows) {
  const std::size_t n = rows.size();
  for (std::size_t k = 0; k < n; ++k) {
    const auto pivot = std::max_element(rows.begin() + static_cast<std::ptrdiff_t>(k), rows.end(),
                                        [k](const auto& a, const auto& b) { return std::abs(a[k]) < std::abs(b[k]); });
    if (!(std::abs((*pivot)[k]) > tolerance::dead_point_sine)) return std::nullopt;
    std::swap(rows[k], *pivot);
    for (std::size_t row = k + 1; row < n; ++row) {
      const double factor = rows[row][k] / rows[k][k];
      for (std::size_t column = k; column <= n; ++column) rows[row][column] -= factor * rows[k][column];
    }
  }
  std::vector<double> found(n);
  for (std::size_t k = n; k-- > 0;) {
    double rest = rows[k][n];
    for (std::size_t column = k + 1; column < n; ++column) rest -= rows[k][column] * found[column];
    found[k] = rest / rows[k][k];
  }
  return found;
}

/// The linkage with lengths of order one, and the driver's hinge at the origin: what its bodies do is linear there.
class Equations {
 public:
  Equations(const HingedBodies& linkage, std::span<const Vector3> at)
      : linkage_(linkage), unknowns_(to_a_body * static_cast<std::size_t>(linkage.bodies - 2)) {
    if (!linkage.spherical) {
      origin_ = at[driver_hinge()];
      for (const Vector3 point : at) size_ = std::max(size_, norm(point - origin_));
    }
    if (!(size_ > 0)) size_ = 1;
    for (const Vector3 point : at) at_.push_back((point - origin_) / size_);
  }

  [[nodiscard]] std::optional<std::vector<HingedBodyRates>> rates() const {
    std::vector<HingedBodyRates> found(static_cast<std::size_t>(linkage_.bodies));
    found[1].turning = linkage_.spherical ? at_[driver_hinge()] : Vector3{0, 0, 1};
    if (!put_unknowns(found, &HingedBodyRates::drift, &HingedBodyRates::turning,
                      [&](const HingedBodyRates& body, Vector3 point) { return body.velocity(point); }))
      return std::nullopt;
    if (!put_unknowns(found, &HingedBodyRates::drift_up, &HingedBodyRates::turning_up,
                      [&](const HingedBodyRates& body, Vector3 point) { return body.acceleration(point); }))
      return std::nullopt;
    for (HingedBodyRates& body : found) to_user(body);
    return found;
  }

 private:
  [[nodiscard]] std::size_t driver_hinge() const {
    const auto joins = [](const std::array<int, 2>& bodies) { return bodies[0] + bodies[1] == 1; };
    return static_cast<std::size_t>(std::find_if(linkage_.hinges.begin(), linkage_.hinges.end(), joins) -
                                    linkage_.hinges.begin());
  }
  /// The two directions in which a hinge can move.
  [[nodiscard]] std::array<Vector3, 2> directions(Vector3 hinge) const {
    if (!linkage_.spherical) return {Vector3{1, 0, 0}, Vector3{0, 1, 0}};
    const Vector3 aside = std::abs(hinge.x) < 0.6 ? Vector3{1, 0, 0} : Vector3{0, 1, 0};
    const Vector3 first = normalized(cross(hinge, aside));
    return {first, cross(hinge, first)};
  }
  /// How fast a hinge moves along a direction by each of a body's numbers.
  [[nodiscard]] std::array<double, to_a_body> effect(Vector3 hinge, Vector3 along) const {
    const Vector3 by_turning = cross(hinge, along);
    return linkage_.spherical ? std::array{by_turning.x, by_turning.y, by_turning.z}
                              : std::array{along.x, along.y, by_turning.z};
  }
  /// What is unknown of `found` is 0 yet: `motion_of` says what all else does to a hinge, and both bodies do the same.
  template <class MotionOf>
  [[nodiscard]] bool put_unknowns(std::vector<HingedBodyRates>& found, Vector3 HingedBodyRates::*drift,
                                  Vector3 HingedBodyRates::*turning, const MotionOf& motion_of) const {
    Rows rows;
    for (std::size_t hinge = 0; hinge < at_.size(); ++hinge) {
      if (hinge == driver_hinge()) continue;
      const auto [a, b] = linkage_.hinges[hinge];
      const Vector3 apart = motion_of(found[static_cast<std::size_t>(b)], at_[hinge]) -
                            motion_of(found[static_cast<std::size_t>(a)], at_[hinge]);
      for (const Vector3 along : directions(at_[hinge])) {
        std::vector<double>& row = rows.emplace_back(unknowns_ + 1);
        const auto by_number = effect(at_[hinge], along);
        for (std::size_t k = 0; k < to_a_body; ++k) {
          if (a > 1) row[to_a_body * static_cast<std::size_t>(a - 2) + k] += by_number[k];
          if (b > 1) row[to_a_body * static_cast<std::size_t>(b - 2) + k] -= by_number[k];
        }
        row.back() = dot(apart, along);
      }
    }
    const auto numbers = rows.size() == unknowns_ ? solved(std::move(rows)) : std::nullopt;
    for (std::size_t body = 2; numbers && body < found.size(); ++body) {
      const double* of = &(*numbers)[to_a_body * (body - 2)];
      found[body].*turning = linkage_.spherical ? Vector3{of[0], of[1], of[2]} : Vector3{0, 0, of[2]};
      if (!linkage_.spherical) found[body].*drift = {of[0], of[1], 0};
    }
    return numbers.has_value();
  }
  /// About the user's origin, in the user's unit.
  void to_user(HingedBodyRates& body) const {
    const Vector3 to = -origin_ / size_;  // the user's origin
    const Vector3 drift = body.velocity(to), up = body.acceleration(to) - cross(body.turning, drift);
    body.drift = size_ * drift;
    body.drift_up = size_ * up;
  }

  const HingedBodies& linkage_;
  std::size_t unknowns_;
  Vector3 origin_{};
  double size_ = 0;
  std::vector<Vector3> at_;
};

}  // namespace

std::optional<std::vector<HingedBodyRates>> body_rates(const HingedBodies& linkage, std::span<const Vector3> at) {
  return Equations(linkage, at).rates();
}

}  // namespace linkwright
