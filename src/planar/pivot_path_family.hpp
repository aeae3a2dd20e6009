#pragma once

#include <array>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "fitted_path_family.hpp"
#include "given_pivot_family.hpp"
#include "linkwright/approximate/pivot_fits.hpp"

namespace linkwright {

/// The four-bars whose coupler point passes near the points of a task, by the place of the input's ground pivot: at
/// each the nearest path from there that was found. Rows of the map run along y, columns along x, as of
/// PivotPlaceFamily.
class PivotPathFamily : public FittedPathFamily {
 public:
  /// `known`: curves of the target that were found already; `fit`: as they were.
  PivotPathFamily(const NearestTarget& near, const CurveFitOptions& fit, std::span<const CurveFit> known,
                  const Progress& progress);

  [[nodiscard]] double axis_value(Side side, double tau) const override;
  /// Of the known curves, at the ground pivot of the input of each linkage.
  [[nodiscard]] std::vector<MapPoint> known_places() const override { return known_; }
  [[nodiscard]] bool cells_take_long() const override { return true; }
  /// As many as most_samples_over_pivots.
  [[nodiscard]] std::vector<double> samples(Side side, int count, Spacing spacing) const override;

 private:
  [[nodiscard]] std::optional<Traced> traced_at(MapPoint place) const override;
  [[nodiscard]] Point pivot_at(MapPoint place) const;

  std::array<PivotRange, 2> ranges_;  ///< of x and y, user's frame
  std::unique_ptr<const PivotFits> fits_;
  std::vector<MapPoint> known_;

  // A place is asked for several times in turn.
  struct Recent {
    std::mutex using_it;
    std::map<std::pair<double, double>, std::shared_ptr<const CurveFit>> fits;
    std::vector<std::pair<double, double>> order;  ///< a ring
    std::size_t next = 0;
  };
  mutable Recent recent_;
};

}  // namespace linkwright
