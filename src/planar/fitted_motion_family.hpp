#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "linkwright/approximate/fit_wishes.hpp"
#include "linkwright/planar/four_bar_family.hpp"
#include "linkwright/planar/near_poses.hpp"
#include "linkwright/planar/task_family.hpp"
#include "linkwright/region/requirements.hpp"

namespace linkwright {

/// The four-bars that were found to carry a body past near poses: rows of their map are the linkages, columns there is
/// but one. Their positions are where the body is nearest to some of the poses, five at most, the first first and exact
/// ones among them; position 1 is where it is nearest to the first pose.
class FittedMotionFamily : public FourBarFamily {
 public:
  /// `fits`: of the target, some.
  FittedMotionFamily(std::shared_ptr<const NearPoses> near, std::vector<PoseFit> fits);

  [[nodiscard]] const LinkageClass& linkages() const override { return near_motion_linkages; }

  [[nodiscard]] std::optional<DyadPair> dyad_pair(MapPoint place) const override;
  /// `bars` are those at the place.
  [[nodiscard]] std::vector<PrescribedPose> user_poses(MapPoint place, const FourBar& bars) const override;
  [[nodiscard]] std::vector<PrescribedPose> working_poses(MapPoint place, const FourBar& bars) const override;
  [[nodiscard]] std::vector<Dyad> polygon(Side /*side*/) const override { return {}; }
  /// None: rows of a map share no input link, and its cells no poses of the body.
  [[nodiscard]] std::shared_ptr<const FourBarCells> four_bar_cells(const RegionMap& /*map*/) const override {
    return nullptr;
  }

  [[nodiscard]] const PoseFit* fit_at(MapPoint place) const override;

 private:
  void fill(RegionMap& map, std::span<const double> input, std::span<const double> output, bool respect_direction,
            const RegionOptions& options, const Progress& progress) const override;

  std::shared_ptr<const NearPoses> near_;
  std::vector<PoseFit> fits_;
  std::vector<std::size_t> positions_;  ///< poses of the target, the first first
};

/// Of the linkages of such a family, which is kept.
[[nodiscard]] std::shared_ptr<const CellMeasure> fitted_error_measure(std::shared_ptr<const FittedMotionFamily> family);

/// As task_family(), of a task that is_fitted(), without mistakes; requirements with default lengths filled in.
[[nodiscard]] TaskFamily family_of_near(const MotionTask& task, const Requirements& requirements,
                                        const FitWishes& wishes, const RegionOptions& options,
                                        const Progress& progress = {});
/// As search_fits(), of the same.
[[nodiscard]] FitSearch search_near(const MotionTask& task, const Requirements& requirements, const FitWishes& wishes,
                                    const RegionOptions& options, const Progress& progress);

}  // namespace linkwright
