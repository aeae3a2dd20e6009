#include <algorithm>

#include "attitude/finite_rotation.hpp"
#include "files/json/json.hpp"
#include "linkwright/attitude/euler_rates.hpp"
#include "linkwright/attitude/screw.hpp"
#include "linkwright/files/angular_motion_file.hpp"
#include "linkwright/files/displacement_file.hpp"
#include "linkwright/files/number_text.hpp"
#include "linkwright/files/orientation_file.hpp"
#include "replies.hpp"
#include "reply_fields.hpp"

namespace linkwright::wasm {
namespace {

constexpr int path_steps = 48;

Json json_of_vector(Vector3 v) { return {v.x, v.y, v.z}; }
Vector3 vector_of(const Json& list) { return {list.at(0), list.at(1), list.at(2)}; }
Json json_of_matrix(const Matrix3x3& m) {
  Json rows = Json::array();
  for (const Vector3 row : m.row) rows.push_back(json_of_vector(row));
  return rows;
}
/// Three columns as three vectors.
Json json_of_columns(const Matrix3x3& m) {
  Json columns = Json::array();
  for (std::size_t j = 0; j < 3; ++j) columns.push_back({m(0, j), m(1, j), m(2, j)});
  return columns;
}
Json json_of_angles(const EulerAngles& t) {
  return {degrees_for_files(t.first), degrees_for_files(t.second), degrees_for_files(t.third)};
}

Json file(std::string_view member, Json content) {
  return {{"linkwright", 1}, {std::string(member), std::move(content)}};
}

/// What `from` is replaced by where a place begins with it.
Error at_place(Error error, std::string_view from, std::string_view to) {
  if (error.place.substr(0, from.size()) == from) error.place = std::string(to) + error.place.substr(from.size());
  return error;
}
std::vector<Error> on_page(std::vector<Error> errors) {
  for (Error& error : errors) {
    error = at_place(error, "displacement.to.", "");
    error = at_place(error, "displacement.", "");
    error = at_place(error, "motion.euler_rates_deg", "rates_deg");
    error.place = "task." + error.place;
  }
  return errors;
}

/// The orientation of a request, its turn made.
Result<OrientationTask> orientation_of(const Json& request) {
  Json asked = file("orientation", request.value("orientation", Json()));
  if (request.contains("vector")) asked["vectors"] = Json::array({request["vector"]});
  const auto task = read_orientation_task(asked.dump());
  if (!task || !request.contains("turn")) return task;
  const auto turn = read_orientation_task(file("orientation", request["turn"]).dump());
  if (!turn) return turn.errors();
  const UnitQuaternion q = task->orientation.quaternion * turn->orientation.quaternion;
  OrientationTask turned{{Rotation(q), q, {}, {}, {}}, task->vectors};
  return turned;
}

Json converted(const OrientationTask& task) { return Json::parse(write_orientation_report(orientation_report(task))); }

// ---- three turns --------------------------------------------------------------------------------------------------

/// The angles as far as they are played: `turns` of them.
EulerAngles played(EulerAngles angles, double turns) {
  angles.first *= std::clamp(turns, 0.0, 1.0);
  angles.second *= std::clamp(turns - 1, 0.0, 1.0);
  angles.third *= std::clamp(turns - 2, 0.0, 1.0);
  return angles;
}
Json frame_of(const EulerAngles& angles) { return json_of_matrix(angles.rotation().matrix()); }

Json turns_of(const StoredOrientation& orientation, const EulerDecomposition& found, double at) {
  const auto& given = orientation.euler;
  const bool as_given = given && given->sequence == found.angles.sequence;
  const EulerAngles angles = as_given ? *given : found.angles, now = played(angles, at);
  return {{"angles_deg", json_of_angles(angles)},
          {"given", as_given},
          {"locked", found.singularity == Singularity::gimbal_lock},
          {"near_lock", found.is_near_gimbal_lock()},
          {"lock_distance", found.lock_distance},
          {"determined",
           {{"combination", found.determined_sign > 0 ? "first + third" : "first - third"},
            {"angle_deg", degrees_for_files(found.determined)}}},
          {"frames", {frame_of(played(angles, 1)), frame_of(played(angles, 2)), frame_of(angles)}},
          {"axes", json_of_columns(rate_matrix(angles))},
          {"now", {{"frame", frame_of(now)}, {"axes", json_of_columns(rate_matrix(now))}}}};
}

// ---- one turn -----------------------------------------------------------------------------------------------------

/// The turn by a share of its angle; none has no axis.
AxisAngle part_of(const AxisAngle& turn, double share) {
  return turn.axis_defined() ? *AxisAngle::of(turn.axis(), share * turn.angle()) : AxisAngle();
}
Json rotation_of(const OrientationTask& task, double at) {
  const AxisAngle turn = AxisAngle::of(task.orientation.quaternion.canonical()), now = part_of(turn, at);
  const Vector3 a0 = task.vectors.empty() ? Vector3{1, 0, 0} : task.vectors.front();
  Json path = Json::array();
  for (int k = 0; k <= path_steps; ++k)
    path.push_back(json_of_vector(FiniteRotation(part_of(turn, double(k) / path_steps)).apply(a0)));
  return {{"path", path},
          {"now",
           {{"frame", json_of_matrix(now.rotation().matrix())},
            {"vector", json_of_vector(FiniteRotation(now).apply(a0))}}}};
}

// ---- a screw ------------------------------------------------------------------------------------------------------

Json pose_json(const Displacement& pose) { return pose.matrix(); }

Displacement part_of(const Screw& screw, double share) {
  return *screw_displacement(screw.direction, screw.point, share * screw.angle, share * screw.translation);
}
/// The first pose, as a displacement.
Result<DisplacementTask> first_pose(const Json& request) {
  const auto task = read_displacement_task(file("displacement", request["from"]).dump());
  if (task) return task;
  std::vector<Error> errors = task.errors();
  for (Error& error : errors) error = at_place(error, "displacement.", "displacement.from.");
  return errors;
}
Json motion_of(const Screw& screw, const Displacement& from, double at) {
  Json path = Json::array();
  for (int k = 0; k <= path_steps; ++k)
    path.push_back(json_of_vector(part_of(screw, double(k) / path_steps).apply_to_point(from.translation)));
  return {{"path", path}, {"from", pose_json(from)}, {"now", pose_json(part_of(screw, at) * from)}};
}

// ---- all of it ----------------------------------------------------------------------------------------------------

Result<EulerSequence> sequence_of(const Json& request) {
  const bool extrinsic = request.value("turning", "intrinsic") == "extrinsic";
  return EulerSequence::named(request.value("sequence", "zxz"), extrinsic ? Turning::extrinsic : Turning::intrinsic);
}

Result<AngularMotionReport> rates_report(const Json& request, const Json& angles_deg) {
  Json asked = file("orientation", {{"euler_deg", angles_deg},
                                    {"sequence", request.value("sequence", "zxz")},
                                    {"turning", request.value("turning", "intrinsic")}});
  asked["motion"] = Json::object({{"euler_rates_deg", request.value("rates_deg", Json({0, 0, 0}))}});
  const auto task = read_angular_motion_task(asked.dump());
  return task ? angular_motion_report(*task) : Result<AngularMotionReport>(task.errors());
}

Result<DisplacementReport> displacement_between(const Json& request, const Displacement& from,
                                                const UnitQuaternion& q) {
  const Json second = {{"orientation", {{"quaternion", {q.w(), q.v().x, q.v().y, q.v().z}}}},
                       {"translation", request.value("translation", Json({0, 0, 0}))}};
  auto task = read_displacement_task(file("displacement", {{"from", request["from"]}, {"to", second}}).dump());
  if (!task) return task.errors();
  // What rounding leaves between two poses at one place is no translation.
  const double size = norm(vector_of(second["translation"])) + norm(from.translation);
  if (norm(task->displacement.translation) <= tolerance::no_turn * size) task->displacement.translation = {};
  return displacement_report(*task);
}

Result<Json> attitude(const Json& request) {
  const auto task = orientation_of(request);
  const auto sequence = sequence_of(request);
  if (!task || !sequence) return task ? sequence.errors() : task.errors();
  const Json at = request.value("at", Json::object());
  const UnitQuaternion q = task->orientation.quaternion.canonical();
  const EulerDecomposition found = euler_angles(q, *sequence);

  Json reply = {{"convert", converted(*task)},
                {"turns", turns_of(task->orientation, found, at.value("turns", 3.0))},
                {"rotation", rotation_of(*task, at.value("rotation", 1.0))}};
  const auto from = first_pose(request);
  if (!from) return from.errors();
  const auto screw = displacement_between(request, from->displacement, q);
  if (!screw) return screw.errors();
  reply["screw"] = Json::parse(write_displacement_report(*screw));
  reply["motion"] = motion_of(screw->screw, from->displacement, at.value("screw", 1.0));

  const auto rates = rates_report(request, reply["turns"]["angles_deg"]);
  if (!rates) return rates.errors();
  reply["rates"] = Json::parse(write_angular_motion_report(*rates));
  reply["rate_matrix"] = json_of_matrix(rate_matrix(rates->given->angles));
  return reply;
}

Result<Json> answered(std::string_view of, const Json& request) {
  if (of == "attitude") return attitude(request);
  const auto task = orientation_of(request);
  return task ? Result<Json>(Json::object({{"convert", converted(*task)}})) : Result<Json>(task.errors());
}

}  // namespace

std::string attitude_reply(std::string_view of, std::string_view text) {
  const auto reply = answered(of, Json::parse(text));
  return reply ? reply->dump() : refusal_json(on_page(reply.errors()));
}

}  // namespace linkwright::wasm
