#include <fmt/format.h>

#include "attitude_header.hpp"
#include "files/json/json.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/count_text.hpp"
#include "linkwright/files/angular_motion_file.hpp"
#include "space_reader.hpp"

namespace linkwright {
namespace {

constexpr std::size_t max_points = 1000;

std::optional<Vector3> optional_vector(const JsonObject& object, std::string_view key) {
  const auto found = object.find(key);
  return found ? read_bounded_vector(*found) : std::optional(Vector3{});
}

std::optional<PointMotion> read_point(const JsonValue& value, Mistakes& mistakes) {
  const JsonObject object(value, mistakes, {"position", "velocity", "acceleration"});
  if (!value.is_object()) return std::nullopt;
  const auto position = optional_vector(object, "position"), velocity = optional_vector(object, "velocity"),
             acceleration = optional_vector(object, "acceleration");
  if (!position || !velocity || !acceleration) return std::nullopt;
  return PointMotion{*position, *velocity, *acceleration};
}

void read_points(const JsonValue& value, Mistakes& mistakes, std::vector<PointMotion>& points) {
  if (value.json().is_array() && value.json().size() > max_points) {
    value.mistake("too_many_points",
                  fmt::format("{} points are given; give at most {}", value.json().size(), max_points),
                  {{"count", value.json().size()}, {"most", max_points}});
    return;
  }
  value.for_each({"points", "a list of points [{\"position\": [x, y, z]}, …]"}, [&](const JsonValue& item) {
    if (const auto point = read_point(item, mistakes)) points.push_back(*point);
  });
}

/// `velocity`, `acceleration`, `frame`.
void read_vectors(const JsonObject& motion, AngularMotionTask& task) {
  constexpr std::array<std::string_view, 2> frames = {"fixed", "moving"};
  const auto velocity = optional_vector(motion, "velocity"), acceleration = optional_vector(motion, "acceleration");
  const auto frame = motion.find("frame");
  const auto word = frame ? frame->as_one_of(frames) : std::optional(frames[0]);
  if (!velocity || !acceleration || !word) return;
  const Rotation& c = task.orientation.rotation;
  task.in_i = *word == frames[0] ? AngularMotion{*velocity, *acceleration}
                                 : AngularMotion{c.apply(*velocity), c.apply(*acceleration)};
}

bool is_bounded(const Matrix3x3& matrix) { return frobenius_norm(matrix) <= largest_quantity; }

std::optional<Matrix3x3> read_derivative(const JsonValue& value) {
  const auto matrix = read_matrix3x3(value);
  if (!matrix || is_bounded(*matrix)) return matrix;
  value.mistake("derivative_range",
                fmt::format("the elements lie between ±{}; take a smaller unit of time", limit_text(largest_quantity)),
                {{"most", limit_text(largest_quantity)}});
  return std::nullopt;
}

/// Errors of the library, each at the derivative that it names.
void report_errors(const std::vector<Error>& errors, const JsonValue& first, const std::optional<JsonValue>& second) {
  for (const Error& error : errors) {
    (second && error.place == "second" ? *second : first).mistake(error.code, error.message, error.values);
  }
}

/// `matrix_first`, `matrix_second`.
void read_matrices(const JsonObject& motion, AngularMotionTask& task) {
  const auto first = motion.require("matrix_first", {"matrix_rate", "the first derivative of the matrix, three rows"});
  const auto second = motion.find("matrix_second");
  const auto c1 = first ? read_derivative(*first) : std::nullopt;
  const auto c2 = second ? read_derivative(*second) : std::optional(Matrix3x3{});
  if (!c1 || !c2) return;
  const Rotation& c = task.orientation.rotation;
  const auto fit = second ? angular_motion(c, RotationDerivatives{*c1, *c2}) : angular_velocity(c, *c1);
  if (!fit) return report_errors(fit.errors(), *first, second);
  task.in_i = fit->in_i;
  task.velocity_defect = fit->velocity_defect;
  task.acceleration_defect = fit->acceleration_defect;
}

std::optional<QuaternionRate> read_quaternion_rate(const JsonValue& value) {
  const auto numbers = read_numbers(value, 4, "[w, x, y, z]");
  if (!numbers) return std::nullopt;
  const QuaternionRate rate{(*numbers)[0], {(*numbers)[1], (*numbers)[2], (*numbers)[3]}};
  if (std::abs(rate.w) <= largest_quantity && norm(rate.v) <= largest_quantity) return rate;
  value.mistake(
      "quaternion_rate_range",
      fmt::format("the components lie between ±{}; take a smaller unit of time", limit_text(largest_quantity)),
      {{"most", limit_text(largest_quantity)}});
  return std::nullopt;
}

/// `quaternion_first`, `quaternion_second`.
void read_quaternions(const JsonObject& motion, AngularMotionTask& task) {
  const auto first =
      motion.require("quaternion_first", {"quaternion_rate", "the first derivative of the quaternion [w, x, y, z]"});
  const auto second = motion.find("quaternion_second");
  const auto q1 = first ? read_quaternion_rate(*first) : std::nullopt;
  const auto q2 = second ? read_quaternion_rate(*second) : std::optional(QuaternionRate{});
  if (!q1 || !q2) return;
  const UnitQuaternion& q = task.orientation.quaternion;
  const auto fit = second ? angular_motion(q, *q1, *q2) : angular_velocity(q, *q1);
  if (!fit) return report_errors(fit.errors(), *first, second);
  task.in_i = fit->in_i;
  task.velocity_defect = fit->velocity_defect;
  task.acceleration_defect = fit->acceleration_defect;
}

/// `euler_rates_deg`, `euler_accelerations_deg`.
void read_euler_rates(const JsonObject& motion, const JsonValue& value, AngularMotionTask& task) {
  const auto rates = optional_vector(motion, "euler_rates_deg");
  const auto accelerations = optional_vector(motion, "euler_accelerations_deg");
  if (!task.orientation.euler) {
    value.mistake("no_angles",
                  "rates of angles need the angles; give the orientation by \"euler_deg\" and \"sequence\"");
    return;
  }
  if (!rates || !accelerations) return;
  const auto in_radians = [](Vector3 v) { return std::array<double, 3>{radians(v.x), radians(v.y), radians(v.z)}; };
  task.in_i = angular_motion(*task.orientation.euler, {in_radians(*rates), in_radians(*accelerations)});
}

void read_motion(const JsonValue& value, Mistakes& mistakes, AngularMotionTask& task) {
  const std::size_t before = mistakes.size();
  const JsonObject any(value, mistakes,
                       {"velocity", "acceleration", "frame", "matrix_first", "matrix_second", "quaternion_first",
                        "quaternion_second", "euler_rates_deg", "euler_accelerations_deg"});
  if (mistakes.size() != before) return;
  const auto given = [&](std::string_view first, std::string_view second) {
    return any.find(first) || any.find(second);
  };
  const bool vectors = given("velocity", "acceleration"), matrices = given("matrix_first", "matrix_second"),
             quaternions = given("quaternion_first", "quaternion_second"),
             angles = given("euler_rates_deg", "euler_accelerations_deg");
  if ((vectors ? 1 : 0) + (matrices ? 1 : 0) + (quaternions ? 1 : 0) + (angles ? 1 : 0) != 1) {
    value.mistake("one_motion",
                  "the motion is given in one form: \"velocity\" and \"acceleration\", or \"matrix_first\" and "
                  "\"matrix_second\", or \"quaternion_first\" and \"quaternion_second\", or \"euler_rates_deg\" and "
                  "\"euler_accelerations_deg\"");
    return;
  }
  if (const auto frame = any.find("frame"); frame && !vectors) {
    frame->mistake("stray_frame", "this belongs to \"velocity\" and \"acceleration\"; remove it");
  }
  if (vectors) read_vectors(any, task);
  if (matrices) read_matrices(any, task);
  if (quaternions) read_quaternions(any, task);
  if (angles) read_euler_rates(any, value, task);
}

AngularMotionTask read_motion_members(const JsonObject& file, Mistakes& mistakes) {
  AngularMotionTask task;
  const auto orientation =
      file.require("orientation", {"orientation", "the orientation: \"orientation\": {\"axis\": …, \"angle_deg\": …}"});
  const auto motion = file.require("motion", {"motion", "the motion: \"motion\": {\"velocity\": [x, y, z]}"});
  const auto read = orientation ? read_orientation(*orientation, mistakes) : std::nullopt;
  if (read) task.orientation = *read;
  if (read && motion) read_motion(*motion, mistakes, task);
  const auto origin = file.find("origin"), points = file.find("points"), step = file.find("step");
  if (origin) task.origin = read_point(*origin, mistakes).value_or(PointMotion{});
  if (points) read_points(*points, mistakes, task.points);
  if (step) task.step = read_quantity(*step);
  return task;
}

}  // namespace

Result<AngularMotionTask> read_angular_motion_task(std::string_view text) {
  return read_attitude_task<AngularMotionTask>(
      text, {"linkwright", "title", "orientation", "motion", "origin", "points", "step"}, read_motion_members);
}

}  // namespace linkwright
