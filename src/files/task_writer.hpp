#pragma once

#include <span>
#include <vector>

#include "files/json/json_writer.hpp"
#include "linkwright/algebra/directed_line.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "linkwright/planar/body_points.hpp"
#include "linkwright/synthesis/task.hpp"

namespace linkwright {

/// The object `task` of a problem file, every default written out.
void write_task(JsonWriter& json, const Task& task);
/// A pose as problem files hold it.
void write_pose(JsonWriter& json, const PrescribedPose& pose);
/// The member `poses`; by the points that they were given by, where there are any.
void write_poses(JsonWriter& json, const std::vector<PrescribedPose>& poses, std::span<const BodyPoints> points = {});
/// The object `{"point": [x, y], "direction_deg": …}`.
void write_line(JsonWriter& json, const LineAtAngle& line);
/// `[x, y]`, on one line.
void write_point(JsonWriter& json, Point point);
/// `[low, high]`, on one line.
void write_interval(JsonWriter& json, double low, double high);

}  // namespace linkwright
