#include "task_writer.hpp"

#include "kinds.hpp"
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

void write_line(JsonWriter& json, const LineAtAngle& line) {
  json.begin_object(Layout::one_line);
  json.key("point");
  write_point(json, line.point);
  json.member("direction_deg", degrees_for_files(line.angle));
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
