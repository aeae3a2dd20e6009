#include "task_writer.hpp"

#include "linkwright/core/angle.hpp"
#include "linkwright/files/number_text.hpp"

namespace linkwright {
namespace {

using Layout = JsonWriter::Layout;

void write_derivatives(JsonWriter& json, const std::vector<PoseDerivative>& derivatives) {
  json.key("derivatives");
  json.begin_list(Layout::one_line);
  for (const PoseDerivative& derivative : derivatives) {
    json.begin_object(Layout::one_line);
    json.member("x", derivative.origin.real());
    json.member("y", derivative.origin.imag());
    json.member("theta", derivative.angle);
    json.end_object();
  }
  json.end_list();
}

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

void write_of_kind(JsonWriter& json, const MotionTask& task) {
  json.member("kind", "motion");
  json.member("mechanism", "four_bar");
  write_poses(json, task.poses);
  if (task.freed) json.member("freed_pose", static_cast<int>(*task.freed) + 1);
  if (!task.given) return;
  json.key("given");
  json.begin_object(Layout::one_line);
  std::visit([&](const auto& given) { write_given(json, given); }, *task.given);
  json.end_object();
}

void write_pair(JsonWriter& json, const AnglePair& pair) {
  json.begin_object(Layout::one_line);
  json.member("input_deg", degrees_for_files(pair.input));
  json.member("output_deg", degrees_for_files(pair.output));
  if (!pair.derivatives.empty()) {
    json.key("derivatives");
    json.begin_list(Layout::one_line);
    for (const AngleDerivative& derivative : pair.derivatives) {
      json.begin_object(Layout::one_line);
      json.member("input", derivative.input);
      json.member("output", derivative.output);
      json.end_object();
    }
    json.end_list();
  }
  json.end_object();
}

void write_range(JsonWriter& json, std::string_view key, const std::array<double, 2>& range) {
  json.key(key);
  write_interval(json, range[0], range[1]);
}

void write_dial(JsonWriter& json, std::string_view key, const std::array<double, 2>& range) {
  write_range(json, key, {degrees_for_files(range[0]), degrees_for_files(range[1])});
}

void write_spacing(JsonWriter& json, const NamedFunction& function) {
  json.key("spacing");
  if (function.spacing != PointSpacing::given) return json.value(name(function.spacing));
  json.begin_list(Layout::one_line);
  for (const double x : function.given_points) json.value(x);
  json.end_list();
}

void write_function(JsonWriter& json, const NamedFunction& function) {
  json.begin_object();
  if (function.table.empty()) {
    json.member("expression", std::string_view(function.expression));
  } else {
    json.key("table");
    json.begin_list(Layout::one_line);
    for (const auto& [x, y] : function.table) write_interval(json, x, y);
    json.end_list();
    json.member("interpolation", name(function.interpolation));
  }
  if (function.x) write_range(json, "x", *function.x);
  if (function.y) write_range(json, "y", *function.y);
  write_dial(json, "input_range_deg", function.input_range);
  write_dial(json, "output_range_deg", function.output_range);
  json.member("points", function.points);
  write_spacing(json, function);
  json.end_object();
}

void write_free(JsonWriter& json, const FreeNumber& free) {
  json.begin_object(Layout::one_line);
  json.member("number", name(free.kind));
  if (free.kind != FreeNumber::Kind::output_scale) json.member("pair", static_cast<int>(free.pair) + 1);
  free.kind == FreeNumber::Kind::pair_output ? write_dial(json, "range", free.range)
                                             : write_range(json, "range", free.range);
  json.end_object();
}

void write_of_kind(JsonWriter& json, const FunctionTask& task) {
  json.member("kind", "function");
  json.member("mechanism", "four_bar");
  if (task.function) {
    json.key("function");
    write_function(json, *task.function);
  } else {
    json.key("pairs");
    json.begin_list();
    for (const AnglePair& pair : task.pairs) write_pair(json, pair);
    json.end_list();
  }
  json.key("ground_pivots");
  json.begin_object(Layout::one_line);
  json.key("input");
  write_point(json, task.input_pivot);
  json.key("output");
  write_point(json, task.output_pivot);
  json.end_object();
  if (!task.free) return;
  json.key("free");
  write_free(json, *task.free);
}

void write_of_kind(JsonWriter& json, const SixBarTask& task) {
  json.member("kind", "motion");
  json.member("mechanism", "six_bar");
  write_poses(json, task.poses);
  if (task.chain) {
    json.key("chain");
    write_chain(json, *task.chain);
  }
  json.key("added");
  json.begin_list(Layout::one_line);
  for (const BodyPair pair : task.added) json.value(std::string_view(text(pair)));
  json.end_list();
}

}  // namespace

void write_poses(JsonWriter& json, const std::vector<PrescribedPose>& poses) {
  json.key("poses");
  json.begin_list();
  for (const PrescribedPose& pose : poses) write_pose(json, pose);
  json.end_list();
}

void write_task(JsonWriter& json, const Task& task) {
  json.begin_object();
  std::visit([&](const auto& of_kind) { write_of_kind(json, of_kind); }, task);
  json.end_object();
}

void write_pose(JsonWriter& json, const PrescribedPose& pose) {
  json.begin_object(Layout::one_line);
  json.member("x", pose.pose.origin.real());
  json.member("y", pose.pose.origin.imag());
  json.member("theta_deg", degrees_for_files(pose.pose.angle));
  if (!pose.derivatives.empty()) write_derivatives(json, pose.derivatives);
  json.end_object();
}

void write_chain(JsonWriter& json, const ThreeLinkChain& chain) {
  json.begin_object(Layout::one_line);
  json.key("a");
  write_point(json, chain.a);
  json.key("b");
  write_point(json, chain.b);
  json.key("d");
  write_point(json, chain.d);
  json.key("elbow");
  json.begin_list(Layout::one_line);
  for (const int sign : chain.elbow) json.value(sign);
  json.end_list();
  json.end_object();
}

void write_point(JsonWriter& json, Point point) { write_interval(json, point.real(), point.imag()); }

void write_interval(JsonWriter& json, double low, double high) {
  json.begin_list(Layout::one_line);
  json.value(low);
  json.value(high);
  json.end_list();
}

}  // namespace linkwright
