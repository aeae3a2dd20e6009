#pragma once

#include <span>
#include <vector>

#include "linkwright/algebra/point.hpp"
#include "linkwright/algebra/vector3.hpp"

namespace linkwright {

/// The unit sphere seen from far away, as a disc of a picture (px).
class SphereView {
 public:
  /// `towards` the one who looks, unit vector; `right` lies to the right as far as it is across.
  SphereView(Point center, double radius, Vector3 towards, Vector3 right);

  [[nodiscard]] Point center() const { return center_; }
  [[nodiscard]] double radius() const { return radius_; }
  [[nodiscard]] Vector3 right() const { return right_; }
  [[nodiscard]] Vector3 up() const { return up_; }
  [[nodiscard]] Vector3 towards() const { return towards_; }

  [[nodiscard]] Point to_px(Vector3 v) const { return center_ + across(v); }
  /// px of a direction of space, y down.
  [[nodiscard]] Point across(Vector3 v) const { return radius_ * Point{dot(v, right_), -dot(v, up_)}; }
  [[nodiscard]] bool is_in_front(Vector3 v) const { return dot(v, towards_) >= 0; }

  /// A path on the sphere, cut where it passes behind it.
  struct Pieces {
    std::vector<std::vector<Point>> front, back;
  };
  [[nodiscard]] Pieces pieces(std::span<const Vector3> path) const;

 private:
  Point center_;
  double radius_;
  Vector3 towards_, right_, up_;
};

/// The shorter arc from one unit vector to another, ends included.
[[nodiscard]] std::vector<Vector3> great_arc(Vector3 from, Vector3 to);
/// Closed; `normal` a unit vector.
[[nodiscard]] std::vector<Vector3> great_circle(Vector3 normal);

}  // namespace linkwright
