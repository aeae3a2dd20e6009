#include <array>

#include "files/fields/forms.hpp"
#include "loads_analysis.hpp"

namespace linkwright {
namespace {

constexpr Number kilograms = {.least = 0, .most = largest_coordinate, .name = "kilograms"};
constexpr Number newtons = {.least = -largest_coordinate, .most = largest_coordinate, .name = "newtons"};
constexpr Number not_negative = {.least = 0, .most = largest_coordinate};
constexpr Pair force = {.form = "[Fx, Fy]", .each = newtons, .name = "force"};

const Names<LoadedBody> carrying = {
    {LoadedBody::ground, LoadedBody::input, LoadedBody::body, LoadedBody::coupler, LoadedBody::output}, "loaded_body"};
const Names<FourBarJoint> joints = {{FourBarJoint::input_ground, FourBarJoint::input_coupler,
                                     FourBarJoint::output_coupler, FourBarJoint::output_ground},
                                    "four_bar_joint"};

constexpr Wanted wanted_point = {"carried_point", "a point: {\"on\": \"ground\", \"at\": [x, y]}"};

void carried_point(FieldVisitor& v, CarriedPoint& point) {
  v.required(Field("on",
                   "On the body points are told in the moving frame, on the ground in the fixed frame, on a link "
                   "along and across it from its fixed pivot towards the moving one, the coupler's from its "
                   "pivot at the input.")
                 .missing({"loaded_body", "the body: \"on\": \"ground\", …"}),
             point.on, carrying);
  v.required("at", point.at, forms::point);
}

}  // namespace

void fields(FieldVisitor& v, CarriedPoint& point) {
  v.object({.name = "carried_point"}, [&](FieldVisitor& to) { carried_point(to, point); });
}

static void fields(FieldVisitor& v, Loads::Gravity& gravity) {
  v.object({.name = "gravity"}, [&](FieldVisitor& to) {
    to.optional(Field("direction_deg", "Of a level ground."), gravity.direction, forms::degrees);
    to.optional(Field("acceleration", "m/s²."), gravity.acceleration, not_negative);
  });
}

static void fields(FieldVisitor& v, BodyMass& body) {
  v.object({.name = "body_mass"}, [&](FieldVisitor& to) {
    to.required(Field("mass", "kg."), body.mass, kilograms);
    to.optional(Field("center", "In the moving frame."), body.center, forms::point);
    to.optional(Field("inertia", "About the centre, kg·m².").written(body.inertia != 0), body.inertia, kilograms);
  });
}

static void fields(FieldVisitor& v, LinkMass& link) {
  const std::array alternatives = {Alternative{{"kg_per_m"},
                                               {},
                                               [&link](FieldVisitor& to) {
                                                 link.mass.reset();
                                                 double density = link.kg_per_m.value_or(0);
                                                 to.required(Field("kg_per_m", "A thin rod from pivot to pivot."),
                                                             density, kilograms);
                                                 link.kg_per_m = density;
                                               }},
                                   Alternative{{"mass"}, {}, [&link](FieldVisitor& to) {
                                                 link.kg_per_m.reset();
                                                 double mass = link.mass.value_or(0);
                                                 to.required(Field("mass", "kg."), mass, kilograms);
                                                 link.mass = mass;
                                               }}};
  constexpr std::string_view sentence = "a link weighs either \"mass\" or \"kg_per_m\"";
  v.object({.name = "link_mass"}, [&](FieldVisitor& to) {
    to.one_of(link.kg_per_m ? 0 : 1, alternatives, {"one_mass", sentence, "one_mass", sentence});
    to.given(Field("center", "[along, across] from the fixed pivot; the middle where it is not given."), link.center,
             forms::point);
    to.given(Field("inertia", "About the centre, kg·m²."), link.inertia, kilograms);
  });
}

static void fields(FieldVisitor& v, ExtraLoad& extra) {
  const std::array alternatives = {
      Alternative{{"mass"},
                  {},
                  [&extra](FieldVisitor& to) {
                    double mass = extra.mass.value_or(0);
                    to.required(Field("mass", "kg."), mass, kilograms);
                    extra.mass = mass;
                  }},
      Alternative{
          {"force"}, {}, [&extra](FieldVisitor& to) {
            extra.mass.reset();
            to.required(Field("force", "N."), extra.force, force);
            std::size_t frame = extra.turns_with_body;
            to.optional(Field("frame", "In which the force keeps its components."), frame, Words{{"fixed", "body"}});
            extra.turns_with_body = frame == 1;
          }}};
  constexpr std::string_view sentence = "a load is either a \"mass\" or a \"force\"";
  v.object({.name = "extra_load"}, [&](FieldVisitor& to) {
    to.required(Field("name").missing("\"name\": \"snow\""), extra.name);
    carried_point(to, extra.at);
    to.one_of(extra.mass ? 0 : 1, alternatives, {"one_load", sentence, "one_load", sentence});
    to.optional(Field("always", "In every case; otherwise in those that name it.").written(extra.always), extra.always);
  });
}

namespace {

struct FixedDirection {
  double angle = 0;
};

}  // namespace

static void fields(FieldVisitor& v, FixedDirection& fixed) {
  v.object({.name = "fixed_direction"},
           [&](FieldVisitor& to) { to.required("fixed_deg", fixed.angle, forms::degrees); });
}

namespace {

void hand_direction(FieldVisitor& v, Handle& handle) {
  using Direction = Handle::Direction;
  const auto word = [&](const char* only, Direction direction) {
    return Shape{JsonType::text,
                 [&handle, only, direction](FieldVisitor& to) {
                   std::string text = only;
                   to.text(text);
                   handle.direction = direction;
                 },
                 only};
  };
  const std::array shapes = {word("tangential", Direction::tangential), word("vertical", Direction::vertical),
                             Shape{JsonType::object, [&handle](FieldVisitor& to) {
                                     FixedDirection fixed{handle.angle};
                                     visit(to, fixed);
                                     handle.direction = Direction::fixed;
                                     handle.angle = fixed.angle;
                                   }}};
  v.shapes(static_cast<std::size_t>(handle.direction), shapes,
           Wanted{"hand_direction", "\"tangential\", \"vertical\" or {\"fixed_deg\": 135}"});
}

}  // namespace

static void fields(FieldVisitor& v, Handle& handle) {
  v.object({.name = "handle"}, [&](FieldVisitor& to) {
    to.required(Field("point", "In the moving frame."), handle.point, forms::point);
    to.member(Field("direction",
                    "Which way the hand pulls: as the point moves, against gravity, or at an angle in the "
                    "fixed frame."),
              false, [&](FieldVisitor& in) { hand_direction(in, handle); });
  });
}

static void fields(FieldVisitor& v, FreeStrength& free) {
  v.object({.name = "free_strength"}, [&](FieldVisitor& to) {
    to.given(Field("min_F1", "N; the weakest spring there is, of 1 N, where it is not given."), free.min_f1,
             not_negative);
    to.required(Field("max_F1", "N: without it the search runs into short strong springs."), free.max_f1,
                Number{.least = 1, .most = largest_coordinate});
    to.given(Field("min_hold_open", "N, of the cases that count for it."), free.min_hold_open, newtons);
  });
}

namespace {

void studs(FieldVisitor& v, Spring& spring) {
  v.required(Field("from").missing(wanted_point), spring.from);
  v.required(Field("to").missing(wanted_point), spring.to);
}

void gas_spring(FieldVisitor& v, Spring& spring) {
  auto& gas = as<GasSpring>(spring.law);
  studs(v, spring);
  v.required("extended_length", gas.extended_length, forms::length);
  v.required("stroke", gas.stroke, forms::length);
  v.given(Field("measured_at", "How far before both ends the forces are measured; 5 mm where it is not given."),
          gas.measured_at, not_negative);
  v.required(Field("F1", "Extending, near the extended end, N, at 20 °C."), gas.f1, forms::positive);
  v.required(Field("F2", "Extending, near the compressed end, N."), gas.f2, forms::positive);
  v.given(Field("F3", "Compressing, near the extended end, N."), gas.f3, forms::positive);
  v.given(Field("F4", "Compressing, near the compressed end, N."), gas.f4, forms::positive);
  v.optional(Field("friction",
                   "Half of the difference of compressing and extending, N; in place of F3 and F4. Some "
                   "sheets print the whole difference.")
                 .written(gas.friction != 0),
             gas.friction, not_negative);
  v.optional(Field("rod_diameter", "Always in millimetres; 0: not known.").written(gas.rod_diameter != 0),
             gas.rod_diameter, Number{.least = 0, .most = 1000});
  v.optional(Field("percent_per_10K",
                   "How the force grows with the temperature, of that at 20 °C; null: as an ideal "
                   "gas, 3.41.")
                 .null_for_none()
                 .written(gas.percent_per_10K.has_value()),
             gas.percent_per_10K, Number{.least = 0, .most = 20});
  v.given(Field("best_F1",
                "Leaves the strength free: each linkage has the one with which the largest force of its hand is least. "
                "F1 to F4 then say how much the force grows over the stroke, and what friction takes. One spring at "
                "most."),
          gas.free);
}

void coil_spring(FieldVisitor& v, Spring& spring) {
  using Acts = CoilSpring::Acts;
  auto& coil = as<CoilSpring>(spring.law);
  studs(v, spring);
  v.required(Field("rate", "N per unit of length."), coil.rate, not_negative);
  v.required("free_length", coil.free_length, not_negative);
  v.optional(Field("acts", "Whether it can push and pull.").written(coil.acts != Acts::both), coil.acts,
             Names<Acts>{{Acts::both, Acts::tension, Acts::compression}});
}

void torsion_spring(FieldVisitor& v, Spring& spring) {
  auto& torsion = as<TorsionSpring>(spring.law);
  v.required(Field("joint").missing({"four_bar_joint", "the joint: \"joint\": \"input_ground\", …"}), torsion.joint,
             joints);
  v.required(Field("rate_per_deg", "N·m per degree."), torsion.rate_per_degree, not_negative);
  v.optional(Field("torque_at_position_1",
                   "N·m on the link that turns on the ground, or on the coupler, counter-clockwise positive."),
             torsion.torque_at_position_1, newtons);
}

}  // namespace

void fields(FieldVisitor& v, Spring& spring) {
  const std::array cases = {
      Case{"gas",
           {.name = "gas_spring", .about = "As catalogues have it (GB/T 25751)."},
           [&](FieldVisitor& to) { gas_spring(to, spring); }},
      Case{"coil", {.name = "coil_spring"}, [&](FieldVisitor& to) { coil_spring(to, spring); }},
      Case{"torsion", {.name = "torsion_spring"}, [&](FieldVisitor& to) { torsion_spring(to, spring); }}};
  v.object({.name = "spring"}, [&](FieldVisitor& to) {
    to.optional(Field("name").written(!spring.name.empty()), spring.name);
    to.optional(Field("count", "Side by side."), spring.count, Whole{1, 1000});
    to.switch_on(Field("kind").missing({"spring_kind", "gas, coil or torsion"}), spring.law.index(), cases);
  });
}

static void fields(FieldVisitor& v, PinFriction& pins) {
  v.object({.name = "pins"}, [&](FieldVisitor& to) {
    to.required("radius", pins.radius, not_negative);
    to.required(Field("friction", "Coefficient."), pins.friction, Number{.least = 0, .most = 2});
  });
}

static void fields(FieldVisitor& v, Cylinder& cylinder) {
  v.object({.name = "cylinder"}, [&](FieldVisitor& to) {
    to.required(Field("from").missing(wanted_point), cylinder.from);
    to.required(Field("to").missing(wanted_point), cylinder.to);
  });
}

namespace {

void drive(FieldVisitor& v, Loads& loads) {
  const auto word = [&](const char* only, LoadDrive chosen) {
    return Shape{JsonType::text,
                 [&loads, only, chosen](FieldVisitor& to) {
                   std::string text = only;
                   to.text(text);
                   loads.drive = chosen;
                 },
                 only};
  };
  const std::array shapes = {
      word("hand", LoadDrive::hand), word("input", LoadDrive::input), word("output", LoadDrive::output),
      Shape{JsonType::object, [&loads](FieldVisitor& to) {
              loads.drive = LoadDrive::cylinder;
              to.object({.name = "by_cylinder"}, [&](FieldVisitor& in) { in.required("cylinder", loads.cylinder); });
            }}};
  v.shapes(static_cast<std::size_t>(loads.drive), shapes,
           Wanted{"load_drive", "\"hand\", \"input\", \"output\" or {\"cylinder\": {\"from\": …, \"to\": …}}"});
}

const Names<DriverMotion::Law> driver_laws = {{DriverMotion::Law::uniform, DriverMotion::Law::trapezoid,
                                               DriverMotion::Law::cycloid, DriverMotion::Law::polynomial_345},
                                              "driver_law"};

void by_law(FieldVisitor& v, DriverMotion& motion) {
  const bool has_law = motion.law != DriverMotion::Law::table;
  auto law = has_law ? motion.law : DriverMotion{}.law;
  v.required(
      Field("law", "All but uniform from rest to rest.").missing({"driver_law", "the law: \"law\": \"cycloid\", …"}),
      law, driver_laws);
  motion.law = law;
  v.required(Field("duration_s", "From position 1 to the last one."), motion.duration,
             Number{.least = shortest_motion, .most = longest_motion});
  v.optional(
      Field("ramp", "Of a trapezoid: share of the duration in which it speeds up, and as long in which it slows down.")
          .written(motion.law == DriverMotion::Law::trapezoid && motion.ramp != DriverMotion{}.ramp),
      motion.ramp, Number{.least = 0.001, .most = 0.5});
}

void by_table(FieldVisitor& v, DriverMotion& motion) {
  constexpr Number number = {.least = 0, .most = longest_motion};
  const List points = {
      .what = {"timed_shares", "a list of [seconds, share of the turn]"}, .least = 2, .most = most_timed_shares};
  std::vector<std::array<double, 2>> table;
  for (const auto& [time, share] : motion.table) table.push_back({time, share});
  v.required(Field("table",
                   "From [0, 0] to [duration, 1]: a smooth motion from rest to rest through these points, a cubic "
                   "spline."),
             table, points, Pair{.form = "[t, s]", .each = number});
  motion = {.law = DriverMotion::Law::table, .table = {}};
  for (const auto& [time, share] : table) motion.table.push_back({time, share});
}

}  // namespace

static void fields(FieldVisitor& v, DriverMotion& motion) {
  const std::array alternatives = {
      Alternative{{"table"}, {}, [&](FieldVisitor& to) { by_table(to, motion); }},
      Alternative{{"law", "duration_s"}, {}, [&](FieldVisitor& to) { by_law(to, motion); }}};
  constexpr std::string_view sentence = "a motion has either a \"law\" with its \"duration_s\" or a \"table\"";
  v.object({.name = "driver_motion"}, [&](FieldVisitor& to) {
    to.one_of(motion.law == DriverMotion::Law::table ? 0 : 1, alternatives,
              {"one_motion", sentence, "one_motion", sentence});
  });
}

namespace {

Names<ReadOut> all_read_outs() {
  Names<ReadOut> names;
  for (std::size_t k = 0; k < read_outs; ++k) names.choices.push_back(static_cast<ReadOut>(k));
  names.name = "read_out";
  return names;
}

}  // namespace

static void fields(FieldVisitor& v, LoadCase& of) {
  v.object({.name = "load_case"}, [&](FieldVisitor& to) {
    to.required(Field("name").missing("\"name\": \"cold\""), of.name);
    to.optional("temperature_C", of.temperature, Number{.least = -273.15, .most = 1000, .above = true});
    to.optional(
        Field("slope_deg", "Of the ground, rising to the right: gravity turns clockwise by it.").written(of.slope != 0),
        of.slope, Number{.least = -180, .most = 180, .is_angle = true});
    to.optional(Field("extra", "Loads that act in it, by name.").written(!of.extra.empty()), of.extra,
                List{.what = {"names", "a list of names"}, .most = most_extra_loads});
    to.optional(
        Field("spring_percent", "Of the springs' forces: what is left of them.").written(of.spring_percent != 100),
        of.spring_percent, Number{.least = 0, .most = 1000});
    to.optional(Field("gas_exponent", "1 where the gas keeps its temperature, up to 1.4 where it moves too fast.")
                    .written(of.gas_exponent != 1),
                of.gas_exponent, Number{.least = 1, .most = 1.67});
    to.optional(Field("for", "The read-outs for which it counts; none: all.").written(!of.counts_for.empty()),
                of.counts_for, List{.what = {"read_outs", "a list of read-outs"}, .most = read_outs}, all_read_outs());
  });
}

namespace {

void link_masses(FieldVisitor& v, Loads& loads) {
  v.object({.name = "link_masses"}, [&](FieldVisitor& to) {
    to.given("input", loads.input);
    to.given("coupler", loads.coupler);
    to.given("output", loads.output);
  });
}

}  // namespace

void fields(FieldVisitor& v, Loads& loads) {
  const Object described = {"loads", "What acts on the linkage: weights, forces, springs, a hand or a drive.", true};
  v.object(described, [&](FieldVisitor& to) {
    to.optional(Field("gravity").null_for_none(), loads.gravity);
    to.given(Field("body", "What the body on the coupler weighs."), loads.body);
    const bool has_links = loads.input || loads.coupler || loads.output;
    to.member(Field("links", "What the links weigh.").absent(!has_links), false,
              [&](FieldVisitor& in) { link_masses(in, loads); });
    to.optional(Field("extra", "Snow, a tool, a cutting force.").written(!loads.extra.empty()), loads.extra,
                List{.what = {"extra_loads", "a list of loads"}, .most = most_extra_loads});
    to.given(Field("handle", "Where the hand takes hold."), loads.handle);
    to.optional(Field("springs").written(!loads.springs.empty()), loads.springs,
                List{.what = {"springs", "a list of springs"}, .most = most_springs});
    to.given(Field("pins", "All alike, with friction."), loads.pins);
    to.member(Field("drive", "What moves and holds the linkage."), false, [&](FieldVisitor& in) { drive(in, loads); });
    to.optional(
        Field("rpm", "Of the driver at a steady speed: adds the forces of inertia.").written(loads.rpm.has_value()),
        loads.rpm, Number{.least = 0, .most = 1e6});
    to.given(Field("motion",
                   "In place of rpm: how the input link goes from position 1 to the last one in time, which adds the "
                   "forces of inertia. Closing is the same backwards."),
             loads.motion);
    to.optional(Field("cases").written(!loads.cases.empty()), loads.cases,
                List{.what = {"load_cases", "a list of cases"}, .most = most_load_cases});
    to.optional(Field("stations", "Of the travel of each linkage of a map, the positions among them.")
                    .written(loads.stations != Loads{}.stations),
                loads.stations, Whole{2, most_stations});
    to.check([&] { return mistakes_in(loads); });
  });
}

}  // namespace linkwright
