#include "drawn_loads.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "linkwright/core/angle.hpp"

namespace linkwright::soak {
namespace {

struct Body {
  std::vector<Pose> poses;  ///< of the task, where it has any
  double scale = 1;
};

Body body_of(const Json& task, const Sheet& sheet) {
  Body body{{}, sheet.scale};
  if (task.contains("poses"))
    for (const Json& pose : task["poses"])
      body.poses.push_back(
          {{pose["x"].get<double>(), pose["y"].get<double>()}, radians(pose["theta_deg"].get<double>())});
  return body;
}

Json pair_of(Point p) { return {p.real(), p.imag()}; }

/// Mostly what a person lifts, newtons or kilograms; one in eight what nobody would.
double drawn_size(Draw& draw) { return draw.chance(0.125) ? draw.power_of_ten(-9, 6) : draw.power_of_ten(-1, 2); }

Json drawn_center(Draw& draw, const Body& body) { return pair_of(body.scale * draw.point(2)); }

Json drawn_link(Draw& draw, const Body& body, bool has_unit) {
  if (has_unit && draw.chance(0.5)) return Json::object({{"kg_per_m", drawn_size(draw)}});
  Json link = {{"mass", drawn_size(draw)}};
  if (draw.chance(0.5)) link["center"] = drawn_center(draw, body);
  return link;
}

Point ground_stud(Draw& draw, const Body& body) {
  const Point about = body.poses.empty() ? Point{} : body.poses.front().origin;
  return about + body.scale * draw.point(4);
}

/// So long that it fits in all positions, and mostly beyond them.
void fit_gas_spring(Draw& draw, const Body& body, Point ground, Point stud, Json& spring) {
  double shortest = std::numeric_limits<double>::infinity(), longest = 0;
  for (const Pose& pose : body.poses) {
    const double length = std::abs(pose.origin + direction(pose.angle) * stud - ground);
    shortest = std::min(shortest, length), longest = std::max(longest, length);
  }
  if (body.poses.empty()) shortest = body.scale, longest = 4 * body.scale;
  const double extended = longest * (1 + draw.power_of_ten(-3, -0.5));
  spring["extended_length"] = extended;
  spring["stroke"] = std::min(0.95 * extended, (extended - shortest) * (1 + draw.power_of_ten(-3, -0.5)));
  spring["measured_at"] = draw.between(0, 0.2) * spring["stroke"].get<double>();
}

Json gas_spring(Draw& draw, const Body& body) {
  Json spring = {{"kind", "gas"}, {"count", draw.whole(1, 3)}};
  const Point ground = ground_stud(draw, body), stud = body.scale * draw.point(2);
  const bool from_ground = draw.chance(0.7);
  const Json on_ground = {{"on", "ground"}, {"at", pair_of(ground)}}, on_body = {{"on", "body"}, {"at", pair_of(stud)}};
  spring["from"] = from_ground ? on_ground : on_body;
  spring["to"] = from_ground ? on_body : on_ground;
  fit_gas_spring(draw, body, ground, stud, spring);
  const double f1 = drawn_size(draw) * 10, f2 = f1 * (1 + draw.between(0, 0.6)), friction = f1 * draw.between(0, 0.1);
  spring["F1"] = f1;
  spring["F2"] = f2;
  if (draw.chance(0.5)) {
    spring["F3"] = f1 + 2 * friction;
    spring["F4"] = f2 + 2 * friction;
  } else {
    spring["friction"] = friction;
  }
  if (draw.chance(0.2)) spring["percent_per_10K"] = draw.between(0, 5);
  return spring;
}

Json coil_spring(Draw& draw, const Body& body) {
  Json spring = {{"kind", "coil"}, {"count", draw.whole(1, 3)}};
  const auto* const from = draw.one_of({"ground", "ground", "input", "output"});
  const auto* const to = draw.one_of({"body", "body", "coupler", "output"});
  spring["from"] = {{"on", from},
                    {"at", pair_of(from[0] == 'g' ? ground_stud(draw, body) : body.scale * draw.point(1))}};
  spring["to"] = {{"on", std::string(to) == from ? "body" : to}, {"at", drawn_center(draw, body)}};
  spring["rate"] = drawn_size(draw) / body.scale;
  spring["free_length"] = draw.chance(0.3) ? 0.0 : body.scale * draw.between(0, 4);
  if (draw.chance(0.4)) spring["acts"] = draw.one_of({"both", "tension", "compression"});
  return spring;
}

Json torsion_spring(Draw& draw) {
  return {{"kind", "torsion"},
          {"joint", draw.one_of({"input_ground", "input_coupler", "output_coupler", "output_ground"})},
          {"rate_per_deg", draw.power_of_ten(-4, 1)},
          {"torque_at_position_1", draw.between(-20, 20)}};
}

Json drawn_springs(Draw& draw, const Body& body, bool has_unit) {
  Json springs = Json::array();
  for (int k = draw.whole(0, 3); k > 0; --k) {
    const int form = draw.whole(0, has_unit ? 2 : 1);
    springs.push_back(form == 0 ? gas_spring(draw, body) : form == 1 ? coil_spring(draw, body) : torsion_spring(draw));
  }
  return springs;
}

Json drawn_extra(Draw& draw, const Body& body) {
  Json extra = {{"name", "snow"}, {"on", draw.one_of({"body", "body", "coupler", "input", "output"})}};
  extra["at"] = drawn_center(draw, body);
  if (draw.chance(0.5)) {
    extra["mass"] = drawn_size(draw);
  } else {
    extra["force"] = pair_of(drawn_size(draw) * draw.point(1));
    extra["frame"] = draw.one_of({"fixed", "body"});
  }
  if (draw.chance(0.3)) extra["always"] = true;
  return extra;
}

Json drawn_cases(Draw& draw, bool has_extra) {
  Json cases = Json::array();
  for (int k = draw.whole(1, 4); k > 0; --k) {
    Json one = {{"name", "case " + std::to_string(k)}};
    if (draw.chance(0.5)) one["temperature_C"] = draw.between(-60, 120);
    if (draw.chance(0.3)) one["slope_deg"] = draw.between(-30, 30);
    if (has_extra && draw.chance(0.5)) one["extra"] = {"snow"};
    if (draw.chance(0.3)) one["spring_percent"] = draw.between(0, 130);
    if (draw.chance(0.2)) one["gas_exponent"] = draw.between(1, 1.4);
    cases.push_back(one);
  }
  return cases;
}

Json drawn_hand(Draw& draw, const Body& body) {
  Json handle = {{"point", drawn_center(draw, body)}};
  if (draw.chance(0.2)) handle["direction"] = "vertical";
  if (draw.chance(0.3)) handle["direction"] = {{"fixed_deg", draw.between(-180, 180)}};
  return handle;
}

Json drawn_cylinder(Draw& draw, const Body& body) {
  const auto* const to = draw.one_of({"input", "body", "output", "coupler"});
  return {{"cylinder",
           {{"from", {{"on", "ground"}, {"at", pair_of(ground_stud(draw, body))}}},
            {"to", {{"on", to}, {"at", drawn_center(draw, body)}}}}}};
}

/// Within some seconds; slow enough for its speeds to be those of machines.
Json drawn_motion(Draw& draw) {
  const double duration = draw.power_of_ten(-0.5, 1);
  const int form = draw.whole(0, 4);
  if (form == 0)
    return {{"table", {{0, 0}, {duration * draw.between(0.4, 0.6), draw.between(0.4, 0.6)}, {duration, 1}}}};
  Json motion = {{"law", draw.one_of({"uniform", "trapezoid", "cycloid", "3-4-5"})}, {"duration_s", duration}};
  if (motion["law"] == "trapezoid" && draw.chance(0.5)) motion["ramp"] = draw.between(0.05, 0.5);
  return motion;
}

/// Each linkage has the best strength of one of the gas springs.
void leave_strength_free(Draw& draw, Json& springs) {
  for (Json& spring : springs) {
    if (spring["kind"] != "gas") continue;
    const double f1 = spring["F1"];
    spring["best_F1"] = {{"max_F1", std::max(1.0, f1 * draw.power_of_ten(-1, 1))}};
    if (draw.chance(0.3)) spring["best_F1"]["min_hold_open"] = f1 * draw.between(-0.1, 0.1);
    return;
  }
}

Json drawn_loads(Draw& draw, const Body& body, bool has_unit) {
  Json loads = Json::object();
  if (draw.chance(0.2)) loads["gravity"] = {{"direction_deg", draw.between(-180, 180)}};
  if (draw.chance(0.85)) loads["body"] = {{"mass", drawn_size(draw)}, {"center", drawn_center(draw, body)}};
  for (const char* link : {"input", "coupler", "output"})
    if (draw.chance(0.3)) loads["links"][link] = drawn_link(draw, body, has_unit);
  const bool has_extra = draw.chance(0.4);
  if (has_extra) loads["extra"] = Json::array({drawn_extra(draw, body)});
  loads["springs"] = drawn_springs(draw, body, has_unit);
  const bool has_drive = draw.chance(0.4);
  if (has_drive)
    loads["drive"] = draw.chance(0.3) ? drawn_cylinder(draw, body) : Json(draw.one_of({"input", "output"}));
  if (!has_drive || draw.chance(0.7)) loads["handle"] = drawn_hand(draw, body);
  if (loads.contains("handle") && draw.chance(0.3)) leave_strength_free(draw, loads["springs"]);
  if (draw.chance(0.3))
    loads["pins"] = {{"radius", body.scale * draw.power_of_ten(-4, -1)}, {"friction", draw.between(0, 0.4)}};
  if (draw.chance(0.7)) loads["cases"] = drawn_cases(draw, has_extra);
  if (draw.chance(0.3)) loads["stations"] = draw.whole(4, 30);
  if (has_unit && draw.chance(0.15)) loads["motion"] = drawn_motion(draw);
  return loads;
}

/// Such limits as some linkages meet and some do not.
void add_what_goes_by_them(Draw& draw, const Json& loads, Json& problem) {
  Json &options = problem["options"], &wanted = problem["requirements"];
  const double weight = loads.contains("body") ? 9.81 * loads["body"]["mass"].get<double>() : 10;
  const auto about = [&] { return weight * draw.power_of_ten(-1, 1); };
  std::vector<const char*> objectives = {"pin_force"};
  if (draw.chance(0.2)) wanted["max_pin_force"] = 5 * about();
  if (loads.contains("handle")) {
    objectives.insert(objectives.end(), {"hand_force", "hold_open"});
    if (draw.chance(0.25)) wanted["max_open_force"] = about();
    if (draw.chance(0.25)) wanted["max_close_force"] = about();
    if (draw.chance(0.2)) wanted["min_hold_open"] = draw.between(-1, 0.2) * weight;
    if (draw.chance(0.15)) wanted["max_self_rise_deg"] = draw.between(0, 90);
    if (draw.chance(0.1)) wanted["min_self_close_deg"] = draw.between(0, 30);
    if (draw.chance(0.3)) objectives.push_back(draw.one_of({"self_rise", "self_close"}));
  }
  const auto& springs = loads["springs"];
  if (std::any_of(springs.begin(), springs.end(), [](const Json& spring) { return spring.contains("best_F1"); })) {
    objectives.push_back("best_F1");
    if (draw.chance(0.3)) wanted["max_best_F1"] = 5 * about();
  }
  if (loads.contains("drive") && loads["drive"].is_object()) {
    objectives.push_back("cylinder_force");
    if (draw.chance(0.3)) wanted["max_cylinder_force"] = 3 * about();
  }
  if (loads.contains("drive") && loads["drive"].is_string()) {
    objectives.push_back("torque");
    if (draw.chance(0.3)) wanted["max_torque"] = about();
  }
  const auto drawn = [&] { return objectives[static_cast<std::size_t>(draw.whole(0, std::ssize(objectives) - 1))]; };
  if (draw.chance(0.4)) options["objective"] = drawn();
  if (draw.chance(0.15)) options["pareto"] = {"min_transmission_angle", drawn()};
}

}  // namespace

void add_loads(Draw& draw, const Sheet& sheet, std::string_view kind, Json& problem) {
  const bool takes_them = kind.starts_with("three") || kind.starts_with("four") || kind.starts_with("five") ||
                          kind.starts_with("path_poses");
  if (!takes_them || !draw.chance(0.35)) return;
  const bool has_unit = draw.chance(0.7);
  if (has_unit) problem["length_unit"] = draw.one_of({"mm", "m", "in"});
  problem["loads"] = drawn_loads(draw, body_of(problem["task"], sheet), has_unit);
  Json& samples = problem["options"]["region_samples"];
  samples = std::min(samples.get<int>(), 100);
  add_what_goes_by_them(draw, problem["loads"], problem);
}

}  // namespace linkwright::soak
