#include "machine/simulator/simulator_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <fmt/format.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/length_unit.hpp"
#include "linkwright/files/number_text.hpp"
#include "machine/body_colors.hpp"

namespace linkwright {
namespace {

/// A frame with its x axis along one direction and its z axis along another, at right angles to it.
Displacement frame(Vector3 origin, Vector3 x, Vector3 z) {
  return {Rotation::from_matrix(Matrix3x3::of_columns(x, cross(z, x), z)).value(), origin};
}

Displacement frame(Vector3 origin, Vector3 z) {
  const Vector3 beside = std::abs(z.z) > 0.5 ? Vector3{1, 0, 0} : Vector3{0, 0, 1};
  return frame(origin, normalized(cross(cross(z, beside), z)), z);
}

/// A part in boxes and cylinders, fixed frame, user's unit; without holes.
std::vector<Solid> solids_of(const FlatPlate& plate) {
  std::vector<Solid> solids;
  const double middle = (plate.low + plate.high) / 2, thickness = plate.high - plate.low;
  const auto at = [&](Point point) { return Vector3{point.real(), point.imag(), middle}; };
  const std::size_t corners = plate.outline.size();
  for (const Point corner : plate.outline)
    solids.push_back({Displacement::translated(at(corner)), SolidCylinder{plate.radius, thickness}});
  for (std::size_t k = 0; k < (corners == 2 ? 1 : corners); ++k) {
    const Vector3 a = at(plate.outline[k]), b = at(plate.outline[(k + 1) % corners]);
    solids.push_back(
        {frame(0.5 * (a + b), normalized(b - a), {0, 0, 1}), SolidBox{{norm(b - a), 2 * plate.radius, thickness}}});
  }
  return solids;
}

std::vector<Solid> solids_of(const ShellPlate& plate) {
  constexpr double longest = 0.15;
  std::vector<Solid> solids;
  const double middle = (plate.low + plate.high) / 2, thickness = plate.high - plate.low;
  const double radius = middle * std::sin(plate.half_angle);
  for (const Vector3 end : {plate.from, plate.to})
    solids.push_back({frame(middle * end, end), SolidCylinder{radius, thickness}});
  const double arc = angle_between(plate.from, plate.to);
  const int boxes = static_cast<int>(std::ceil(arc / longest));
  const Vector3 normal = normalized(cross(plate.from, plate.to));
  const double length = 2 * middle * std::tan(arc / boxes / 2);
  for (int k = 0; k < boxes; ++k) {
    const double angle = arc * (k + 0.5) / boxes;
    const Vector3 out = std::cos(angle) * plate.from + std::sin(angle) * cross(normal, plate.from);
    solids.push_back({frame(middle * out, cross(normal, out), out), SolidBox{{length, 2 * radius, thickness}}});
  }
  return solids;
}

std::vector<Solid> solids_of(const RoundPin& pin) {
  return {{frame(0.5 * (pin.from + pin.to), normalized(pin.to - pin.from)),
           SolidCylinder{pin.radius, norm(pin.to - pin.from)}}};
}

Solid in_metres(Solid solid, double metre, Vector3 origin) {
  solid.place.translation = metre * solid.place.translation - origin;
  if (auto* box = std::get_if<SolidBox>(&solid.shape)) box->size = metre * box->size;
  if (auto* cylinder = std::get_if<SolidCylinder>(&solid.shape))
    *cylinder = {metre * cylinder->radius, metre * cylinder->length};
  return solid;
}

/// The hinge and the body that each body hangs on, found from the ground outwards, nearest first; −1 of the ground.
struct Hanging {
  int parent = -1;
  std::size_t hinge = 0;
};
std::vector<Hanging> hanging(const MovingLinkage& linkage) {
  std::vector<Hanging> found(linkage.bodies.size());
  std::deque<int> next = {0};
  while (!next.empty()) {
    const int body = next.front();
    next.pop_front();
    for (const std::size_t hinge : linkage.hinges_of(body)) {
      const auto [a, b] = linkage.hinges[hinge].bodies;
      const int other = a == body ? b : a;
      if (other == 0 || found[static_cast<std::size_t>(other)].parent >= 0) continue;
      found[static_cast<std::size_t>(other)] = {body, hinge};
      next.push_back(other);
    }
  }
  return found;
}

class ModelBuilder {
 public:
  ModelBuilder(const Machine& machine, double density)
      : machine_(machine),
        linkage_(machine.linkage),
        density_(density),
        metre_(linkage_.millimetres() / 1000),
        hanging_(hanging(linkage_)),
        place_of_(linkage_.bodies.size()) {}

  SimulatorModel build() {
    set_hinges();
    add_link(0);
    set_loops();
    model_.driver = place_of_[1];
    model_.guided = place_of_[static_cast<std::size_t>(linkage_.guided)];
    model_.guided_point =
        linkage_.traced ? metre_ * *linkage_.traced : model_.links[static_cast<std::size_t>(model_.guided)].origin;
    set_motion();
    model_.remark = remark();
    return std::move(model_);
  }

 private:
  void set_hinges() {
    const double radius = linkage_.spherical ? machine_.sizes.radius : 1;
    model_.size = metre_ * (linkage_.spherical ? radius : linkage_.longest_link());
    for (const Hinge& hinge : linkage_.hinges) {
      model_.hinge_names.push_back(hinge.name);
      model_.hinge_points.push_back(metre_ * radius * hinge.point);
      model_.hinge_axes.push_back(linkage_.spherical ? hinge.point : Vector3{0, 0, 1});
    }
  }

  void add_link(int body) {
    const auto [parent, hinge] = hanging_[static_cast<std::size_t>(body)];
    place_of_[static_cast<std::size_t>(body)] = static_cast<int>(model_.links.size());
    SimulatorLink& link = model_.links.emplace_back();
    link.name = linkage_.bodies[static_cast<std::size_t>(body)];
    link.body = body;
    if (parent >= 0) {
      link.parent = place_of_[static_cast<std::size_t>(parent)];
      link.hinge = hinge;
      link.origin = model_.hinge_points[hinge];
    }
    link.matter = mass_properties(machine_, body, density_);
    if (parent >= 0) model_.mass += link.matter.mass;
    const Rgb colour = body_color(body);
    link.colour.assign(colour.begin(), colour.end());
    for (const Part& part : machine_.parts) {
      if (part.body != body) continue;
      for (const Solid& solid : std::visit([](const auto& shape) { return solids_of(shape); }, part.shape))
        link.solids.push_back(in_metres(solid, metre_, link.origin));
    }
    for (int other = 1; other < static_cast<int>(linkage_.bodies.size()); ++other)
      if (hanging_[static_cast<std::size_t>(other)].parent == body) add_link(other);
  }

  void set_loops() {
    for (std::size_t hinge = 0; hinge < linkage_.hinges.size(); ++hinge) {
      const bool in_tree = std::any_of(model_.links.begin() + 1, model_.links.end(),
                                       [&](const SimulatorLink& link) { return link.hinge == hinge; });
      const auto [first, second] = linkage_.hinges[hinge].bodies;
      if (!in_tree)
        model_.loops.push_back(
            {hinge, place_of_[static_cast<std::size_t>(first)], place_of_[static_cast<std::size_t>(second)]});
    }
  }

  /// The angle of a link's joint, without whole turns, in (−π, π].
  [[nodiscard]] double turn(const SimulatorLink& link, const MovingState& state) const {
    const int parent = model_.links[static_cast<std::size_t>(link.parent)].body;
    const UnitQuaternion q = (state.bodies[static_cast<std::size_t>(parent)].rotation.inverse() *
                              state.bodies[static_cast<std::size_t>(link.body)].rotation)
                                 .quaternion();
    return wrapped(2 * std::atan2(dot(q.v(), model_.hinge_axes[link.hinge]), q.w()));
  }
  static double wrapped(double angle) { return std::remainder(angle, two_pi); }

  /// Joint angles along states of the travel, each continued from the state before.
  [[nodiscard]] std::vector<std::vector<double>> continued(const std::vector<std::size_t>& states) const {
    std::vector<std::vector<double>> rows;
    std::vector<double> now(model_.links.size() - 1, 0);
    for (const std::size_t state : states) {
      for (std::size_t k = 0; k < now.size(); ++k)
        now[k] += wrapped(turn(model_.links[k + 1], linkage_.travel[state]) - now[k]);
      rows.push_back(now);
    }
    return rows;
  }

  /// States of the travel from the first position outwards, back to its beginning and then on to its end.
  [[nodiscard]] std::vector<std::size_t> outwards(bool on) const {
    const MovingState* first = linkage_.at_position(0);
    std::vector<std::size_t> states;
    if (first == nullptr) return states;
    const auto from = static_cast<std::size_t>(first - linkage_.travel.data());
    if (on)
      for (std::size_t k = from; k < linkage_.travel.size(); ++k) states.push_back(k);
    else
      for (std::size_t k = from + 1; k-- > 0;) states.push_back(k);
    return states;
  }

  void add_keys(const std::vector<std::size_t>& states) {
    const auto rows = continued(states);
    for (std::size_t k = 0; k < states.size(); ++k) {
      const auto position = linkage_.travel[states[k]].position;
      const bool is_new = position && std::none_of(model_.keys.begin(), model_.keys.end(),
                                                   [&](const SimulatorKey& key) { return key.position == *position; });
      if (is_new) model_.keys.push_back({*position, rows[k]});
    }
  }

  void set_motion() {
    const std::vector<std::size_t> back = outwards(false), on = outwards(true);
    if (!linkage_.task.empty()) add_keys(linkage_.task);
    add_keys(on);
    add_keys(back);
    std::sort(model_.keys.begin(), model_.keys.end(),
              [](const SimulatorKey& a, const SimulatorKey& b) { return a.position < b.position; });
    auto rows = continued(on);
    const auto others = continued(back);
    rows.insert(rows.end(), others.begin(), others.end());
    const auto driver = static_cast<std::size_t>(model_.driver - 1);
    const auto by_driver = [&](const auto& a, const auto& b) { return a[driver] < b[driver]; };
    const auto ends = std::minmax_element(rows.begin(), rows.end(), by_driver);
    if (!linkage_.full_turn && !rows.empty()) model_.driver_range = {(*ends.first)[driver], (*ends.second)[driver]};
    model_.ratios.emplace_back();
    for (std::size_t k = 0; k + 1 < model_.links.size(); ++k) model_.ratios.push_back(ratio(rows, k, driver));
  }

  /// The joint's angle over the driver's, where that is the same over a stretch about position 1 that has all
  /// positions: of analytic motions all or none. A parallelogram may flip where its links lie in one line; up to there
  /// it counts.
  [[nodiscard]] std::optional<double> ratio(const std::vector<std::vector<double>>& rows, std::size_t joint,
                                            std::size_t driver) const {
    constexpr double rounding = 1e-9, stretch = 0.05;
    if (joint == driver || rows.empty()) return {};
    const auto some_way =
        std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return std::abs(row[driver]) > stretch; });
    if (some_way == rows.end()) return {};
    const double ratio = std::round((*some_way)[joint] / (*some_way)[driver]);
    const auto same = [&](const std::vector<double>& turns) {
      return std::abs(turns[joint] - ratio * turns[driver]) < rounding;
    };
    const bool in_positions =
        std::all_of(model_.keys.begin(), model_.keys.end(), [&](const SimulatorKey& key) { return same(key.turns); });
    return in_positions && std::all_of(rows.begin(), some_way + 1, same) ? std::optional(ratio) : std::nullopt;
  }

  [[nodiscard]] std::string remark() const {
    const std::string& unit = linkage_.length_unit;
    const bool known = millimetres(unit).has_value();
    const std::string of_unit =
        known ? "lengths in " + spoken_unit(unit)
              : (unit.empty() ? "no unit of length" : "the unit of length " + unit) + ", taken for millimetres";
    return fmt::format("{}{}: a linkage with {}; here in m, kg, rad, its density {} kg/m³", linkage_.title,
                       linkage_.title.empty() ? "Linkwright" : ", by Linkwright", of_unit,
                       significant_text(density_, 6));
  }

  const Machine& machine_;
  const MovingLinkage& linkage_;
  double density_, metre_;
  std::vector<Hanging> hanging_;
  std::vector<int> place_of_;  ///< in the links, by body
  SimulatorModel model_;
};

}  // namespace

SimulatorModel simulator_model(const Machine& machine, double density) {
  return ModelBuilder(machine, density).build();
}

std::string number(double value, double size) { return significant_text(value, 10, size); }

std::string numbers(Vector3 vector, double size) {
  return fmt::format("{} {} {}", number(vector.x, size), number(vector.y, size), number(vector.z, size));
}

Vector3 roll_pitch_yaw(const Rotation& rotation) {
  const Matrix3x3& c = rotation.matrix();
  const double level = std::hypot(c(0, 0), c(1, 0));
  if (level < 1e-9) return {std::atan2(-c(1, 2), c(1, 1)), std::atan2(-c(2, 0), level), 0};
  return {std::atan2(c(2, 1), c(2, 2)), std::atan2(-c(2, 0), level), std::atan2(c(1, 0), c(0, 0))};
}

}  // namespace linkwright
