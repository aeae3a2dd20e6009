#pragma once

#include <optional>
#include <vector>

#include "linkwright/loads/loads.hpp"
#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/pose.hpp"

// What bodies carry, on one linkage as it lies in position 1.
namespace linkwright {

/// In which the points of a body are told; the ground's is the fixed frame.
struct CarriedFrame {
  Point origin{}, axis{1, 0};  ///< a unit vector
  [[nodiscard]] Point place(Point at) const { return origin + axis * at; }
};
[[nodiscard]] CarriedFrame frame_of(LoadedBody on, const FourBar& bars, const Pose& body);

/// A point, fixed frame.
[[nodiscard]] inline Point place_of(const CarriedPoint& point, const FourBar& bars, const Pose& body) {
  return frame_of(point.on, bars, body).place(point.at);
}

/// m/s²; 0 without gravity.
[[nodiscard]] Point gravity_in(const Loads& loads, const LoadCase& of);

struct CarriedMass {
  CarriedPoint at;
  double mass = 0;     ///< kg
  double inertia = 0;  ///< about the point, kg·m²
};
/// Of the body and the links, and of the extra loads of a case, in this order.
[[nodiscard]] std::vector<CarriedMass> masses_in(const Loads& loads, const LoadCase& of, const FourBar& bars);

/// What a drawing shows of loads: places in position 1, fixed frame.
struct LoadMarks {
  struct Strut {
    Point from, to;
  };
  std::vector<Strut> springs;     ///< without torsion springs
  std::optional<Strut> cylinder;  ///< that drives
  std::vector<Point> masses;      ///< centres, in whatever case
  std::optional<Point> handle;

  [[nodiscard]] std::vector<Point> points() const;
};
[[nodiscard]] LoadMarks marks_of(const Loads& loads, const FourBar& bars, const Pose& body);

}  // namespace linkwright
