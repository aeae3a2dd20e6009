#include "support/case_region.hpp"

#include "linkwright/planar/burmester_curve.hpp"

namespace linkwright::testing {

RegionMap region_of(const std::vector<PrescribedPose>& poses, const std::vector<Dyad>& dyads,
                    const RegionOptions& options) {
  const PoseConditions conditions = pose_conditions(poses);
  const RegionAxis axis(dyads, conditions.frame.to_working(poses));
  return RegionMap(axis, axis, conditions.frame.scale, options);
}

RegionMap region_of(const std::vector<PrescribedPose>& poses, int samples, const RegionOptions& options) {
  const BurmesterCurve curve(pose_conditions(poses));
  std::vector<Dyad> dyads;
  for (const double tau : curve.samples(samples, Spacing::coordinate)) dyads.push_back(curve.dyad(tau));
  return region_of(poses, dyads, options);
}

}  // namespace linkwright::testing
