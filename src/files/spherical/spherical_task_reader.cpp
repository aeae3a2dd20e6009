#include <array>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "files/attitude/space_reader.hpp"
#include "files/spherical/orientation_list_reader.hpp"
#include "files/spherical/spherical_kind.hpp"

namespace linkwright {
namespace {

constexpr std::size_t most_orientations = 1000;  // what is read to count them in the mistake
constexpr std::array<std::string_view, 4> rate_keys = {"angular_velocity", "angular_acceleration", "angular_jerk",
                                                       "angular_snap"};
constexpr std::array<const char*, 9> form_keys = {"matrix",          "nearest",   "axis",     "angle_deg", "quaternion",
                                                  "rotation_vector", "euler_deg", "sequence", "turning"};

/// The derivatives beside an orientation; nothing where one is no vector or one before it is missing.
std::optional<std::vector<Vector3>> read_rates(const JsonObject& object) {
  std::vector<Vector3> rates;
  std::string_view missing;
  bool complete = true;
  for (const std::string_view key : rate_keys) {
    const auto found = object.find(key);
    if (!found) {
      missing = missing.empty() ? key : missing;
      continue;
    }
    if (!missing.empty()) {
      found->mistake("skipped_derivative",
                     fmt::format("\"{}\" belongs before it; give that too, or leave this out", missing),
                     {{"missing", missing}});
      return std::nullopt;
    }
    const auto rate = read_vector(*found);
    if (rate) rates.push_back(*rate);
    complete = complete && rate;
  }
  return complete ? std::optional(rates) : std::nullopt;
}

/// The members that give the orientation itself.
nlohmann::json form_in(const JsonValue& value) {
  nlohmann::json form = nlohmann::json::object();
  for (const char* key : form_keys)
    if (value.json().contains(key)) form[key] = value.json()[key];
  return form;
}

/// As it stood there, but for the sequence, which is written in one way.
GivenOrientation as_given(const StoredOrientation& read, nlohmann::json form) {
  if (read.euler) form["sequence"] = read.euler->sequence.name();
  std::string members;
  for (const char* key : form_keys)
    if (form.contains(key)) members += fmt::format("{}\"{}\": {}", members.empty() ? "" : ", ", key, form[key].dump());
  return {read.quaternion, members};
}

JsonObject members_of(const JsonValue& value, Mistakes& mistakes, UnknownMembers others) {
  if (others == UnknownMembers::ignored) return {value, mistakes, {}};
  return {value,
          mistakes,
          {"matrix", "nearest", "axis", "angle_deg", "quaternion", "rotation_vector", "euler_deg", "sequence",
           "turning", "angular_velocity", "angular_acceleration", "angular_jerk", "angular_snap"}};
}

std::optional<PrescribedOrientation> read_prescribed(const JsonValue& value, Mistakes& mistakes,
                                                     UnknownMembers others) {
  const std::size_t before = mistakes.size();
  const JsonObject object = members_of(value, mistakes, others);
  if (mistakes.size() != before) return std::nullopt;
  const auto rates = read_rates(object);
  const nlohmann::json form = form_in(value);
  const auto orientation = read_orientation(JsonValue(form, value.place(), mistakes), mistakes);
  if (!rates || !orientation) return std::nullopt;
  return PrescribedOrientation{as_given(*orientation, form), *rates};
}

std::optional<GivenAxes> read_given_axes(const JsonValue& value, Mistakes& mistakes) {
  const JsonObject object(value, mistakes, {"fixed_axes", "moving_axes"});
  if (!value.is_object()) return std::nullopt;
  const auto fixed = object.find("fixed_axes"), moving = object.find("moving_axes");
  if (!fixed && !moving) {
    value.mistake("given_axes",
                  "no axes are given; add \"fixed_axes\": [[x, y, z], [x, y, z]] or \"moving_axes\": […, …]");
    return std::nullopt;
  }
  if (fixed && moving) {
    value.mistake("fixed_and_moving_axes", "give the fixed axes or the moving axes, not both");
    return std::nullopt;
  }
  const JsonValue& list = fixed ? *fixed : *moving;
  GivenAxes given{fixed ? GivenAxes::Kind::fixed : GivenAxes::Kind::moving, {}};
  std::size_t count = 0;
  bool complete = true;
  const bool is_list =
      list.for_each({"two_axes", "a list of two axes [[x, y, z], [x, y, z]]"}, [&](const JsonValue& item) {
        const auto axis = read_vector(item);
        if (axis && count < 2) given.axes[count] = *axis;
        ++count;
        complete = complete && axis;
      });
  if (is_list && count != 2) {
    list.mistake(
        "axis_count",
        fmt::format("{} {} given; two belong here, the input's first", count, count == 1 ? "axis is" : "axes are"),
        {{"count", count}});
    return std::nullopt;
  }
  return is_list && complete ? std::optional(given) : std::nullopt;
}

}  // namespace

bool read_orientations(const JsonObject& task, Mistakes& mistakes, UnknownMembers others,
                       std::vector<PrescribedOrientation>& orientations) {
  const auto found = task.require("orientations", {"orientations_in_full",
                                                   "a list of orientations, each {\"quaternion\": [w, x, y, z]}, "
                                                   "{\"axis\": [x, y, z], \"angle_deg\": …}, {\"rotation_vector\": …}, "
                                                   "{\"matrix\": …} or {\"euler_deg\": …, \"sequence\": \"zyx\"}"});
  if (!found) return false;
  if (found->json().is_array() && found->json().size() > most_orientations) {
    found->mistake("orientation_count",
                   fmt::format("{} orientations are given; five positions are the most that can be solved, remove the "
                               "others",
                               found->json().size()),
                   {{"count", found->json().size()}});
    return false;
  }
  bool complete = true;
  const bool is_list = found->for_each({"orientations", "a list of orientations"}, [&](const JsonValue& item) {
    const auto orientation = read_prescribed(item, mistakes, others);
    if (orientation) orientations.push_back(*orientation);
    complete = complete && orientation;
  });
  return is_list && complete;
}

Task read_spherical_motion(const JsonValue& value, const std::optional<Box>& /*options_box*/, Mistakes& mistakes) {
  const JsonObject object(value, mistakes, {"kind", "mechanism", "orientations", "given"});
  SphericalMotionTask task;
  bool complete = read_orientations(object, mistakes, UnknownMembers::refused, task.orientations);
  if (const auto given = object.find("given"); given && !given->is_null()) {
    task.given = read_given_axes(*given, mistakes);
    complete = complete && task.given;
  }
  if (complete) mistakes.add(mistakes_in(task));
  return task;
}

}  // namespace linkwright
