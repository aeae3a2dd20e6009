#include "machine/hull_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace linkwright {
namespace {

/// Twice the signed area of a triangle in the plane.
double side(Vector3 a, Vector3 b, Vector3 p) { return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x); }

double point_to_segment(Vector3 p, Vector3 a, Vector3 b) {
  const Vector3 along = b - a;
  const double square = dot(along, along);
  const double share = square > 0 ? std::clamp(dot(p - a, along) / square, 0.0, 1.0) : 0;
  return norm(p - (a + share * along));
}

double segment_to_segment(Vector3 a, Vector3 b, Vector3 c, Vector3 d) {
  if (side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0) return 0;
  return std::min(
      {point_to_segment(a, c, d), point_to_segment(b, c, d), point_to_segment(c, a, b), point_to_segment(d, a, b)});
}

bool in_triangle(Vector3 p, Vector3 a, Vector3 b, Vector3 c) {
  const double u = side(a, b, p), v = side(b, c, p), w = side(c, a, p);
  return (u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0);
}

bool in_hull(Vector3 p, std::span<const Vector3> hull) {
  for (std::size_t i = 0; i < hull.size(); ++i)
    for (std::size_t j = i + 1; j < hull.size(); ++j)
      for (std::size_t k = j + 1; k < hull.size(); ++k)
        if (in_triangle(p, hull[i], hull[j], hull[k])) return true;
  return false;
}

/// Calls with each pair of corners; a hull of one corner is a segment without length. Diagonals do no harm.
template <class Visit>
void each_segment(std::span<const Vector3> hull, Visit visit) {
  if (hull.size() == 1) return visit(hull[0], hull[0]);
  for (std::size_t i = 0; i < hull.size(); ++i)
    for (std::size_t k = i + 1; k < hull.size(); ++k) visit(hull[i], hull[k]);
}

double point_to_arc(Vector3 p, Vector3 a, Vector3 b) {
  const Vector3 normal = normalized(cross(a, b));
  const bool beside = dot(cross(normal, a), p) > 0 && dot(cross(b, normal), p) > 0;
  if (beside) return std::abs(std::atan2(dot(normal, p), norm(cross(normal, p))));
  return std::min(angle_between(a, p), angle_between(b, p));
}

/// An arc passes through a direction of its own great circle.
bool passes(Vector3 a, Vector3 b, Vector3 p) {
  const Vector3 normal = cross(a, b);
  return dot(cross(normal, a), p) >= 0 && dot(cross(b, normal), p) >= 0;
}

bool arcs_cross(Vector3 a, Vector3 b, Vector3 c, Vector3 d) {
  const Vector3 at = normalized(cross(cross(a, b), cross(c, d)));
  return (passes(a, b, at) && passes(c, d, at)) || (passes(a, b, -at) && passes(c, d, -at));
}

}  // namespace

double hull_distance(std::span<const Vector3> one, std::span<const Vector3> other) {
  if (in_hull(one.front(), other) || in_hull(other.front(), one)) return 0;
  double least = std::numeric_limits<double>::infinity();
  each_segment(one, [&](Vector3 a, Vector3 b) {
    each_segment(other, [&](Vector3 c, Vector3 d) { least = std::min(least, segment_to_segment(a, b, c, d)); });
  });
  return least;
}

double arc_distance(std::span<const Vector3> one, std::span<const Vector3> other) {
  const Vector3 a = one.front(), b = one.back(), c = other.front(), d = other.back();
  if (one.size() > 1 && other.size() > 1 && arcs_cross(a, b, c, d)) return 0;
  return std::min({point_to_arc(a, c, d), point_to_arc(b, c, d), point_to_arc(c, a, b), point_to_arc(d, a, b)});
}

}  // namespace linkwright
