#include <fmt/format.h>
#include <string>
#include <string_view>

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

void write_given(JsonWriter& json, const GivenPivots& given) {
  const bool are_alike = given.input && given.output && given.input->kind == given.output->kind;
  if (are_alike) {
    json.key(fmt::format("{}_pivots", name(given.input->kind)));
    json.begin_object(JsonWriter::Layout::one_line);
  }
  for (const Side side : {Side::input, Side::output}) {
    const auto& pivot = side == Side::input ? given.input : given.output;
    if (!pivot) continue;
    json.key(are_alike ? std::string(name(side)) : fmt::format("{}_{}_pivot", name(side), name(pivot->kind)));
    write_point(json, pivot->point);
  }
  if (are_alike) json.end_object();
}

void write_given(JsonWriter& json, const PivotLines& given) {
  for (const PivotKind kind : {PivotKind::ground, PivotKind::moving}) {
    const auto& line = kind == PivotKind::ground ? given.ground : given.moving;
    if (!line) continue;
    json.key(fmt::format("{}_pivot_on", name(kind)));
    write_line(json, *line);
  }
}

void write_pivots_on(JsonWriter& json, const std::vector<PivotOnLine>& lines) {
  json.key("pivot_on");
  json.begin_list();
  for (const PivotOnLine& asked : lines) {
    json.begin_object(JsonWriter::Layout::one_line);
    json.member("which", name(asked.side));
    json.member("pivot", name(asked.pivot));
    json.key("line");
    write_line(json, asked.line);
    json.end_object();
  }
  json.end_list();
}

}  // namespace

void write_of_kind(JsonWriter& json, const MotionTask& task) {
  json.member("kind", "motion");
  json.member("mechanism", "four_bar");
  write_poses(json, task.poses);
  if (task.relaxed) json.member("freed_pose", static_cast<int>(*task.relaxed) + 1);
  if (!task.pivots_on.empty()) write_pivots_on(json, task.pivots_on);
  if (!task.given) return;
  json.key("given");
  json.begin_object(JsonWriter::Layout::one_line);
  std::visit([&](const auto& given) { write_given(json, given); }, *task.given);
  json.end_object();
}

}  // namespace linkwright
