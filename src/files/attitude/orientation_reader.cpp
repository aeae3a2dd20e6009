#include <algorithm>
#include <fmt/format.h>
#include <functional>

#include "attitude/nearest_rotation.hpp"
#include "attitude_header.hpp"
#include "files/json/json.hpp"
#include "files/json/json_document.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/orientation_file.hpp"
#include "linkwright/files/problem_file.hpp"
#include "space_reader.hpp"

namespace linkwright {
namespace {

constexpr std::size_t max_evaluations = 100;

StoredOrientation stored(const UnitQuaternion& q) { return {.rotation = Rotation(q), .quaternion = q}; }
StoredOrientation stored(const Rotation& c) { return {.rotation = c, .quaternion = c.quaternion()}; }

/// Of a representation that reads a vector and makes a quaternion.
template <class Representation>
std::optional<StoredOrientation> read_as(const JsonValue& value) {
  const auto vector = read_vector(value);
  const auto read = vector ? accepted(value, Representation::of(*vector)) : std::nullopt;
  return read ? std::optional(stored(read->quaternion())) : std::nullopt;
}

std::optional<StoredOrientation> read_matrix(const JsonObject& object, const JsonValue& value) {
  const auto matrix = read_matrix3x3(value);
  const auto flag = object.find("nearest");
  const auto nearest = flag ? flag->as_flag() : std::optional(false);
  if (!matrix || !nearest) return std::nullopt;
  if (!*nearest) {
    const auto rotation = accepted(value, Rotation::from_matrix(*matrix));
    return rotation ? std::optional(stored(*rotation)) : std::nullopt;
  }
  const auto found = accepted(value, nearest_rotation(*matrix));
  if (!found) return std::nullopt;
  if (!found->unique) {
    value.mistake("not_unique",
                  "several rotations are equally near to this matrix; give one that is nearer to a rotation");
    return std::nullopt;
  }
  StoredOrientation orientation = stored(found->rotation);
  orientation.nearest_distance = found->distance;
  return orientation;
}

/// `axis` and `angle_deg`.
std::optional<AxisAngle> read_turn(const JsonObject& object) {
  const auto axis = object.require("axis", {"axis", "the axis [x, y, z]"});
  const auto angle = object.require("angle_deg", {"turn_angle", "the angle about the axis, degrees"});
  const auto vector = axis ? read_vector(*axis) : std::nullopt;
  const auto number = angle ? read_angle(*angle) : std::nullopt;
  return vector && number ? accepted(*axis, AxisAngle::of(*vector, *number)) : std::nullopt;
}

std::optional<StoredOrientation> read_axis_angle(const JsonObject& object) {
  const auto turn = read_turn(object);
  if (!turn) return std::nullopt;
  StoredOrientation orientation = stored(turn->quaternion());
  orientation.turn = turn;
  return orientation;
}

std::optional<StoredOrientation> read_quaternion(const JsonValue& value) {
  const auto numbers = read_numbers(value, 4, "[w, x, y, z]");
  if (!numbers) return std::nullopt;
  const auto& q = *numbers;
  const auto quaternion = accepted(value, UnitQuaternion::of(q[0], {q[1], q[2], q[3]}));
  return quaternion ? std::optional(stored(*quaternion)) : std::nullopt;
}

std::optional<EulerSequence> read_sequence(const JsonObject& object) {
  constexpr std::array<std::string_view, 2> turnings = {"intrinsic", "extrinsic"};
  const auto found = object.require("sequence", {"axis_order", "the order of the axes, like \"zxz\" or \"xyz\""});
  const auto name = found ? found->as_text() : std::nullopt;
  const auto turning = object.find("turning");
  const auto word = turning ? turning->as_one_of(turnings) : std::optional(turnings[0]);
  if (!name || !word) return std::nullopt;
  const Turning kind = *word == turnings[0] ? Turning::intrinsic : Turning::extrinsic;
  if (name->size() <= 5) return accepted(*found, EulerSequence::named(*name, kind));
  return accepted(*found, EulerSequence::named(name->substr(0, 5) + "…", kind));  // nobody wants to read all of it
}

std::optional<StoredOrientation> read_euler(const JsonObject& object, const JsonValue& value) {
  const auto angles = read_bounded_vector(value);
  const auto sequence = read_sequence(object);
  if (!angles || !sequence) return std::nullopt;
  const EulerAngles euler{*sequence, radians(angles->x), radians(angles->y), radians(angles->z)};
  StoredOrientation orientation = stored(euler.quaternion());
  orientation.euler = euler;
  return orientation;
}

std::optional<StoredOrientation> read_turns(const JsonValue& value, Mistakes& mistakes) {
  if (value.json().is_array() && value.json().size() > max_evaluations) {
    value.mistake("too_many_turns",
                  fmt::format("{} turns are given; give at most {}", value.json().size(), max_evaluations),
                  {{"count", value.json().size()}, {"most", max_evaluations}});
    return std::nullopt;
  }
  UnitQuaternion q;
  bool complete = true;
  const bool is_list =
      value.for_each({"turns", "a list of turns [{\"axis\": …, \"angle_deg\": …}, …]"}, [&](const JsonValue& item) {
        const JsonObject object(item, mistakes, {"axis", "angle_deg"});
        const auto turn = read_turn(object);
        complete = complete && turn;
        if (turn) q = q * turn->quaternion();
      });
  return is_list && complete ? std::optional(stored(q)) : std::nullopt;
}

std::optional<StoredOrientation> read_triads(const JsonValue& value, Mistakes& mistakes) {
  const JsonObject object(value, mistakes, {"fixed", "moving"});
  const auto triad = [&](std::string_view key) -> std::optional<Triad> {
    const auto found =
        object.require(key, {"triad", "the axes of a frame [x, y, z], each [a, b, c] in one common frame"});
    const auto axes = found ? read_matrix3x3(*found) : std::nullopt;
    return axes ? std::optional(axes->row) : std::nullopt;
  };
  const auto fixed = triad("fixed"), moving = triad("moving");
  const auto rotation = fixed && moving ? accepted(value, Rotation::from_triads(*fixed, *moving)) : std::nullopt;
  return rotation ? std::optional(stored(*rotation)) : std::nullopt;
}

/// One way to give an orientation: its key, the keys that go with it, and who reads it (the object, the key's value).
struct Form {
  std::string_view key;
  std::vector<std::string_view> companions;
  std::function<std::optional<StoredOrientation>(const JsonObject&, const JsonValue&, Mistakes&)> read;
};

/// For forms that are their value alone.
template <class Read>
auto alone(Read read) {
  return [read](const JsonObject&, const JsonValue& value, Mistakes&) { return read(value); };
}

const std::vector<Form>& forms() {
  static const std::vector<Form> all = {
      {"matrix",
       {"nearest"},
       [](const auto& object, const auto& value, Mistakes&) { return read_matrix(object, value); }},
      {"axis", {"angle_deg"}, [](const auto& object, const auto&, Mistakes&) { return read_axis_angle(object); }},
      {"quaternion", {}, alone(read_quaternion)},
      {"rotation_vector", {}, alone(read_as<RotationVector>)},
      {"euler_deg",
       {"sequence", "turning"},
       [](const auto& object, const auto& value, Mistakes&) { return read_euler(object, value); }},
      {"rodrigues", {}, alone(read_as<RodriguesVector>)},
      {"mrp", {}, alone(read_as<ModifiedRodriguesVector>)},
      {"turns", {}, [](const auto&, const auto& value, Mistakes& mistakes) { return read_turns(value, mistakes); }},
      {"triads", {}, [](const auto&, const auto& value, Mistakes& mistakes) { return read_triads(value, mistakes); }},
  };
  return all;
}

/// The one form that is given; a mistake where there is none, or more.
const Form* form_of(const JsonObject& object, const JsonValue& value) {
  const Form* given = nullptr;
  for (const Form& form : forms()) {
    const auto found = object.find(form.key);
    if (found && given != nullptr) {
      found->mistake("two_orientations",
                     fmt::format("an orientation is given already, by \"{}\"; keep one of the two", given->key),
                     {{"first", given->key}});
      return nullptr;
    }
    if (found) given = &form;
  }
  if (given == nullptr) {
    value.mistake(
        "no_orientation",
        "no orientation is given here; add \"axis\" with \"angle_deg\", \"matrix\", \"quaternion\", "
        "\"rotation_vector\", \"euler_deg\" with \"sequence\", \"rodrigues\", \"mrp\", \"turns\" or \"triads\"");
  }
  return given;
}

/// Keys that belong to other forms than the one given.
bool has_strays(const JsonObject& object, const Form& given) {
  bool any = false;
  for (const Form& form : forms()) {
    if (form.key == given.key) continue;
    for (const std::string_view key : form.companions) {
      const auto found = object.find(key);
      if (found)
        found->mistake("stray_key",
                       fmt::format("this belongs to \"{}\", not to \"{}\"; remove it", form.key, given.key),
                       {{"form", form.key}, {"given", given.key}});
      any = any || found;
    }
  }
  return any;
}

}  // namespace

std::optional<StoredOrientation> read_orientation(const JsonValue& value, Mistakes& mistakes) {
  const std::size_t before = mistakes.size();
  const JsonObject object(value, mistakes,
                          {"matrix", "nearest", "axis", "angle_deg", "quaternion", "rotation_vector", "euler_deg",
                           "sequence", "turning", "rodrigues", "mrp", "turns", "triads"});
  if (mistakes.size() != before) return std::nullopt;
  const Form* form = form_of(object, value);
  if (form == nullptr || has_strays(object, *form)) return std::nullopt;
  const auto given = object.find(form->key);
  return given ? form->read(object, *given, mistakes) : std::nullopt;
}

Result<OrientationTask> read_orientation_task(std::string_view text) {
  return read_attitude_task<OrientationTask>(
      text, {"linkwright", "title", "orientation", "vectors"}, [](const JsonObject& file, Mistakes& mistakes) {
        OrientationTask task;
        const auto orientation = file.require(
            "orientation", {"orientation", "the orientation: \"orientation\": {\"axis\": …, \"angle_deg\": …}"});
        const auto vectors = file.find("vectors");
        const auto read = orientation ? read_orientation(*orientation, mistakes) : std::nullopt;
        if (read) task.orientation = *read;
        if (vectors) task.vectors = read_vectors(*vectors).value_or(std::vector<Vector3>());
        return task;
      });
}

}  // namespace linkwright
