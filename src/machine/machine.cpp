#include "linkwright/machine/machine.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/number_text.hpp"
#include "machine/plate_corners.hpp"

namespace linkwright {
namespace {

constexpr std::array narrower = {1.0, 0.8, 0.65, 0.5, 0.4, 1.0 / 3};

Point in_plane(Vector3 point) { return {point.x, point.y}; }

/// The corners that others do not enclose, counter-clockwise from the leftmost. (A. M. Andrew, Another efficient
/// algorithm for convex hulls in two dimensions, 1979.)
std::vector<Point> convex_hull(std::vector<Point> points) {
  std::sort(points.begin(), points.end(),
            [](Point a, Point b) { return std::pair(a.real(), a.imag()) < std::pair(b.real(), b.imag()); });
  std::vector<Point> hull;
  const auto add = [&](Point point, std::size_t kept) {
    while (hull.size() > kept && cross(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0) hull.pop_back();
    hull.push_back(point);
  };
  for (const Point point : points) add(point, 1);
  const std::size_t lower = hull.size();
  for (auto point = points.rbegin() + 1; point != points.rend(); ++point) add(*point, lower);
  hull.pop_back();
  return hull;
}

class Workshop {
 public:
  explicit Workshop(Machine& made)
      : linkage_(made.linkage), sizes_(made.sizes), layer_(made.layers.layer), parts_(made.parts) {
    top_ = *std::max_element(layer_.begin(), layer_.end());
  }

  void make_parts() {
    for (int body = 0; body < static_cast<int>(linkage_.bodies.size()); ++body) make_plate(body);
    for (const Hinge& hinge : linkage_.hinges) make_pin(hinge);
  }

 private:
  /// Where a layer begins: its height over the ground's lower face; about a centre a radius.
  [[nodiscard]] double low(int layer) const {
    if (!linkage_.spherical) return layer * sizes_.pitch();
    return sizes_.radius - sizes_.thickness - (top_ - layer) * sizes_.pitch();
  }
  [[nodiscard]] double high(int layer) const { return low(layer) + sizes_.thickness; }

  void make_plate(int body) {
    const int layer = layer_[static_cast<std::size_t>(body)];
    const std::vector<Vector3> corners = plate_corners(linkage_, body);
    Part& part = parts_.emplace_back();
    part.name = linkage_.bodies[static_cast<std::size_t>(body)];
    part.body = body;
    if (linkage_.spherical) {
      part.shape = ShellPlate{corners.front(),   corners.back(), sizes_.width / 2 / sizes_.radius,
                              sizes_.hole() / 2, low(layer),     high(layer)};
      return;
    }
    FlatPlate plate;
    std::vector<Point> points;
    for (const Vector3 corner : corners) points.push_back(in_plane(corner));
    plate.outline = convex_hull(points);
    for (const Point point : points)
      if (is_clear(point, plate.holes)) plate.holes.push_back(point);
    plate.radius = sizes_.width / 2;
    plate.hole_radius = sizes_.hole() / 2;
    plate.low = low(layer);
    plate.high = high(layer);
    part.shape = std::move(plate);
  }

  /// A traced point that lies in a hinge, or nearly so, has no hole of its own.
  [[nodiscard]] bool is_clear(Point point, const std::vector<Point>& holes) const {
    return std::none_of(holes.begin(), holes.end(),
                        [&](Point hole) { return std::abs(point - hole) < 1.05 * sizes_.hole(); });
  }

  void make_pin(const Hinge& hinge) {
    const auto [first, last] = pin_layers(hinge, layer_);
    Part& part = parts_.emplace_back();
    part.name = "pin_" + hinge.name;
    part.body = hinge.bodies[0];
    RoundPin pin;
    pin.radius = sizes_.pin / 2;
    if (linkage_.spherical) {
      pin.from = low(first) * hinge.point;
      // The rim of its outer end lies on the outer sphere.
      pin.to = std::sqrt(high(last) * high(last) - pin.radius * pin.radius) * hinge.point;
    } else {
      pin.from = hinge.point + Vector3{0, 0, low(first)};
      pin.to = hinge.point + Vector3{0, 0, high(last)};
    }
    part.shape = pin;
  }

  const MovingLinkage& linkage_;
  const PlateSizes& sizes_;
  const std::vector<int>& layer_;
  std::vector<Part>& parts_;
  int top_ = 0;
};

}  // namespace

Result<Machine> machine(const MovingLinkage& linkage, const WantedSizes& wanted) {
  const auto usual = plate_sizes(linkage, wanted);
  if (!usual) return usual.errors();
  Machine made{linkage, *usual, {}, {}};
  for (const double share : narrower) {
    if (share < 1 && (wanted.width > 0 || share * usual->width < 1.3 * usual->hole())) break;
    PlateSizes sizes = *usual;
    sizes.width = share * usual->width;
    PlateLayers layers = plate_layers(made.linkage, sizes);
    const bool better = made.layers.layer.empty() || layers.crossings.size() < made.layers.crossings.size();
    if (better) std::tie(made.sizes, made.layers) = std::pair(sizes, std::move(layers));
    if (made.layers.crossings.empty()) break;
  }
  Workshop(made).make_parts();
  return made;
}

std::string collision_text(const Machine& made) {
  if (made.layers.crossings.empty()) return "";
  const auto words = [&](const Crossing& crossing) {
    const auto& [linkage, sizes, layers, parts] = made;
    const std::string obstacle =
        crossing.is_pin ? "the pin " + linkage.hinges[crossing.obstacle].name : linkage.bodies[crossing.obstacle];
    const double from = degrees(crossing.from_turn), to = degrees(crossing.to_turn);
    return fmt::format("{} comes nearer than the gap to {} with the driver turned {}° to {}° from position 1",
                       linkage.bodies[static_cast<std::size_t>(crossing.body)], obstacle,
                       rounded_text(std::min(from, to), 0), rounded_text(std::max(from, to), 0));
  };
  std::string text = fmt::format("no layers of straight plates {} wide are free of collisions: ",
                                 significant_text(made.sizes.width, 3));
  for (const Crossing& crossing : made.layers.crossings)
    text += (&crossing == made.layers.crossings.data() ? "" : ", ") + words(crossing);
  return text;
}

}  // namespace linkwright
