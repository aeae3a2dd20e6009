#include "files/four_bar/four_bar_kind.hpp"
#include "files/task_writer.hpp"
#include "linkwright/files/number_text.hpp"

namespace linkwright {
namespace {

void write_given(JsonWriter& json, const SideLengths& given) {
  if (!given.output) return json.member("side_length", given.input);
  json.key("side_lengths");
  write_interval(json, given.input, *given.output);
}

void write_given(JsonWriter& json, const SideAngle& given) {
  json.member("side_angle_deg", degrees_for_files(given.angle));
  json.member("directed", given.directed);
  if (given.input_length) json.member("input_length", *given.input_length);
}

void write_given(JsonWriter& json, const InstantCenter& given) {
  json.key("instant_center");
  write_point(json, given.point);
  if (given.at_infinity) json.member("at_infinity", true);
}

}  // namespace

void write_of_kind(JsonWriter& json, const MotionTask& task) {
  json.member("kind", "motion");
  json.member("mechanism", "four_bar");
  write_poses(json, task.poses);
  if (task.relaxed) json.member("freed_pose", static_cast<int>(*task.relaxed) + 1);
  if (!task.given) return;
  json.key("given");
  json.begin_object(JsonWriter::Layout::one_line);
  std::visit([&](const auto& given) { write_given(json, given); }, *task.given);
  json.end_object();
}

}  // namespace linkwright
