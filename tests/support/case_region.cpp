#include "support/case_region.hpp"

#include "linkwright/planar/burmester_curve.hpp"

namespace linkwright::testing {

DyadAxis axis_of(const std::vector<PrescribedPose>& poses, const std::vector<Dyad>& dyads) {
  return {dyads, pose_conditions(poses).frame.to_working(poses)};
}

DyadAxis axis_at(const std::vector<PrescribedPose>& poses, const std::vector<double>& coordinates) {
  const BurmesterCurve curve(pose_conditions(poses));
  std::vector<Dyad> dyads;
  for (const double tau : coordinates) dyads.push_back(curve.dyad(tau));
  return axis_of(poses, dyads);
}

DyadAxis axis_of(const std::vector<PrescribedPose>& poses, int samples) {
  return axis_at(poses, BurmesterCurve(pose_conditions(poses)).samples(samples, Spacing::coordinate));
}

RegionMap map_of(const DyadAxis& input, const DyadAxis& output, double unit, const RegionOptions& options,
                 const Progress& progress) {
  RegionMap map;
  classify_pairs(map, input, output, unit, options, progress);
  return map;
}

MapPivots pivots_of(const DyadAxis& input, const DyadAxis& output, const WorkingFrame& frame) {
  const auto along = [&](const DyadAxis& axis) {
    const auto user = [&](Homogeneous point) {
      const auto p = finite_point(point);
      return p ? std::optional(in_space(frame.to_user(*p))) : std::nullopt;
    };
    std::vector<GroundedLinkPivots> links;
    for (const Dyad& dyad : axis.dyads) links.push_back({user(dyad.center), user(dyad.circle)});
    return links;
  };
  return {along(input), along(output), {}};
}

RegionMap region_of(const std::vector<PrescribedPose>& poses, const DyadAxis& axis, const RegionOptions& options) {
  return map_of(axis, axis, pose_conditions(poses).frame.scale, options);
}

RegionMap region_of(const std::vector<PrescribedPose>& poses, int samples, const RegionOptions& options) {
  return region_of(poses, axis_of(poses, samples), options);
}

}  // namespace linkwright::testing
