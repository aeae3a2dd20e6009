#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "linkwright/algebra/point.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/loads/driver_motion.hpp"

// What acts on a planar four-bar and the body on its coupler: weights, forces, springs, a hand or a drive, in one case
// or several. Lengths in the user's unit, kilograms, newtons, radians; moments in newton metres where a name does not
// say otherwise.
namespace linkwright {

/// What carries a load. Points of the coupler are told in the moving frame (`body`) or, as those of the grounded links
/// from their fixed pivot, along and across from its pivot at the input towards the one at the output (`coupler`).
enum class LoadedBody : std::uint8_t { ground, input, body, coupler, output };
inline constexpr std::array<std::string_view, 5> loaded_body_names = {"ground", "input", "body", "coupler", "output"};
[[nodiscard]] inline std::string_view name(LoadedBody body) {
  return loaded_body_names[static_cast<std::size_t>(body)];
}

/// A point that a body carries along: of the ground in the fixed frame.
struct CarriedPoint {
  LoadedBody on = LoadedBody::ground;
  Point at{};

  friend bool operator==(const CarriedPoint&, const CarriedPoint&) = default;
};

/// The four joints. What is told of one acts on its moving link: at both ends of the coupler on the coupler, on the
/// ground on the link that turns there.
enum class FourBarJoint : std::uint8_t { input_ground, input_coupler, output_coupler, output_ground };
inline constexpr std::size_t four_bar_joints = 4;
inline constexpr std::array<std::string_view, four_bar_joints> four_bar_joint_names = {
    "input_ground", "input_coupler", "output_coupler", "output_ground"};
[[nodiscard]] inline std::string_view name(FourBarJoint joint) {
  return four_bar_joint_names[static_cast<std::size_t>(joint)];
}

/// What the body on the coupler weighs.
struct BodyMass {
  double mass = 0;     ///< kg
  Point center{};      ///< in the moving frame
  double inertia = 0;  ///< about the centre, kg·m²

  friend bool operator==(const BodyMass&, const BodyMass&) = default;
};

/// What a link weighs: a mass at its middle or at a point along and across it, or a thin rod.
struct LinkMass {
  std::optional<double> mass;       ///< kg
  std::optional<double> kg_per_m;   ///< in place of the mass
  std::optional<Point> center;      ///< nothing: the middle
  std::optional<double> inertia{};  ///< about the centre, kg·m²; nothing: of a rod by its length, else 0

  friend bool operator==(const LinkMass&, const LinkMass&) = default;
};

/// A load beside the weights: a mass, or a force.
struct ExtraLoad {
  std::string name;
  CarriedPoint at;
  std::optional<double> mass;    ///< kg; nothing: a force
  Point force{};                 ///< N
  bool turns_with_body = false;  ///< the force, whose components are then in the frame that its point is told in
  bool always = false;           ///< in every case, otherwise in those that name it

  friend bool operator==(const ExtraLoad&, const ExtraLoad&) = default;
};

/// Where the hand takes hold of the body, and which way it pulls.
struct Handle {
  enum class Direction : std::uint8_t {
    tangential,  ///< as the point moves
    vertical,    ///< against gravity
    fixed        ///< at an angle in the fixed frame
  };
  Point point{};  ///< in the moving frame
  Direction direction = Direction::tangential;
  double angle = 0;  ///< of `fixed`, radians

  friend bool operator==(const Handle&, const Handle&) = default;
};

/// That the strength of a gas spring is left free: each linkage has the one with which the largest force of its hand is
/// least, among those that hold it open. Newtons.
struct FreeStrength {
  std::optional<double> min_f1;  ///< nothing: the weakest spring there is
  double max_f1 = 0;
  std::optional<double> min_hold_open;  ///< in the last position

  friend bool operator==(const FreeStrength&, const FreeStrength&) = default;
};

/// As catalogues have it (GB/T 25751): forces measured at a distance before both ends, extending and compressing; or
/// the friction, half of their difference.
struct GasSpring {
  double extended_length = 0, stroke = 0;
  std::optional<double> measured_at;      ///< nothing: 5 mm
  double f1 = 0, f2 = 0;                  ///< extending, near the extended and near the compressed end, N
  std::optional<double> f3, f4;           ///< compressing, near the extended and near the compressed end, N
  double friction = 0;                    ///< N, where f3 and f4 are not given
  double rod_diameter = 0;                ///< mm; 0: not known
  std::optional<double> percent_per_10K;  ///< nothing: an ideal gas
  /// Then the forces above say how much they grow over the stroke, and what friction takes. Of one spring at most.
  std::optional<FreeStrength> free;

  friend bool operator==(const GasSpring&, const GasSpring&) = default;
};

struct CoilSpring {
  enum class Acts : std::uint8_t { both, tension, compression };
  friend constexpr std::string_view name(Acts acts) {
    constexpr std::array<std::string_view, 3> names = {"both", "tension", "compression"};
    return names[static_cast<std::size_t>(acts)];
  }
  double rate = 0;  ///< N per unit of length
  double free_length = 0;
  Acts acts = Acts::both;

  friend bool operator==(const CoilSpring&, const CoilSpring&) = default;
};

struct TorsionSpring {
  FourBarJoint joint = FourBarJoint::input_ground;
  double rate_per_degree = 0;       ///< N·m per degree
  double torque_at_position_1 = 0;  ///< on the joint's moving link, counter-clockwise positive

  friend bool operator==(const TorsionSpring&, const TorsionSpring&) = default;
};

/// Between two bodies, or about a joint.
struct Spring {
  std::string name;
  int count = 1;          ///< side by side
  CarriedPoint from, to;  ///< studs; not of torsion springs
  std::variant<GasSpring, CoilSpring, TorsionSpring> law;

  friend bool operator==(const Spring&, const Spring&) = default;
};

/// Pins of all joints.
struct PinFriction {
  double radius = 0;    ///< user's unit
  double friction = 0;  ///< coefficient

  friend bool operator==(const PinFriction&, const PinFriction&) = default;
};

struct Cylinder {
  CarriedPoint from, to;
  friend bool operator==(const Cylinder&, const Cylinder&) = default;
};

/// What holds and moves the linkage.
enum class LoadDrive : std::uint8_t { hand, input, output, cylinder };

/// What is read off the forces over the travel.
enum class ReadOut : std::uint8_t {
  max_open_force,
  max_close_force,
  hand_force,
  hold_open,
  close_start,
  hump,
  pop_up,
  self_rise,
  self_close,
  max_pin_force,
  max_torque,
  cylinder_force,
  hand_force_error,  ///< of a map's cells, see read_outs
  best_f1            ///< likewise
};
/// Those of cases, by which they stand in files. The two behind them are of a linkage, and of no case: how far its hand
/// force at the stations of a map is from that over the travel, and the F1 of the spring that leaves it free.
inline constexpr std::size_t read_outs = 12;
inline constexpr std::array<std::string_view, read_outs> read_out_names = {
    "max_open_force", "max_close_force", "hand_force", "hold_open",     "close_start", "hump",
    "pop_up",         "self_rise",       "self_close", "max_pin_force", "max_torque",  "cylinder_force"};
[[nodiscard]] inline std::string_view name(ReadOut read_out) {
  return read_out_names[static_cast<std::size_t>(read_out)];
}

/// One state of the surroundings.
struct LoadCase {
  std::string name;
  double temperature = 20;          ///< °C
  double slope = 0;                 ///< radians, the ground rising to the right
  std::vector<std::string> extra;   ///< loads that act in it, by name
  double spring_percent = 100;      ///< of all springs' forces
  double gas_exponent = 1;          ///< 1: slow, 1.4: too fast for heat
  std::vector<ReadOut> counts_for;  ///< empty: all

  [[nodiscard]] bool counts(ReadOut read_out) const;
  friend bool operator==(const LoadCase&, const LoadCase&) = default;
};

[[nodiscard]] bool acts_in(const ExtraLoad& extra, const LoadCase& of);

/// The loads on a linkage.
struct Loads {
  struct Gravity {
    double direction = -1.5707963267948966;  ///< radians, of a level ground
    double acceleration = 9.81;              ///< m/s²
    friend bool operator==(const Gravity&, const Gravity&) = default;
  };
  std::optional<Gravity> gravity = Gravity{};
  std::optional<BodyMass> body;
  std::optional<LinkMass> input, coupler, output;
  std::vector<ExtraLoad> extra;
  std::optional<Handle> handle;
  std::vector<Spring> springs;
  std::optional<PinFriction> pins;
  LoadDrive drive = LoadDrive::hand;
  Cylinder cylinder;          ///< of that drive
  std::optional<double> rpm;  ///< of the driver: with inertia
  /// In place of it, of the input link from position 1 to the last one, closing the same backwards: with inertia.
  std::optional<DriverMotion> motion;
  std::vector<LoadCase> cases;   ///< none: one at 20 °C on level ground
  int stations = 13;             ///< of a map's cells, over the travel
  std::optional<double> metres;  ///< to the user's unit of length; nothing: not known

  friend bool operator==(const Loads&, const Loads&) = default;
};
inline constexpr int most_stations = 721;
inline constexpr std::size_t most_load_cases = 16, most_springs = 16, most_extra_loads = 32;

/// Its links move so fast that their inertia counts.
[[nodiscard]] inline bool has_inertia(const Loads& loads) { return loads.motion || loads.rpm.value_or(0) != 0; }

/// The spring whose strength is left free.
[[nodiscard]] std::optional<std::size_t> free_spring(const Loads& loads);

/// By which a spring is told: its name, or "spring_1", … by its place.
[[nodiscard]] std::string spring_name(const Loads& loads, std::size_t spring);

/// The cases, or the one that stands for none.
[[nodiscard]] std::vector<LoadCase> cases_of(const Loads& loads);

/// The unit of length, where it is not known 1: torques are then in newtons times the unit.
[[nodiscard]] inline double metres_of(const Loads& loads) { return loads.metres.value_or(1); }

/// All of the caller's mistakes that do not depend on a task; places as in problem files, `loads.…`.
[[nodiscard]] std::vector<Error> mistakes_in(const Loads& loads);

}  // namespace linkwright
