#include "attitude_header.hpp"
#include "files/json/json.hpp"
#include "linkwright/files/twist_file.hpp"
#include "space_reader.hpp"

namespace linkwright {
namespace {

std::optional<Vector3> vector_or_zero(const JsonObject& object, std::string_view key) {
  const auto found = object.find(key);
  return found ? read_bounded_vector(*found) : std::optional(Vector3{});
}

std::optional<double> quantity_or_zero(const std::optional<JsonValue>& value) {
  return value ? read_quantity(*value) : std::optional(0.0);
}

void read_twist_screw(const JsonValue& value, Mistakes& mistakes, TwistTask& task) {
  const JsonObject object(value, mistakes, {"axis", "point", "rate", "slide_rate", "pitch"});
  const auto axis = object.require("axis", {"axis", "the direction [x, y, z] of the axis"});
  const auto sliding = object.find("slide_rate"), rising = object.find("pitch");
  if (sliding && rising) {
    rising->mistake("slide_rate_and_pitch", "\"slide_rate\" and \"pitch\" say the same; keep one of them");
    return;
  }
  const auto direction = axis ? read_vector(*axis) : std::nullopt;
  const auto point = vector_or_zero(object, "point");
  const auto rate = quantity_or_zero(object.find("rate")), slide_rate = quantity_or_zero(sliding),
             pitch = quantity_or_zero(rising);
  if (!direction || !point || !rate || !slide_rate || !pitch) return;
  const auto twist = accepted(*axis, twist_of(*direction, *point, *rate, *slide_rate + *pitch * *rate));
  if (twist) task.twist = *twist;
}

void read_twist(const JsonValue& value, Mistakes& mistakes, TwistTask& task) {
  const std::size_t before = mistakes.size();
  const JsonObject object(value, mistakes, {"angular_velocity", "velocity", "at", "screw"});
  if (mistakes.size() != before) return;
  const auto screw = object.find("screw");
  const bool velocities = object.find("angular_velocity") || object.find("velocity") || object.find("at");
  if (velocities == screw.has_value()) {
    value.mistake("one_twist",
                  "the twist is given in one form: \"angular_velocity\" and \"velocity\" (of the point \"at\"), or "
                  "\"screw\"");
    return;
  }
  if (screw) return read_twist_screw(*screw, mistakes, task);
  const auto angular = vector_or_zero(object, "angular_velocity"), velocity = vector_or_zero(object, "velocity"),
             at = vector_or_zero(object, "at");
  if (angular && velocity && at) task.twist = Twist::of_point(*angular, *velocity, *at);
}

}  // namespace

Result<TwistTask> read_twist_task(std::string_view text) {
  return read_attitude_task<TwistTask>(
      text, {"linkwright", "title", "length_unit", "twist", "points"}, [](const JsonObject& file, Mistakes& mistakes) {
        TwistTask task;
        const auto twist =
            file.require("twist", {"twist", "the twist: \"twist\": {\"angular_velocity\": …, \"velocity\": …}"});
        const auto unit = file.find("length_unit"), points = file.find("points");
        if (twist) read_twist(*twist, mistakes, task);
        if (unit) task.length_unit = unit->as_text().value_or("");
        if (points) task.points = read_vectors(*points).value_or(std::vector<Vector3>());
        return task;
      });
}

}  // namespace linkwright
