#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "linkwright/core/progress.hpp"
#include "linkwright/core/simd.hpp"
#include "linkwright/planar/fitted_path.hpp"
#include "nearest_path.hpp"
#include "path_family.hpp"

namespace linkwright {

/// The four-bars whose coupler point passes near the points of a task: rows of their map are the curves that were
/// found, columns the three four-bars that trace each (Roberts), at
/// angles of the crank the two whose cranks turn alike. Their positions are where the point is nearest to some
/// of the points, five at most; how near it comes to all of them, fitted_at() says.
class FittedPathFamily : public PathFamily {
 public:
  /// `fits`: of the target, some; `measure`: what was to be least of them.
  FittedPathFamily(NearestTarget near, std::vector<CurveFit> fits, FitMeasure measure);
  /// Axes as LinkageFamily has them.
  FittedPathFamily(NearestTarget near, FitMeasure measure, MapAxis input, MapAxis output);

  [[nodiscard]] const LinkageClass& linkages() const override { return near_path_linkages; }
  /// With the error: root mean square of the distances, or the largest of them where that is to be least.
  [[nodiscard]] std::span<const Measure> measures() const override;
  [[nodiscard]] bool is_timed() const override { return false; }

  [[nodiscard]] std::optional<DyadPair> dyad_pair(MapPoint place) const override;
  /// `bars` are those at the place.
  [[nodiscard]] std::vector<PrescribedPose> user_poses(MapPoint place, const FourBar& bars) const override;
  [[nodiscard]] std::vector<PrescribedPose> working_poses(MapPoint place, const FourBar& bars) const override;
  [[nodiscard]] std::vector<PrescribedPose> crank_poses(MapPoint place, const FourBar& bars) const override;
  [[nodiscard]] std::optional<double> rate_residual(MapPoint /*place*/) const override { return std::nullopt; }
  [[nodiscard]] std::vector<Dyad> polygon(Side /*side*/) const override { return {}; }
  /// Of a closed path only an input that turns fully is without defects.
  [[nodiscard]] CellAt cells(bool respect_direction) const override;

  /// The four-bars that trace the curve at the place, in their order.
  [[nodiscard]] std::vector<Cell> all_at(MapPoint place, bool respect_direction) const override;
  [[nodiscard]] std::optional<FittedPath> fitted_at(MapPoint place) const override;
  /// The three four-bars of a curve are one design.
  [[nodiscard]] double distance(const Pivots& one, const Pivots& other) const override;

 protected:
  struct Traced {
    std::shared_ptr<const CurveFit> fit;
    std::size_t realisation;

    [[nodiscard]] const TracingFourBar& linkage() const { return fit->realisations[realisation]; }
  };
  /// Nothing where there is no linkage; may be called from several threads.
  [[nodiscard]] virtual std::optional<Traced> traced_at(MapPoint place) const;

 private:
  [[nodiscard]] std::optional<std::size_t> curve_of(const Pivots& pivots) const;
  void fill(RegionMap& map, std::span<const double> input, std::span<const double> output, bool respect_direction,
            const RegionOptions& options, const Progress& progress) const override;

  NearestTarget near_;
  std::vector<std::shared_ptr<const CurveFit>> fits_;
  FitMeasure measure_;
  std::vector<std::size_t> positions_;  ///< states that are positions, the first first
};

/// As task_family(), of a task that is_approximate(), without mistakes; requirements with default lengths filled in.
[[nodiscard]] TaskFamily family_of_nearest(const PathTask& task, const Requirements& requirements,
                                           const FitWishes& wishes, const RegionOptions& options,
                                           const Progress& progress = {});
/// As search_fits(), of the same.
[[nodiscard]] FitSearch search_nearest(const PathTask& task, const Requirements& requirements, const FitWishes& wishes,
                                       const RegionOptions& options, const Progress& progress);

}  // namespace linkwright
