#pragma once

#include <array>
#include <optional>
#include <vector>

#include "linkwright/infinitesimal/line_contact.hpp"
#include "linkwright/mechanism/linkage_type.hpp"
#include "linkwright/straight_line/line_shape.hpp"
#include "linkwright/straight_line/line_worth.hpp"
#include "linkwright/straight_line/straight_line_family.hpp"
#include "linkwright/straight_line/straight_path.hpp"

namespace linkwright {

/// One of the two other four-bars whose point traces the same curve (cognates()), as it lies with its point on the
/// line; its input is the side from which it transmits better.
struct StraightLineCognate {
  TracingFourBar linkage;
  LinkageType type = LinkageType::degenerate;
  StrokeReport over_usable;  ///< over the usable length that counts, traced by itself
};

/// A four-bar found whose point runs straight, fixed frame, user's unit, in the configuration in which the point is on
/// the line.
struct StraightLineSolution {
  TracingFourBar linkage;
  LinkLengths lengths;
  LinkageType type = LinkageType::degenerate;
  Defects defects;        ///< of contacts at places; none of other cases
  StraightLineTask task;  ///< whose map it is from
  MapNumbers place;       ///< there
  LineContact contact;    ///< by the referee, not by the family's name
  double deviation = 0;   ///< δ by which it is measured
  UsableLine usable, usable_strip;
  StrokeReport over_usable;            ///< over the usable length that counts
  bool asks_stroke = false;            ///< it is judged over a stroke
  std::optional<StrokeReport> stroke;  ///< over it; nothing where none is asked for, or the point does not go so far
  double residual = 0;                 ///< distance of the point from the task's line, as it lies
  /// Two; none where the point's path is a circle.
  std::vector<StraightLineCognate> cognates;
  std::optional<LineShape> shape;  ///< of a search of all cases: what it is of what is drawn there
  bool local_optimum = false;      ///< the top of its hill; otherwise a distinct linkage beside those
  /// Assembled by the triangles of its links it passes the places of its path; driven, the contacts at places.
  bool verified_by_driving = false;

  /// The usable length that counts.
  [[nodiscard]] const UsableLine& counted(LineMeasure by) const {
    return by == LineMeasure::strip ? usable_strip : usable;
  }
  /// The stretch by which it is judged: the stroke where one is asked for and reached, otherwise the usable length.
  [[nodiscard]] const StrokeReport& judged() const { return stroke ? *stroke : over_usable; }
  [[nodiscard]] LineWorth worth() const;
  /// Distances of the point from the moving pivots.
  [[nodiscard]] double point_to_input() const { return std::abs(linkage.point - linkage.bars.input_moving); }
  [[nodiscard]] double point_to_output() const { return std::abs(linkage.point - linkage.bars.output_moving); }
};

/// The linkage at a place of a map, measured exactly. Nothing where there is none, all its links lie in one line, or
/// its point rests there.
[[nodiscard]] std::optional<StraightLineSolution> make_straight_line(const StraightLineFamily& family, MapPoint place);

/// The requirements that it fails, by its exact measures; nothing of `no_defects`, which keeps it off every list.
/// `wanted` with max_length set.
[[nodiscard]] std::vector<RequirementKind> failures_of(const StraightLineSolution& found, const Requirements& wanted);

}  // namespace linkwright
