#include "linkwright/loads/loads.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "core/number_check.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/loads/spring_charge.hpp"

namespace linkwright {
namespace {

/// What is wrong with a block, place by place.
class LoadMistakes {
 public:
  explicit LoadMistakes(const Loads& loads) : loads_(loads) {}

  [[nodiscard]] std::vector<Error> all() {
    at_most(loads_.extra.size(), most_extra_loads, "loads.extra");
    at_most(loads_.springs.size(), most_springs, "loads.springs");
    at_most(loads_.cases.size(), most_load_cases, "loads.cases");
    gravity();
    masses();
    extra();
    if (loads_.handle) handle(*loads_.handle);
    for (std::size_t k = 0; k < loads_.springs.size(); ++k)
      spring(loads_.springs[k], fmt::format("loads.springs[{}]", k));
    free_strength();
    if (loads_.pins) {
      range(loads_.pins->radius, 0, largest_coordinate, "loads.pins.radius");
      range(loads_.pins->friction, 0, 2, "loads.pins.friction");
    }
    drive();
    cases();
    if (loads_.stations < 2 || loads_.stations > most_stations)
      outside(loads_.stations, 2, most_stations, "loads.stations");
    return std::move(found_);
  }

 private:
  void add(const char* code, std::string place, std::string message, Values values = {}) {
    found_.push_back({code, std::move(place), std::move(message), std::move(values)});
  }
  void outside(double value, double least, double most, const std::string& place) {
    add("load_range", place, fmt::format("{} is not within {} to {}", value, least, most),
        {{"value", value}, {"least", least}, {"most", most}});
  }
  void range(double value, double least, double most, const std::string& place) {
    if (!(value >= least && value <= most)) outside(value, least, most, place);
  }
  void at_most(std::size_t count, std::size_t most, const std::string& place) {
    if (count > most)
      add("load_too_many", place, fmt::format("these are {}, and at most {} are taken", count, most),
          {{"count", count}, {"most", most}});
  }
  void positive(double value, const std::string& place) {
    if (!(value > 0 && value <= largest_coordinate))
      add("load_positive", place, fmt::format("{} is to be a number above 0", value), {{"value", value}});
  }
  void point(Point value, const std::string& place) {
    check_number(value.real(), "a coordinate", place, found_);
    check_number(value.imag(), "a coordinate", place, found_);
  }
  void needs_unit(const std::string& place) {
    if (!loads_.metres)
      add("load_unit", place, "needs a length unit that is known: \"length_unit\": \"mm\" (mm, cm, m, in, …)");
  }

  void gravity() {
    if (!loads_.gravity) return;
    check_angle(loads_.gravity->direction, "an angle", "loads.gravity.direction_deg", found_);
    range(loads_.gravity->acceleration, 0, largest_coordinate, "loads.gravity.acceleration");
  }

  void masses() {
    if (loads_.body) {
      range(loads_.body->mass, 0, largest_coordinate, "loads.body.mass");
      point(loads_.body->center, "loads.body.center");
      range(loads_.body->inertia, 0, largest_coordinate, "loads.body.inertia");
    }
    link(loads_.input, "loads.links.input");
    link(loads_.coupler, "loads.links.coupler");
    link(loads_.output, "loads.links.output");
  }
  void link(const std::optional<LinkMass>& given, const std::string& place) {
    if (!given) return;
    if (given->mass) range(*given->mass, 0, largest_coordinate, place + ".mass");
    if (given->kg_per_m) {
      range(*given->kg_per_m, 0, largest_coordinate, place + ".kg_per_m");
      needs_unit(place + ".kg_per_m");
    }
    if (given->center) point(*given->center, place + ".center");
    if (given->inertia) range(*given->inertia, 0, largest_coordinate, place + ".inertia");
  }

  void extra() {
    for (std::size_t k = 0; k < loads_.extra.size(); ++k) {
      const ExtraLoad& load = loads_.extra[k];
      const std::string place = fmt::format("loads.extra[{}]", k);
      const auto same = [&](const ExtraLoad& other) { return other.name == load.name; };
      if (std::any_of(loads_.extra.begin(), loads_.extra.begin() + static_cast<std::ptrdiff_t>(k), same))
        twice(load.name, place);
      if (load.at.on == LoadedBody::ground)
        add("load_on_ground", place + ".on", "a load on the ground moves nothing; put it on \"body\" or a link");
      point(load.at.at, place + ".at");
      if (load.mass) range(*load.mass, 0, largest_coordinate, place + ".mass");
      if (!load.mass) point(load.force, place + ".force");
    }
  }
  void twice(const std::string& name, const std::string& place) {
    add("load_name_twice", place + ".name", fmt::format("the name \"{}\" is there already; give each its own", name),
        {{"name", name}});
  }

  void handle(const Handle& handle) {
    point(handle.point, "loads.handle.point");
    check_angle(handle.angle, "an angle", "loads.handle.direction.fixed_deg", found_);
    const bool is_weightless = !loads_.gravity || loads_.gravity->acceleration == 0;
    if (handle.direction == Handle::Direction::vertical && is_weightless)
      add("vertical_without_gravity", "loads.handle.direction",
          "\"vertical\" is against gravity, and there is none; say \"tangential\" or {\"fixed_deg\": 90}");
  }

  [[nodiscard]] static bool is_one_body(LoadedBody a, LoadedBody b) {
    const auto rigid = [](LoadedBody body) { return body == LoadedBody::coupler ? LoadedBody::body : body; };
    return rigid(a) == rigid(b);
  }
  void between(const CarriedPoint& from, const CarriedPoint& to, const std::string& place) {
    point(from.at, place + ".from.at");
    point(to.at, place + ".to.at");
    if (is_one_body(from.on, to.on))
      add("spring_to_itself", place, "both ends are on one body, which feels nothing of it; put them on two bodies");
  }

  void spring(const Spring& spring, const std::string& place) {
    const auto same = [&](const Spring& other) { return &other < &spring && other.name == spring.name; };
    if (!spring.name.empty() && std::any_of(loads_.springs.begin(), loads_.springs.end(), same))
      twice(spring.name, place);
    if (spring.count < 1 || spring.count > 1000) outside(spring.count, 1, 1000, place + ".count");
    if (const auto* torsion = std::get_if<TorsionSpring>(&spring.law)) {
      range(torsion->rate_per_degree, 0, largest_coordinate, place + ".rate_per_deg");
      check_number(torsion->torque_at_position_1, "a torque", place + ".torque_at_position_1", found_);
      return;
    }
    between(spring.from, spring.to, place);
    if (const auto* coil = std::get_if<CoilSpring>(&spring.law)) {
      range(coil->rate, 0, largest_coordinate, place + ".rate");
      range(coil->free_length, 0, largest_coordinate, place + ".free_length");
    }
    if (const auto* gas = std::get_if<GasSpring>(&spring.law)) gas_spring(*gas, place);
  }

  void gas_spring(const GasSpring& gas, const std::string& place) {
    const std::size_t before = found_.size();
    positive(gas.extended_length, place + ".extended_length");
    positive(gas.stroke, place + ".stroke");
    positive(gas.f1, place + ".F1");
    positive(gas.f2, place + ".F2");
    if (gas.f3) positive(*gas.f3, place + ".F3");
    if (gas.f4) positive(*gas.f4, place + ".F4");
    range(gas.friction, 0, largest_coordinate, place + ".friction");
    range(gas.rod_diameter, 0, 1000, place + ".rod_diameter");
    if (gas.percent_per_10K) range(*gas.percent_per_10K, 0, 20, place + ".percent_per_10K");
    if (gas.measured_at) range(*gas.measured_at, 0, largest_coordinate, place + ".measured_at");
    if (!gas.measured_at) needs_unit(place + ".measured_at");
    if (found_.size() == before) forces_of(gas, place);
  }
  void forces_of(const GasSpring& gas, const std::string& place) {
    if (gas.f2 < gas.f1)
      add("gas_forces", place + ".F2", "F2, near the compressed end, is at least F1, near the extended one");
    if (gas.f3.has_value() != gas.f4.has_value())
      add("gas_compressing_pair", place, "F3 and F4 go together; give both, or \"friction\" in place of them");
    if (gas.f3 && gas.friction != 0)
      add("gas_friction_twice", place + ".friction", "F3 and F4 say what the friction is; leave one of the two out");
    if ((gas.f3 && *gas.f3 < gas.f1) || (gas.f4 && *gas.f4 < gas.f2))
      add("gas_compressing", place, "compressing takes more than extending gives: F3 is at least F1, F4 at least F2");
    if (gas.stroke >= gas.extended_length)
      add("gas_stroke", place + ".stroke", "the stroke is shorter than the extended length");
    const double measured_at = gas.measured_at.value_or(loads_.metres ? 0.005 / *loads_.metres : 0);
    if (2 * measured_at >= gas.stroke)
      add("gas_measured_at", place + ".measured_at",
          "the forces are measured this far before both ends, which is less than half of the stroke");
  }

  void free_strength() {
    const auto free = free_spring(loads_);
    if (!free) return;
    const FreeStrength& strength = *std::get<GasSpring>(loads_.springs[*free].law).free;
    const std::string place = fmt::format("loads.springs[{}].best_F1", *free);
    range(strength.max_f1, least_f1, largest_coordinate, place + ".max_F1");
    if (strength.min_f1) range(*strength.min_f1, 0, strength.max_f1, place + ".min_F1");
    if (strength.min_hold_open) check_number(*strength.min_hold_open, "a force", place + ".min_hold_open", found_);
    const auto is_free = [](const Spring& spring) {
      const auto* gas = std::get_if<GasSpring>(&spring.law);
      return gas && gas->free;
    };
    if (std::count_if(loads_.springs.begin(), loads_.springs.end(), is_free) > 1)
      add("one_free_spring", place, "one spring at most leaves its strength free; give the others their F1");
    if (!loads_.handle)
      add("free_without_hand", place,
          "the best strength is that with the least force of a hand; say where it takes hold: \"handle\": "
          "{\"point\": [x, y]}");
    const std::vector<LoadCase> cases = cases_of(loads_);
    if (std::none_of(cases.begin(), cases.end(), [](const LoadCase& of) { return of.counts(ReadOut::hand_force); }))
      add("free_without_case", place, "no case counts for \"hand_force\", by which the best strength is told");
  }

  void drive() {
    if (loads_.drive == LoadDrive::hand && !loads_.handle)
      add("no_handle", "loads.handle",
          "say where the hand takes hold: \"handle\": {\"point\": [x, y]}, or drive by \"input\", \"output\" or a "
          "cylinder");
    if (loads_.drive == LoadDrive::cylinder) between(loads_.cylinder.from, loads_.cylinder.to, "loads.drive.cylinder");
    if (loads_.rpm) {
      range(*loads_.rpm, 0, 1e6, "loads.rpm");
      needs_unit("loads.rpm");
    }
    if (loads_.motion) motion(*loads_.motion);
  }

  void motion(const DriverMotion& motion) {
    if (loads_.rpm)
      add("motion_and_rpm", "loads.motion",
          "\"rpm\" and \"motion\" both say how fast the driver goes; give one of them");
    needs_unit("loads.motion");
    auto mistakes = mistakes_in(motion);
    found_.insert(found_.end(), mistakes.begin(), mistakes.end());
  }

  void cases() {
    for (std::size_t k = 0; k < loads_.cases.size(); ++k) {
      const LoadCase& of = loads_.cases[k];
      const std::string place = fmt::format("loads.cases[{}]", k);
      const auto same = [&](const LoadCase& other) { return &other < &of && other.name == of.name; };
      if (std::any_of(loads_.cases.begin(), loads_.cases.end(), same)) twice(of.name, place);
      if (!(of.temperature > -273.15 && of.temperature <= 1000))
        outside(of.temperature, -273.15, 1000, place + ".temperature_C");
      range(of.slope, -pi, pi, place + ".slope_deg");
      range(of.spring_percent, 0, 1000, place + ".spring_percent");
      range(of.gas_exponent, 1, 1.67, place + ".gas_exponent");
      at_most(of.extra.size(), most_extra_loads, place + ".extra");
      at_most(of.counts_for.size(), read_outs, place + ".for");
      for (std::size_t i = 0; i < of.extra.size(); ++i) known(of.extra[i], fmt::format("{}.extra[{}]", place, i));
    }
  }
  void known(const std::string& name, const std::string& place) {
    const auto is_it = [&](const ExtraLoad& extra) { return extra.name == name; };
    if (std::none_of(loads_.extra.begin(), loads_.extra.end(), is_it))
      add("unknown_extra", place, fmt::format("there is no load \"{}\" in \"extra\"", name), {{"name", name}});
  }

  const Loads& loads_;
  std::vector<Error> found_;
};

}  // namespace

std::optional<std::size_t> free_spring(const Loads& loads) {
  for (std::size_t k = 0; k < loads.springs.size(); ++k)
    if (const auto* gas = std::get_if<GasSpring>(&loads.springs[k].law); gas && gas->free) return k;
  return std::nullopt;
}

std::string spring_name(const Loads& loads, std::size_t spring) {
  const std::string& given = loads.springs[spring].name;
  return given.empty() ? fmt::format("spring_{}", spring + 1) : given;
}

bool acts_in(const ExtraLoad& extra, const LoadCase& of) {
  return extra.always || std::find(of.extra.begin(), of.extra.end(), extra.name) != of.extra.end();
}

bool LoadCase::counts(ReadOut read_out) const {
  return counts_for.empty() || std::find(counts_for.begin(), counts_for.end(), read_out) != counts_for.end();
}

std::vector<LoadCase> cases_of(const Loads& loads) {
  return loads.cases.empty() ? std::vector<LoadCase>{LoadCase{.name = "room"}} : loads.cases;
}

std::vector<Error> mistakes_in(const Loads& loads) { return LoadMistakes(loads).all(); }

}  // namespace linkwright
