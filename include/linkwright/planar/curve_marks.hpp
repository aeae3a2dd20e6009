#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "linkwright/planar/burmester_curve.hpp"
#include "linkwright/planar/pose_conditions.hpp"

namespace linkwright {

/// A place worth marking on the curves of a task.
struct CurveMark {
  enum class Kind : std::uint8_t {
    pole,                ///< of two poses: on the centre-point curve, and as a circle point moved back to position 1
    node,                ///< the curve meets itself
    center_at_infinity,  ///< slider: the moving pivot runs on a straight line
    circle_at_infinity,  ///< slider: a guide of the body runs through the fixed pivot
    focus,               ///< singular foci of the two curves
  };
  Kind kind = Kind::pole;
  std::array<int, 2> poses{};           ///< of a pole, from 0
  std::vector<double> tau;              ///< dyads that have it as centre point, circle point or both; none for foci
  std::optional<Point> center, circle;  ///< on the fixed curve, on the moving curve in position 1; fixed frame
};
/// "pole", "node", …
[[nodiscard]] std::string_view name(CurveMark::Kind kind);

/// Poles by pose pairs, then nodes, points at infinity by τ, foci. `polygon`: the curve's, in its own frame, along
/// which points at infinity are looked for.
[[nodiscard]] std::vector<CurveMark> curve_marks(const std::vector<PrescribedPose>& poses, const BurmesterCurve& curve,
                                                 const WorkingFrame& frame, std::span<const Dyad> polygon);

}  // namespace linkwright
