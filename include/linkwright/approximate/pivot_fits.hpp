#pragma once

#include <memory>
#include <optional>
#include <span>

#include "linkwright/algebra/point.hpp"
#include "linkwright/approximate/curve_fit.hpp"
#include "linkwright/core/progress.hpp"

namespace linkwright {

/// The nearest paths to a target by the place of the ground pivot of the input that leads along them: what a map of
/// places shows. By Roberts' theorem the same curve stands at each of its pivots from which it can be driven. Evidence,
/// not proof, as fit_curve(): local minima, at each place from dyads scanned there and from what was found around it.
class PivotFits {
 public:
  /// `lattice`: places that are looked at first, from which others are begun; user's frame. `known`: curves that were
  /// found already. Cancelled, some places of the lattice stay empty. `target`: as CurveTarget says, asserted.
  PivotFits(const CurveTarget& target, const CurveFitOptions& options, std::span<const Point> lattice,
            std::span<const CurveFit> known, const Progress& progress = {});
  ~PivotFits();
  PivotFits(PivotFits&&) noexcept;
  PivotFits& operator=(PivotFits&&) noexcept;

  /// The nearest path whose first realisation has the input's ground pivot there (user's frame): without defects and
  /// within the limits, or, where none is, the nearest that was found. Nothing: none was found. The same place gives
  /// the same answer; may be called from several threads.
  [[nodiscard]] std::optional<CurveFit> at(Point pivot) const;

 private:
  class Places;
  std::unique_ptr<Places> places_;
};

}  // namespace linkwright
