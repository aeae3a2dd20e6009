#include "load_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <optional>

#include "linkwright/analyses/load_study.hpp"
#include "linkwright/mechanism/pose.hpp"

namespace linkwright::soak {
namespace {

using nlohmann::json;
using Wrongs = std::vector<std::string>;

constexpr double rounding_of_forces = 1e-6;

/// Of forces of a case, below which a difference is rounding.
double slack_of(const std::vector<LoadStation>& curve) {
  double largest = 1e-9;
  for (const LoadStation& station : curve)
    for (const auto& force : {station.open, station.close, station.frictionless})
      if (force) largest = std::max(largest, std::abs(*force));
  return rounding_of_forces * largest;
}

/// What is said of a whole travel, by the forces at its stations. A hand that pulls another way than its point goes may
/// have to push where it pulls.
void check_peaks(const CaseReport& of, const std::vector<LoadStation>& curve, bool along_the_way, Wrongs& wrongs) {
  const double slack = slack_of(curve);
  const auto above = [&](const std::optional<double>& peak, const std::optional<double>& force, const char* what) {
    if (peak && force && *force > *peak + slack)
      wrongs.push_back(fmt::format("{} of {} is {} at a station, above its peak of {}", what, of.name, *force, *peak));
  };
  // Where a hand goes against its direction, a peak is told the way that it goes, and a station as the hand is given.
  const auto same = [&](const std::optional<double>& told, const std::optional<double>& force, const char* what) {
    if (!told || !force) return;
    const double apart = along_the_way ? *told - *force : std::abs(*told) - std::abs(*force);
    if (std::abs(apart) > slack)
      wrongs.push_back(fmt::format("{} of {} is told as {}, and is {}", what, of.name, *told, *force));
  };
  for (const LoadStation& station : curve) {
    if (along_the_way) above(of.max_open_force, station.open, "opening");
    if (along_the_way) above(of.max_close_force, station.close, "closing");
    if (along_the_way && station.open && station.close && *station.open + *station.close < -slack)
      wrongs.push_back("friction of " + of.name + " does work");
  }
  const auto negative = [](const std::optional<double>& force) {
    return force ? std::optional(-*force) : std::nullopt;
  };
  same(of.hold_open, negative(curve.back().open), "what holds open");
  same(of.close_start, curve.back().close, "what starts to close");
  same(of.pop_up, negative(curve.front().open), "what pops up");
}

/// Forces rise without end there, faster than steps follow.
bool bottoms(const CaseReport& of) {
  return std::any_of(of.springs.begin(), of.springs.end(),
                     [](const SpringUse& use) { return use.bottoms_at || (use.stroke_left && *use.stroke_left <= 0); });
}

/// ∫ y dx by Simpson's rule over pairs of equal steps.
template <class X, class Y>
double integral(const std::vector<LoadStation>& curve, const X& x, const Y& y) {
  double sum = 0;
  for (std::size_t i = 0; i + 2 < curve.size(); i += 2)
    sum += (x(curve[i + 2]) - x(curve[i])) / 6 * (y(curve[i]) + 4 * y(curve[i + 1]) + y(curve[i + 2]));
  return sum;
}

/// The torque's work is the energy's change: of the crank whose turn tells the place. `sense`: 0 where it may turn
/// either way.
void check_work(const LoadCase& of, const std::vector<LoadStation>& curve, double sense, Wrongs& wrongs) {
  const bool told = std::all_of(curve.begin(), curve.end(), [](const auto& at) { return at.torque && at.energy; });
  if (!told) return;
  const double work = (sense == 0 ? 1 : sense) * integral(
                                                     curve, [](const LoadStation& at) { return at.at.driver_turn; },
                                                     [](const LoadStation& at) { return *at.torque; });
  double largest = 0, lowest = 0, highest = 0;
  for (const LoadStation& at : curve) {
    largest = std::max(largest, std::abs(*at.torque));
    lowest = std::min(lowest, *at.energy), highest = std::max(highest, *at.energy);
  }
  const double change = *curve.back().energy - *curve.front().energy;
  const double scale = std::max(highest - lowest, largest * std::abs(curve.back().at.driver_turn));
  constexpr double of_steps = 2e-2;  // torques that rise steeply near a dead point
  const double apart = std::min(std::abs(work - change), sense == 0 ? std::abs(work + change) : INFINITY);
  if (apart > of_steps * scale)
    wrongs.push_back(fmt::format("the torque of {} does {} of work for {} of energy", of.name, work, change));
}

// ---- energies at the positions, by what stands in the file ----------------------------------------------------------

Point place_of(const json& pair) { return {pair[0].get<double>(), pair[1].get<double>()}; }

/// A listed linkage in a pose of its task.
struct Placed {
  Pose pose;
  Point input_ground, input_moving, output_ground, output_moving;

  [[nodiscard]] Point place(LoadedBody on, Point at) const {
    const auto along = [&](Point from, Point to) { return from + (to - from) / std::abs(to - from) * at; };
    switch (on) {
      case LoadedBody::ground:
        return at;
      case LoadedBody::body:
        return pose.origin + direction(pose.angle) * at;
      case LoadedBody::input:
        return along(input_ground, input_moving);
      case LoadedBody::output:
        return along(output_ground, output_moving);
      case LoadedBody::coupler:
        break;
    }
    return along(input_moving, output_moving);
  }
};

Placed placed(const json& entry, const Pose& first, const Pose& pose) {
  const auto moved = [&](const char* side) { return displaced(place_of(entry[side]["circle_point"]), first, pose); };
  return {pose, place_of(entry["input"]["center_point"]), moved("input"), place_of(entry["output"]["center_point"]),
          moved("output")};
}

/// Masses and fixed forces, joules; nothing where a force turns with its body.
std::optional<double> weight_energy(const Loads& loads, const LoadCase& of, const Placed& at) {
  const double metres = metres_of(loads);
  Point gravity{};
  if (loads.gravity) gravity = std::polar(loads.gravity->acceleration, loads.gravity->direction - of.slope);
  double energy = 0;
  const auto add = [&](Point force, Point place) { energy -= (std::conj(force) * place).real() * metres; };
  if (loads.body) add(loads.body->mass * gravity, at.place(LoadedBody::body, loads.body->center));
  const auto link = [&](const std::optional<LinkMass>& mass, LoadedBody on, Point from, Point to) {
    if (!mass) return;
    const double length = std::abs(to - from);
    const double kilograms = mass->mass ? *mass->mass : *mass->kg_per_m * length * metres;
    add(kilograms * gravity, at.place(on, mass->center.value_or(length / 2)));
  };
  link(loads.input, LoadedBody::input, at.input_ground, at.input_moving);
  link(loads.output, LoadedBody::output, at.output_ground, at.output_moving);
  link(loads.coupler, LoadedBody::coupler, at.input_moving, at.output_moving);
  for (const ExtraLoad& extra : loads.extra) {
    if (!acts_in(extra, of)) continue;
    if (extra.turns_with_body) return std::nullopt;
    add(extra.mass ? *extra.mass * gravity : extra.force, at.place(extra.at.on, extra.at.at));
  }
  return energy;
}

struct Work {
  double energy = 0, error = 0;  ///< at most so much, where forces rise or fall within each step
};
/// What springs take up, by their forces and lengths at the stations.
Work spring_work(const Loads& loads, const std::vector<LoadStation>& curve) {
  Work work;
  for (std::size_t k = 0; k < loads.springs.size(); ++k)
    for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
      const auto &a = curve[i].springs[k], &b = curve[i + 1].springs[k];
      const double way = loads.springs[k].count * (b->length - a->length) * metres_of(loads);
      work.energy -= (a->force + b->force) / 2 * way;
      work.error += std::abs((b->force - a->force) / 2 * way);
    }
  return work;
}

void check_energy(const Loads& loads, const LoadCase& of, const std::vector<LoadStation>& curve, const json& entry,
                  const std::vector<PrescribedPose>& poses, Wrongs& wrongs) {
  const bool has_torsion = std::any_of(loads.springs.begin(), loads.springs.end(), [](const Spring& spring) {
    return std::holds_alternative<TorsionSpring>(spring.law);
  });
  const bool at_infinity = [&] {
    for (const char* side : {"input", "output"})
      if (entry[side]["center_point"].is_null() || entry[side]["circle_point"].is_null()) return true;
    return false;
  }();
  if (has_torsion || at_infinity || !curve.back().energy || !curve.front().energy) return;
  const auto before = weight_energy(loads, of, placed(entry, poses.front().pose, poses.front().pose)),
             after = weight_energy(loads, of, placed(entry, poses.front().pose, poses.back().pose));
  if (!before || !after) return;
  const Work of_springs = spring_work(loads, curve);
  const double expected = *after - *before + of_springs.energy, told = *curve.back().energy - *curve.front().energy;
  const double slack = 1e-6 * std::max(std::abs(*before), std::abs(*after)) + of_springs.error + 1e-12;
  if (std::abs(expected - told) > slack)
    wrongs.push_back(fmt::format("the energy of {} changes by {}, not by {}", of.name, told, expected));
}

// ---- what is required -----------------------------------------------------------------------------------------------

void check_limits(const json& wanted, const json& worst, Wrongs& wrongs) {
  const auto check = [&](const char* key, const char* read_out, double sign) {
    const auto limit = wanted.find(key);
    if (limit == wanted.end() || limit->is_null()) return;
    if (!worst.contains(read_out))
      return wrongs.push_back(fmt::format("listed without the {} that is limited", read_out));
    const double value = worst[read_out]["value"], most = limit->get<double>();
    if (sign * (value - most) > rounding_of_forces * std::max(std::abs(most), std::abs(value)))
      wrongs.push_back(fmt::format("{} is {} where {} is {}", read_out, value, key, most));
  };
  check("max_open_force", "max_open_force", 1);
  check("max_close_force", "max_close_force", 1);
  check("max_pin_force", "max_pin_force", 1);
  check("max_torque", "max_torque", 1);
  check("min_hold_open", "hold_open", -1);
  check("max_cylinder_force", "cylinder_force", 1);
  check("max_self_rise_deg", "self_rise", 1);
  if (wanted.value("min_self_close_deg", 0.0) > 0) check("min_self_close_deg", "self_close", -1);
}

std::optional<double> worth_by_loads(const json& entry, const std::string& objective) {
  if (entry["loads"].is_null()) return std::nullopt;
  if (objective == "best_F1")
    return entry["loads"].contains("best_F1") ? std::optional(-entry["loads"]["best_F1"].get<double>()) : std::nullopt;
  const bool most = objective == "hold_open" || objective == "self_close";
  const std::string read_out = objective == "pin_force" ? "max_pin_force"
                               : objective == "torque"  ? "max_torque"
                                                        : objective;
  if (!entry["loads"]["worst"].contains(read_out)) return std::nullopt;
  const double value = entry["loads"]["worst"][read_out]["value"];
  return most ? value : -value;
}

void check_order_by_loads(const json& options, const json& linkages, Wrongs& wrongs) {
  const std::string objective = options.value("objective", "");
  constexpr std::array by_loads = {"hand_force", "hold_open", "pin_force",  "torque",
                                   "best_F1",    "self_rise", "self_close", "cylinder_force"};
  if (options.contains("pareto") || std::find(by_loads.begin(), by_loads.end(), objective) == by_loads.end()) return;
  double before = INFINITY;
  for (const json& entry : linkages) {
    const double worth = worth_by_loads(entry, objective).value_or(-INFINITY);
    if (worth > before + rounding_of_forces * std::abs(worth))
      wrongs.push_back("the linkages are not listed best first");
    before = worth;
  }
}

/// Torques rise there and fall again between two stations; or it has a defect.
bool is_by_dead_point(const json& entry) {
  const json angle = entry.value("min_transmission_angle_deg", json(90.0));
  return angle.is_null() || angle.get<double>() < 1;
}

/// It has been, from the first position to the last.
bool is_driven(const json& entry) { return entry["drive"].is_string() && entry["verified_by_driving"].get<bool>(); }

}  // namespace

std::vector<std::string> wrongs_of_loads(const Problem& problem, const Answer& answer, const json& result) {
  Wrongs wrongs;
  const auto& loads = problem.options.loads;
  const json& linkages = result["linkages"];
  for (std::size_t place = 0; place < linkages.size(); ++place) {
    const json& entry = linkages[place];
    if (entry.contains("loads") != loads.has_value()) wrongs.push_back("loads are told where they are given");
    if (!loads) continue;
    if (entry["loads"].is_null()) {
      if (is_driven(entry)) wrongs.push_back("driven through its positions, and without forces");
      continue;
    }
    check_limits(result["problem"]["requirements"], entry["loads"]["worst"], wrongs);
    constexpr int between = 40;
    const LoadStudy study = load_study(problem, answer, place, between);
    const std::vector<LoadCase> cases = cases_of(*loads);
    const bool along_the_way = loads->handle && loads->handle->direction == Handle::Direction::tangential;
    const double sense = entry["drive"] == "cw" ? -1 : entry["drive"] == "ccw" ? 1 : 0;
    for (std::size_t k = 0; k < cases.size(); ++k) {
      check_peaks(study.report.cases[k], study.curves[k], along_the_way, wrongs);
      if (bottoms(study.report.cases[k])) continue;
      if (loads->drive != LoadDrive::output && !is_by_dead_point(entry) && !has_inertia(*loads))
        check_work(cases[k], study.curves[k], sense, wrongs);
      if (const auto* motion = std::get_if<MotionTask>(&problem.task); motion && !motion->relaxed)
        check_energy(study.loads, cases[k], study.curves[k], entry, motion->poses, wrongs);
    }
  }
  if (loads && wrongs.empty()) check_order_by_loads(result["problem"]["options"], linkages, wrongs);
  return wrongs;
}

}  // namespace linkwright::soak
