#include "support/case_region.hpp"

#include "linkwright/planar/burmester_curve.hpp"

namespace linkwright::testing {

RegionAxis axis_of(const std::vector<PrescribedPose>& poses, const std::vector<Dyad>& dyads) {
  return {dyads, pose_conditions(poses).frame.to_working(poses)};
}

RegionAxis axis_at(const std::vector<PrescribedPose>& poses, const std::vector<double>& coordinates) {
  const BurmesterCurve curve(pose_conditions(poses));
  std::vector<Dyad> dyads;
  for (const double tau : coordinates) dyads.push_back(curve.dyad(tau));
  return axis_of(poses, dyads);
}

RegionAxis axis_of(const std::vector<PrescribedPose>& poses, int samples) {
  return axis_at(poses, BurmesterCurve(pose_conditions(poses)).samples(samples, Spacing::coordinate));
}

RegionMap region_of(const std::vector<PrescribedPose>& poses, const RegionAxis& axis, const RegionOptions& options) {
  return {axis, axis, pose_conditions(poses).frame.scale, options};
}

RegionMap region_of(const std::vector<PrescribedPose>& poses, int samples, const RegionOptions& options) {
  return region_of(poses, axis_of(poses, samples), options);
}

}  // namespace linkwright::testing
