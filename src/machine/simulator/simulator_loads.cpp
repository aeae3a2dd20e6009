#include "machine/simulator/simulator_loads.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/number_text.hpp"
#include "linkwright/loads/load_report.hpp"
#include "loads/carried.hpp"
#include "loads/gas_law.hpp"
#include "machine/unlike_names.hpp"

namespace linkwright {
namespace {

constexpr double no_length = 1e6;  // m: longer than any spring

Vector3 spatial(Point p) { return {p.real(), p.imag(), 0}; }

/// Of a mass at a point; a plate's by its inertia about z, where none is given a small ball's, which simulators need.
MassProperties lump(double mass, Vector3 at, double inertia, double size) {
  const double ball = mass * std::pow(0.02 * size, 2), flat = inertia > 0 ? inertia / 2 : ball;
  return {mass, at, Matrix3x3::of_columns({flat, 0, 0}, {0, flat, 0}, {0, 0, inertia > 0 ? inertia : ball})};
}

class LoadsOfCase {
 public:
  LoadsOfCase(const LinkageLoads& on, double metre)
      : on_(on), loads_(on.loads), case_(cases_of(on.loads).front()), metre_(metre) {}

  SimulatorLoads build() {
    found_.remark = fmt::format("What acts on it: the case \"{}\" of its loads", case_.name);
    found_.gravity = spatial(gravity_in(loads_, case_));
    for (const CarriedMass& mass : masses_in(loads_, case_, on_.bars)) add_mass(mass);
    for (const ExtraLoad& extra : loads_.extra)
      if (!extra.mass && acts_in(extra, case_)) add_force(extra);
    const auto report = load_report(loads_, on_.bars, on_.poses);
    for (std::size_t k = 0; k < loads_.springs.size(); ++k) add_spring(k, report);
    return std::move(found_);
  }

 private:
  [[nodiscard]] const Pose& body() const { return on_.poses.front().pose; }
  [[nodiscard]] SimulatorLoads::Stud stud(const CarriedPoint& point) const {
    return {moving_body(point.on), metre_ * spatial(place_of(point, on_.bars, body()))};
  }
  [[nodiscard]] double size() const { return metre_ * on_.bars.lengths().perimeter() / 4; }

  void add_mass(const CarriedMass& mass) {
    const auto at = stud(mass.at);
    if (!(mass.mass > 0 || mass.inertia > 0) || at.body == 0) return;
    auto& matter = found_.matter[static_cast<std::size_t>(at.body)];
    // No simulator turns what has no mass: it gets one that its inertia makes nothing of.
    constexpr double little = 1e-6;
    const double least = little * mass.inertia / (size() * size());
    const MassProperties lumped = lump(std::max(mass.mass, least), at.at, mass.inertia, size());
    matter = matter ? *matter + lumped : lumped;
  }

  void add_force(const ExtraLoad& extra) {
    const bool turns = extra.turns_with_body && extra.at.on != LoadedBody::ground;
    const Point force = turns ? extra.force * frame_of(extra.at.on, on_.bars, body()).axis : extra.force;
    found_.forces.push_back({names_.unlike_others(extra.name), stud(extra.at), spatial(force), turns});
  }

  void add_spring(std::size_t k, const std::optional<LoadReport>& report) {
    const Spring& spring = loads_.springs[k];
    const double scale = case_.spring_percent / 100 * spring.count;
    if (const auto* torsion = std::get_if<TorsionSpring>(&spring.law)) {
      // Both are told in N·m; the first torque by its rate, however small, is where the spring rests.
      const double rate = std::max(degrees(torsion->rate_per_degree), 1e-6 * std::abs(torsion->torque_at_position_1));
      if (rate > 0) found_.hinges.push_back({torsion->joint, scale * rate, torsion->torque_at_position_1 / rate});
      return;
    }
    SimulatorLoads::Line line;
    line.name = names_.unlike_others(spring_name(loads_, k));
    line.from = stud(spring.from);
    line.to = stud(spring.to);
    if (const auto* gas = std::get_if<GasSpring>(&spring.law))
      set_gas(line, *gas, spring, scale, report);
    else
      set_coil(line, std::get<CoilSpring>(spring.law), scale);
    found_.lines.push_back(std::move(line));
  }

  void set_coil(SimulatorLoads::Line& line, const CoilSpring& coil, double scale) const {
    line.stiffness = scale * coil.rate / metre_;
    const double free = metre_ * coil.free_length;
    line.slack = {coil.acts == CoilSpring::Acts::tension ? 0 : free,
                  coil.acts == CoilSpring::Acts::compression ? no_length : free};
  }

  /// Over the lengths used the straight line that is nearest to the force everywhere: the chord of a convex curve, let
  /// down by half of their largest distance.
  void set_gas(SimulatorLoads::Line& line, const GasSpring& gas, const Spring& of, double scale,
               const std::optional<LoadReport>& report) const {
    const std::string& told = of.name.empty() ? line.name : of.name;
    double low = gas.extended_length - gas.stroke, high = gas.extended_length;
    if (report)
      for (const SpringUse& use : report->cases.front().springs)
        if (use.name == told) low = use.shortest, high = use.longest;
    const GasLaw law(gas, 0.005 / metre_);
    const GasLaw::State state{GasLaw::heat(gas, case_.temperature), 1, 0};
    const auto force = [&](double length) { return scale * law.force(gas.extended_length - length, state); };
    const double slope = high > low ? (force(high) - force(low)) / (high - low) : 0;
    double gap = 0;
    constexpr int looked_at = 200;
    for (int i = 0; i <= looked_at; ++i) {
      const double length = low + (high - low) * i / looked_at;
      gap = std::max(gap, force(low) + slope * (length - low) - force(length));
    }
    line.push = std::array{force(low) - slope * low - gap / 2, slope / metre_};
    line.friction = of.count * law.friction((gas.extended_length - (low + high) / 2));
    line.remark = fmt::format("{}: a gas spring; a straight line stands for its force, {} N off at most", line.name,
                              significant_text(gap / 2, 2));
  }

  const LinkageLoads& on_;
  const Loads& loads_;
  LoadCase case_;
  double metre_;
  UnlikeNames names_{{"motor"}};  ///< of tendons and actuators
  SimulatorLoads found_;
};

}  // namespace

SimulatorLoads simulator_loads(const LinkageLoads& on, double metre) { return LoadsOfCase(on, metre).build(); }

}  // namespace linkwright
