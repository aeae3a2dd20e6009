#include "displacement_reader.hpp"

#include <cmath>
#include <fmt/format.h>

#include "attitude_header.hpp"
#include "files/json/json.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/count_text.hpp"
#include "space_reader.hpp"

namespace linkwright {
namespace {

bool is_bounded(Vector3 v) {
  return std::abs(v.x) <= largest_quantity && std::abs(v.y) <= largest_quantity && std::abs(v.z) <= largest_quantity;
}

bool read_matrix(const JsonValue& value, DisplacementTask& task) {
  const auto matrix = read_matrix4x4(value);
  const auto displacement = matrix ? accepted(value, Displacement::from_matrix(*matrix)) : std::nullopt;
  if (!displacement) return false;
  if (!is_bounded(displacement->translation)) {
    value.mistake("translation_range",
                  fmt::format("a translation lies between ±{}; take a larger unit", limit_text(largest_quantity)),
                  {{"most", limit_text(largest_quantity)}});
    return false;
  }
  task.displacement = *displacement;
  return true;
}

/// `orientation` and `translation`; what is missing of the two is none.
bool read_parts(const JsonObject& object, Mistakes& mistakes, DisplacementTask& task) {
  const auto orientation = object.find("orientation"), translation = object.find("translation");
  const auto read = orientation ? read_orientation(*orientation, mistakes) : std::optional(StoredOrientation{});
  const auto vector = translation ? read_bounded_vector(*translation) : std::optional(Vector3{});
  if (!read || !vector) return false;
  task.displacement = {read->rotation, *vector};
  task.small_turns_exact = read->turn && std::abs(read->turn->angle()) < pi;
  return true;
}

std::optional<double> optional_quantity(const JsonObject& object, std::string_view key, bool is_angle) {
  const auto found = object.find(key);
  if (!found) return 0.0;
  return is_angle ? read_angle(*found) : read_quantity(*found);
}

bool read_screw(const JsonValue& value, Mistakes& mistakes, DisplacementTask& task) {
  const JsonObject object(value, mistakes, {"axis", "point", "angle_deg", "slide"});
  const auto axis = object.require("axis", {"axis", "the direction [x, y, z] of the axis"});
  const auto place = object.find("point");
  const auto direction = axis ? read_vector(*axis) : std::nullopt;
  const auto point = place ? read_bounded_vector(*place) : std::optional(Vector3{});
  const auto angle = optional_quantity(object, "angle_deg", true), slide = optional_quantity(object, "slide", false);
  if (!direction || !point || !angle || !slide) return false;
  const auto displacement = accepted(*axis, screw_displacement(*direction, *point, *angle, *slide));
  if (!displacement) return false;
  task.displacement = *displacement;
  task.given = Screw{ScrewKind::general, normalized(*direction), *point, *angle, *slide};
  task.small_turns_exact = std::abs(*angle) < pi;
  return true;
}

/// `from` and `to`: T_02 T_01⁻¹.
bool read_displacement_poses(const JsonObject& object, Mistakes& mistakes, DisplacementTask& task) {
  DisplacementTask first, second;
  const auto from = object.require("from", {"first_pose", "the first pose, a displacement"});
  const auto to = object.require("to", {"second_pose", "the second pose, a displacement"});
  const bool first_read = from && read_displacement(*from, mistakes, first);
  const bool second_read = to && read_displacement(*to, mistakes, second);
  if (!first_read || !second_read) return false;
  task.displacement = second.displacement * first.displacement.inverse();
  return true;
}

/// A mistake unless exactly one form is given.
bool is_one_form(const JsonValue& value, int given) {
  if (given == 1) return true;
  value.mistake(
      given == 0 ? "no_displacement" : "two_displacements",
      fmt::format(
          "{} displacement is given here; give \"matrix\" (4 by 4), \"orientation\" and \"translation\", \"screw\", or "
          "\"from\" and \"to\"",
          given == 0 ? "no" : "more than one"));
  return false;
}

}  // namespace

bool read_displacement(const JsonValue& value, Mistakes& mistakes, DisplacementTask& task) {
  const std::size_t before = mistakes.size();
  const JsonObject object(value, mistakes, {"matrix", "orientation", "translation", "screw", "from", "to"});
  if (mistakes.size() != before) return false;
  const auto matrix = object.find("matrix"), screw = object.find("screw");
  const bool parts = object.find("orientation") || object.find("translation");
  const bool poses = object.find("from") || object.find("to");
  if (!is_one_form(value, (matrix ? 1 : 0) + (screw ? 1 : 0) + (parts ? 1 : 0) + (poses ? 1 : 0))) return false;
  if (matrix) return read_matrix(*matrix, task);
  if (screw) return read_screw(*screw, mistakes, task);
  return parts ? read_parts(object, mistakes, task) : read_displacement_poses(object, mistakes, task);
}

Result<DisplacementTask> read_displacement_task(std::string_view text) {
  return read_attitude_task<DisplacementTask>(
      text, {"linkwright", "title", "length_unit", "displacement", "points", "directions"},
      [](const JsonObject& file, Mistakes& mistakes) {
        DisplacementTask task;
        const auto displacement =
            file.require("displacement", {"displacement", "the displacement: \"displacement\": {\"screw\": …}"});
        const auto unit = file.find("length_unit"), points = file.find("points"), directions = file.find("directions");
        if (displacement) read_displacement(*displacement, mistakes, task);
        if (unit) task.length_unit = unit->as_text().value_or("");
        if (points) task.points = read_vectors(*points).value_or(std::vector<Vector3>());
        if (directions) task.directions = read_vectors(*directions).value_or(std::vector<Vector3>());
        return task;
      });
}

}  // namespace linkwright
