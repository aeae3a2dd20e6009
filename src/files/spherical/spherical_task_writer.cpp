#include "files/function/wanted_function_writer.hpp"
#include "files/spherical/spherical_kind.hpp"
#include "files/spherical/spherical_writer.hpp"
#include "linkwright/files/number_text.hpp"

namespace linkwright {

void write_of_kind(JsonWriter& json, const SphericalMotionTask& task) {
  json.member("kind", "motion");
  json.member("mechanism", "spherical_four_bar");
  write_orientations(json, task.orientations);
  if (!task.given) return;
  json.key("given");
  json.begin_object(JsonWriter::Layout::one_line);
  json.key(task.given->kind == GivenAxes::Kind::fixed ? "fixed_axes" : "moving_axes");
  json.begin_list(JsonWriter::Layout::one_line);
  for (const Vector3 axis : task.given->axes) {
    json.begin_list(JsonWriter::Layout::one_line);
    for (std::size_t i = 0; i < 3; ++i) json.value(axis[i]);
    json.end_list();
  }
  json.end_list();
  json.end_object();
}

void write_of_kind(JsonWriter& json, const SphericalFunctionTask& task) {
  json.member("kind", "function");
  json.member("mechanism", "spherical_four_bar");
  write_pairs_or_function(json, task);
  json.member("ground_angle_deg", degrees_for_files(task.ground_angle));
  write_free_parameter(json, task);
}

}  // namespace linkwright
