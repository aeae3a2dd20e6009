#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "drawn_kinds.hpp"
#include "linkwright/attitude/quaternion.hpp"
#include "linkwright/attitude/rotation_vector.hpp"
#include "linkwright/core/angle.hpp"

// Tasks about a fixed centre: turns of all sizes, bodies that turn on and on or about nearly one axis, half-turns,
// orientations that repeat, in every form that files know.
namespace linkwright::soak {
namespace {

Vector3 drawn_axis(Draw& draw) {
  Vector3 axis;
  do axis = {draw.between(-1, 1), draw.between(-1, 1), draw.between(-1, 1)};
  while (dot(axis, axis) > 1 || dot(axis, axis) < 1e-6);
  return normalized(axis);
}

Json vector_json(Vector3 v) { return Json::array({v.x, v.y, v.z}); }

std::vector<UnitQuaternion> drawn_attitudes(Draw& draw, int count) {
  const int manner = draw.whole(0, 7);
  const Vector3 common = drawn_axis(draw);
  const double size = manner == 1 ? draw.power_of_ten(-7, 0) : 1, off = draw.power_of_ten(-12, -1);
  UnitQuaternion here = UnitQuaternion::about(drawn_axis(draw), draw.between(0, pi));
  const UnitQuaternion first = here;
  std::vector<UnitQuaternion> attitudes;
  Vector3 wandering = common;
  for (int i = 0; i < count; ++i) {
    attitudes.push_back(here);
    switch (manner) {
      case 0:
      case 1:
        here = UnitQuaternion::about(drawn_axis(draw), size * draw.between(0, pi)) * first;
        break;
      case 2:
        here = UnitQuaternion::about(normalized(common + off * drawn_axis(draw)), draw.between(-pi, pi)) * first;
        break;
      case 3:
        here = UnitQuaternion::about(drawn_axis(draw), pi) * first;
        break;
      case 4:
        here = draw.chance(0.4) ? here : UnitQuaternion::about(drawn_axis(draw), draw.between(0, 2)) * first;
        break;
      case 5:  // axes in one plane
        here = UnitQuaternion::about(normalized(cross(common, drawn_axis(draw))), draw.between(0.1, 3)) * first;
        break;
      default:
        wandering = normalized(wandering + 0.4 * drawn_axis(draw));
        here = UnitQuaternion::about(wandering, draw.between(0.05, 0.7)) * here;
    }
  }
  return attitudes;
}

Json orientation_json(Draw& draw, const UnitQuaternion& q) {
  const Vector3 v = q.v();
  switch (draw.whole(0, 4)) {
    case 0:
      return {{"rotation_vector", vector_json(RotationVector::of(q).vector())}};
    case 1: {
      const Matrix3x3 m = q.matrix();
      return {{"matrix", Json::array({vector_json(m.row[0]), vector_json(m.row[1]), vector_json(m.row[2])})}};
    }
    case 2:
      return {{"axis", vector_json(draw.power_of_ten(-3, 3) * drawn_axis(draw))},
              {"angle_deg", draw.between(-720, 720)}};
    case 3:
      return {{"euler_deg", Json::array({draw.between(-180, 180), draw.one_of({0.0, 90.0, draw.between(-180, 180)}),
                                         draw.between(-180, 180)})},
              {"sequence", draw.one_of({"zyx", "zxz", "xyz", "yxy"})}};
    default: {
      const double scale = draw.power_of_ten(-2, 2);
      return {{"quaternion", Json::array({scale * q.w(), scale * v.x, scale * v.y, scale * v.z})}};
    }
  }
}

// In one form each, or as they were drawn: forms of their own draw attitudes of their own.
Json orientations_json(Draw& draw, const std::vector<UnitQuaternion>& attitudes) {
  const bool in_any_form = draw.chance(0.4);
  Json list = Json::array();
  for (const UnitQuaternion& q : attitudes)
    list.push_back(in_any_form ? orientation_json(draw, q)
                               : Json{{"quaternion", Json::array({q.w(), q.v().x, q.v().y, q.v().z})}});
  return list;
}

void add_rates(Draw& draw, Json& orientation, int count) {
  constexpr std::array<const char*, 4> keys = {"angular_velocity", "angular_acceleration", "angular_jerk",
                                               "angular_snap"};
  for (int m = 0; m < count; ++m)
    orientation[keys[static_cast<std::size_t>(m)]] = vector_json(draw.power_of_ten(-2, 2) * drawn_axis(draw));
}

}  // namespace

Json drawn_sphere(Draw& draw, std::string_view kind) {
  Json task = {{"kind", "motion"}, {"mechanism", "spherical_four_bar"}};
  const int positions = kind == "sphere_three" ? 3 : kind == "sphere_five" ? 5 : 4;
  const int mixed =
      kind == "sphere_mixed" || (kind == "sphere_five" && draw.chance(0.4)) ? draw.whole(1, positions - 1) : 0;
  Json list = orientations_json(draw, drawn_attitudes(draw, positions - mixed));
  std::vector<int> rates(list.size(), 0);
  for (int k = 0; k < mixed; ++k) ++rates[static_cast<std::size_t>(draw.whole(0, static_cast<int>(list.size()) - 1))];
  for (std::size_t i = 0; i < list.size(); ++i) add_rates(draw, list[i], rates[i]);
  task["orientations"] = list;
  if (kind == "sphere_three")
    task["given"] = {{draw.one_of({"fixed_axes", "moving_axes"}),
                      Json::array({vector_json(drawn_axis(draw)), vector_json(drawn_axis(draw))})}};
  return task;
}

}  // namespace linkwright::soak
