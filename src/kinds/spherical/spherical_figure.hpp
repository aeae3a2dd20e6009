#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "drawing/palette.hpp"
#include "drawing/region_figure.hpp"
#include "drawing/svg_canvas.hpp"
#include "linkwright/algebra/point.hpp"
#include "linkwright/algebra/vector3.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/files/spherical_file.hpp"
#include "linkwright/synthesis/answer.hpp"
#include "spherical_kind.hpp"

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

/// What a drawing shows of a spherical task and its linkage, fixed frame.
struct SphericalScene {
  using Paths = std::vector<std::vector<Vector3>>;

  std::optional<SphericalFourBar> bars;             ///< in position 1
  std::vector<PrescribedOrientation> orientations;  ///< drawn with their numbers
  Vector3 marker{0, 0, 1};                          ///< point of the body in position 1 that carries the numbers
  Paths moving_cone, fixed_cone;                    ///< branches of both curves; of a few dyads none
  std::vector<SphericalDyad> dyads;                 ///< those few
  std::vector<Vector3> path;                        ///< of the marker, over all that the linkage can do
  std::vector<Vector3> dead_points;                 ///< the marker at the ends of that path
};
/// Of the best linkage, or of the task alone.
[[nodiscard]] SphericalScene scene_of(const SphericalAnswer& answer,
                                      const std::vector<PrescribedOrientation>& orientations);
[[nodiscard]] SphericalScene scene_of(const StoredSphericalFourBar& linkage);

/// Along the mean of the axes, with the fixed axes side by side.
[[nodiscard]] SphereView front_view(const SphericalScene& scene, Point center, double radius);
/// The same from 60° above: what was in front lies low.
[[nodiscard]] SphereView view_from_above(const SphereView& front, Point center, double radius);

/// Sphere, curves, path, other positions, links, orientations, axes with their names, from back to front; hidden lines
/// are thin.
void draw_scene(SvgCanvas& svg, const SphereView& view, const SphericalScene& scene);

/// What a view is, below it.
inline constexpr std::string_view front_view_words = "along the mean of the axes",
                                  view_from_above_words = "the same from 60° above";
void draw_caption(SvgCanvas& svg, const SphereView& view, std::string_view words);

/// Both views of a linkage side by side with their captions and the fixed frame.
void draw_views(SvgCanvas& svg, const SphericalScene& scene, Point front_center, Point above_center, double radius);

/// The axes of the fixed frame as they lie in a view.
void draw_fixed_frame(SvgCanvas& svg, const SphereView& view, Point origin);

/// The key of the dead points, as wide before its words as draw_line_key().
void draw_dead_point_key(SvgCanvas& svg, Point left);
/// Attributes of the lines, for keys.
[[nodiscard]] std::string moving_cone_stroke();
[[nodiscard]] std::string fixed_cone_stroke();
[[nodiscard]] std::string marker_path_stroke();

/// Of an answer with a map.
template <class KindAnswer>
[[nodiscard]] DrawnRegion region_of(const KindAnswer& answer, std::string_view length_unit) {
  return drawn_region(answer, {axis_label(answer, Side::input, length_unit), palette::input, {}},
                      {axis_label(answer, Side::output, length_unit), palette::output, {}});
}

}  // namespace linkwright
