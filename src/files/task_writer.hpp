#pragma once

#include <vector>

#include "files/json/json_writer.hpp"
#include "linkwright/algebra/directed_line.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "linkwright/synthesis/task.hpp"

namespace linkwright {

/// The object `task` of a problem file, every default written out.
void write_task(JsonWriter& json, const Task& task);
/// A pose as problem files hold it.
void write_pose(JsonWriter& json, const PrescribedPose& pose);
/// The member `poses`, in numbers even where they were given by points of the body.
void write_poses(JsonWriter& json, const std::vector<PrescribedPose>& poses);
/// The object `{"point": [x, y], "direction_deg": …}`.
void write_line(JsonWriter& json, const LineAtAngle& line);
/// `[x, y]`, on one line.
void write_point(JsonWriter& json, Point point);
/// `[low, high]`, on one line.
void write_interval(JsonWriter& json, double low, double high);

}  // namespace linkwright
