#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "linkwright/algebra/point.hpp"
#include "linkwright/loads/loads.hpp"
#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "loads/gas_law.hpp"

// The forces in a four-bar at one configuration by virtual work, without a division that could fail at a dead point,
// and its pins in closed form: docs/theory/loads.md. Newtons, moments in newtons times the user's unit of length.
namespace linkwright {

/// Angular velocities of the links, counter-clockwise, the largest of them 1: (β × h : α × β : α × h), in the sense of
/// opening. Finite and not all zero where the linkage can move one way only.
struct FourBarTwist {
  double input = 0, coupler = 0, output = 0;
};
/// `sense`: ±1, so that the input of the first configuration turns as in opening. Nothing where all links lie in one
/// line.
[[nodiscard]] std::optional<FourBarTwist> twist_of(const FourBar& bars, double sense);

/// A point that a link carries, along and across it from its fixed pivot, the coupler's from its pivot at the input; of
/// the ground as it is.
struct LinkPoint {
  enum class Link : std::uint8_t { input, coupler, output, ground };
  Link link = Link::ground;
  Point at{};
};

/// A four-bar at one place of its travel.
struct LoadedPlace {
  FourBar bars;
  FourBarTwist twist;
  std::array<double, 3> turn{};  ///< of input, coupler, output from position 1, without jumps, radians
  double share = 0, whole = 0;   ///< how much of the input's turn over the travel lies behind, and that turn, ≥ 0

  [[nodiscard]] Point origin(LinkPoint::Link link) const;
  [[nodiscard]] Point axis(LinkPoint::Link link) const;  ///< unit vector
  [[nodiscard]] double rate(LinkPoint::Link link) const;
  [[nodiscard]] Point position(const LinkPoint& point) const {
    return origin(point.link) + axis(point.link) * point.at;
  }
  [[nodiscard]] Point velocity(const LinkPoint& point) const;  ///< by the twist
};

/// Resultant forces on input, coupler and output, and moments about the fixed pivots and the coupler's pivot at the
/// input.
struct Resultants {
  std::array<Point, 3> force{};
  std::array<double, 3> moment{};

  void add(const LoadedPlace& place, const LinkPoint& at, Point acting);
  void add_moment(LinkPoint::Link link, double acting);
  [[nodiscard]] double power(const LoadedPlace& place) const;
};

/// All that acts but the effort and the friction of pins: what is static, and the friction of springs while opening,
/// which closing turns round.
struct Acting {
  Resultants still, rubbing;
};

/// What moves the linkage: its wrench for a unit of effort, and how fast that goes along in opening.
struct UnitEffort {
  Resultants wrench;
  double rate = 0;

  /// −1 where opening goes against it. What it takes is told the way that it goes: positive where it has to be done.
  [[nodiscard]] double way() const { return rate < 0 ? -1 : 1; }
};

/// Forces at the joints, in the order of FourBarJoint.
using JointForces = std::array<Point, four_bar_joints>;

/// What it takes to move one way.
struct Push {
  double effort = 0;  ///< along the motion; signed
  JointForces joints{};
  bool locks = false;  ///< by friction: no effort moves it
};

enum class PinFrictionModel : unsigned char {
  first_order,  ///< by the forces of frictionless pins
  close,        ///< by their own, to a ten-millionth of the effort
  exact         ///< to rounding
};

/// The loads of one case on one linkage, bound to its links.
class BoundLoads {
 public:
  /// `bars`, `body`: as they lie in position 1. Refers to nothing.
  BoundLoads(const Loads& loads, const LoadCase& of, const FourBar& bars, const Pose& body);

  /// Everything but the effort and friction.
  [[nodiscard]] Resultants resultants(const LoadedPlace& place) const { return acting(place).still; }
  [[nodiscard]] Acting acting(const LoadedPlace& place) const;
  /// Energy, of loads that have one: weights, forces fixed in the fixed frame, springs without friction.
  [[nodiscard]] double energy(const LoadedPlace& place) const;
  [[nodiscard]] bool has_energy() const { return has_energy_; }
  /// Friction of springs per twist, ≥ 0.
  [[nodiscard]] double spring_friction(const LoadedPlace& place) const;

  /// The drive's, and the hand's whatever the drive; nothing where it rests, or there is none.
  [[nodiscard]] std::optional<UnitEffort> hand(const LoadedPlace& place) const;
  [[nodiscard]] std::optional<UnitEffort> torque(const LoadedPlace& place, LinkPoint::Link crank) const;
  [[nodiscard]] std::optional<UnitEffort> cylinder(const LoadedPlace& place) const;
  [[nodiscard]] std::optional<UnitEffort> drive(const LoadedPlace& place) const;

  /// By an effort, `sense` +1 opening, −1 closing.
  [[nodiscard]] Push push(const LoadedPlace& place, const UnitEffort& by, int sense, PinFrictionModel model) const {
    return push(place, acting(place), by, sense, model);
  }
  [[nodiscard]] Push push(const LoadedPlace& place, const Acting& all, const UnitEffort& by, int sense,
                          PinFrictionModel model) const;
  /// The joints' forces under loads that balance by themselves or with an effort that is among them; nothing where the
  /// links lie in one line.
  [[nodiscard]] static std::optional<JointForces> joint_forces(const LoadedPlace& place, const Resultants& all);

  /// A linear spring at a place.
  struct SpringState {
    double length = 0;
    double force = 0;     ///< of one, without friction; pushing > 0
    double friction = 0;  ///< of one
    double rate = 0;      ///< of the length, per twist
  };
  /// By the springs of the loads; nothing of torsion springs.
  [[nodiscard]] std::vector<std::optional<SpringState>> springs(const LoadedPlace& place) const;

  /// Forces of inertia are among the resultants.
  [[nodiscard]] bool is_dynamic() const { return angular_velocity_ != 0 || law_; }
  /// Of the input link, counter-clockwise, and the time from position 1; of a place of a travel.
  struct DriverRates {
    double speed = 0, acceleration = 0;  ///< rad/s, rad/s²
    double time = 0;                     ///< s
  };
  [[nodiscard]] DriverRates driver_rates(const LoadedPlace& place) const;
  /// Of the linkage on its ground.
  [[nodiscard]] Point shaking_force(const LoadedPlace& place) const;
  /// Cylinder: between its line and the way of its stud, radians in [0, π/2]; nothing without motion.
  [[nodiscard]] std::optional<double> pressure_angle(const LoadedPlace& place) const;
  [[nodiscard]] const std::optional<LinkPoint>& handle() const { return handle_; }

 private:
  struct Mass {
    LinkPoint at;
    double mass, inertia;
  };
  struct Force {
    LinkPoint at;
    Point force;
    bool turns;
  };
  struct Linear {
    LinkPoint from, to;
    double count, percent;
    std::variant<GasLaw, CoilSpring> law;
    GasLaw::State state;
    double extended = 0;
  };
  struct Torsion {
    FourBarJoint joint;
    double rate, moment;
  };

  [[nodiscard]] LinkPoint bound(const CarriedPoint& point) const;
  void bind_forces(const Loads& loads, const LoadCase& of);
  void bind_springs(const Loads& loads, const LoadCase& of);
  void add_inertia(const LoadedPlace& place, Resultants& all) const;
  void add_spring(const Linear& spring, const LoadedPlace& place, Acting& all) const;
  [[nodiscard]] SpringState state(const Linear& spring, const LoadedPlace& place) const;

  FourBar first_;
  Pose body_;
  Point gravity_{};
  std::vector<Mass> masses_;
  std::vector<Force> forces_;
  std::vector<Linear> linear_;
  std::vector<std::optional<std::size_t>> spring_of_;  ///< by spring of the loads, among linear_
  std::vector<Torsion> torsion_;
  std::optional<LinkPoint> handle_;
  Handle::Direction hand_direction_ = Handle::Direction::tangential;
  Point hand_along_{};
  LoadDrive drive_ = LoadDrive::hand;
  LinkPoint cylinder_from_, cylinder_to_;
  double friction_circle_ = 0;
  double size_ = 1;
  double angular_velocity_ = 0, metres_ = 1;
  std::optional<TimeLaw> law_;
  bool has_energy_ = true;
};

}  // namespace linkwright
