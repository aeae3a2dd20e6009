#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "linkwright/algebra/directed_line.hpp"
#include "linkwright/planar/burmester_curve.hpp"
#include "linkwright/planar/four_bar_family.hpp"

namespace linkwright {

/// The dyads of four positions whose pivot of a kind lies on a line, at most three, by their places along it; `curve`
/// of these conditions, `line` in the working frame. The curve of these pivots meets a line in one point or in three:
/// those at infinity, or with an infinite partner, are sliders, and left out. Nothing where the line is part of the
/// curve.
[[nodiscard]] std::optional<std::vector<Dyad>> dyads_on_line(const PoseConditions& conditions,
                                                             const BurmesterCurve& curve, PivotKind kind,
                                                             const DirectedLine& line);

/// Four positions: each grounded link from a family of its own, all of the curve or the few dyads whose pivot lies on
/// a line.
class CurveOnLinesFamily : public ProductFamily {
 public:
  /// Poses in the user's frame; both families in `frame`.
  CurveOnLinesFamily(const WorkingFrame& frame, std::vector<PrescribedPose> poses,
                     std::shared_ptr<const ProductFamily> inputs, std::shared_ptr<const ProductFamily> outputs);

  [[nodiscard]] std::optional<Dyad> dyad(Side side, double tau) const override { return of(side).dyad(side, tau); }
  [[nodiscard]] std::vector<double> samples(Side side, int count, Spacing spacing) const override {
    return of(side).samples(side, count, spacing);
  }
  [[nodiscard]] std::vector<Dyad> polygon(Side side) const override { return of(side).polygon(side); }
  [[nodiscard]] std::optional<AxisArcs> arcs_within(Side side, const PivotWindows& windows) const override {
    return of(side).arcs_within(side, windows);
  }

 private:
  [[nodiscard]] const ProductFamily& of(Side side) const { return side == Side::input ? *inputs_ : *outputs_; }

  std::shared_ptr<const ProductFamily> inputs_, outputs_;
};

}  // namespace linkwright
