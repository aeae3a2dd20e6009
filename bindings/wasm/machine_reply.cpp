#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "files/fields/result_forms.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/machine/mesh.hpp"
#include "replies.hpp"
#include "reply_fields.hpp"
#include "reply_forms.hpp"

namespace linkwright {

static void fields(FieldVisitor& v, const PlateSizes& sizes) {
  const Object described = {"plate_sizes", "User's unit. About a centre plates are pieces of spherical shells."};
  v.object(described, [&](FieldVisitor& to) {
    to.shown("width", sizes.width);
    to.shown("thickness", sizes.thickness);
    to.shown(Field("gap", "Between layers, and between what moves past each other in one."), sizes.gap);
    to.shown(Field("pin", "Diameter."), sizes.pin);
    to.shown(Field("clearance", "By how much a hole is wider than its pin."), sizes.clearance);
    to.shown(Field("radius", "Of the outermost sphere; 0: planar."), sizes.radius);
  });
}

}  // namespace linkwright

namespace linkwright::wasm {
namespace {

/// The driver's angles as its drive counts them.
class DriverAngles {
 public:
  DriverAngles(const MovingLinkage& linkage, const Travel& drive) {
    if (linkage.travel.empty() || drive.states.size() < 2) return;
    const TravelState &first = drive.states[0], &next = drive.states[1], &last = drive.states.back();
    const double turn = turn_at(linkage, drive, first);
    sense_ = wrap_signed(turn_at(linkage, drive, next) - turn) < 0 ? -1 : 1;
    shift_ = first.turn - sense_ * turn;
    // Of all that differ by full turns, those of the drive's own stretch.
    const double middle =
        sense_ * (linkage.travel.front().driver_turn + linkage.travel.back().driver_turn) / 2 + shift_;
    shift_ += two_pi * std::round(((first.turn + last.turn) / 2 - middle) / two_pi);
    if (linkage.full_turn) begin_ = first.turn;
  }
  [[nodiscard]] double at(double turn) const {
    const double angle = sense_ * turn + shift_;
    if (!begin_) return degrees(angle);
    return degrees(*begin_ - rounding + wrap_positive(angle - *begin_ + rounding));
  }
  [[nodiscard]] std::pair<double, double> range_deg(const Crossing& crossing) const {
    const double low = at(sense_ < 0 ? crossing.to_turn : crossing.from_turn);
    return {low, low + degrees(std::abs(crossing.to_turn - crossing.from_turn))};
  }

 private:
  /// Of the driver, in a state of its drive, from position 1 of the linkage.
  static double turn_at(const MovingLinkage& linkage, const Travel& drive, const TravelState& state) {
    const std::vector<std::size_t> own = linkage.hinges_of(1);
    const Hinge &on_ground = linkage.hinges[own[0]], &other = linkage.hinges[own[1]];
    if (!linkage.spherical)
      return angle_about({0, 0, 1}, other.point - on_ground.point, state.hinges[own[1]] - on_ground.point);
    // Either unit vector of an axis will do: the drive may have the other one.
    const int there = drive.state_of_position.empty() ? -1 : drive.state_of_position.front();
    const bool is_other =
        there >= 0 && dot(drive.states[static_cast<std::size_t>(there)].hinges[own[1]], other.point) < 0;
    return angle_about(on_ground.point, other.point, is_other ? -state.hinges[own[1]] : state.hinges[own[1]]);
  }
  static double angle_about(Vector3 axis, Vector3 from, Vector3 to) {
    return std::atan2(dot(axis, cross(from, to)), dot(cross(axis, from), cross(axis, to)));
  }

  static constexpr double rounding = 1e-9;
  double sense_ = 1, shift_ = 0;
  std::optional<double> begin_;  ///< of the turn, where the driver makes a full one
};

CrossingReply crossing_reply(const MovingLinkage& linkage, const Crossing& crossing, const DriverAngles& angles) {
  CrossingReply reply{linkage.bodies[static_cast<std::size_t>(crossing.body)]};
  if (crossing.is_pin)
    reply.pin = linkage.hinges[crossing.obstacle].name;
  else
    reply.other = linkage.bodies[crossing.obstacle];
  std::tie(reply.from_deg, reply.to_deg) = angles.range_deg(crossing);
  return reply;
}

void append(std::vector<double>& row, const Displacement& there) {
  const UnitQuaternion turn = there.rotation.quaternion();
  const auto [x, y, z] = there.translation;
  row.insert(row.end(), {turn.w(), turn.v().x, turn.v().y, turn.v().z, x, y, z});
}

/// Of q and −q each row has the one nearer to its neighbour's, position 1's the one with w > 0: so a half-turn has the
/// sign of the motion through it, not of a last digit.
void continue_signs(std::vector<double>& rows, std::size_t width, std::size_t position_1) {
  const std::size_t count = rows.size() / width;
  const auto agree = [&](std::size_t row, std::size_t with) {
    for (std::size_t body = 1; body < width; body += 7) {
      double *const q = &rows[row * width + body], *const p = &rows[with * width + body];
      const double along = row == with ? q[0] : std::inner_product(q, q + 4, p, 0.0);
      if (along < 0) std::transform(q, q + 4, q, std::negate<>());
    }
  };
  for (std::size_t row = position_1; row < count; ++row) agree(row, std::max(row, position_1 + 1) - 1);
  for (std::size_t row = position_1; row-- > 0;) agree(row, row + 1);
}

std::vector<double> travel_rows(const MovingLinkage& linkage, const DriverAngles& angles) {
  std::vector<std::pair<double, const MovingState*>> states;
  for (const MovingState& state : linkage.travel) states.emplace_back(angles.at(state.driver_turn), &state);
  std::sort(states.begin(), states.end());
  if (linkage.full_turn && !states.empty()) {
    const auto first = states.front(), last = states.back();
    states.insert(states.begin(), {last.first - 360, last.second});
    states.emplace_back(first.first + 360, first.second);
  }
  std::vector<double> rows;
  for (const auto& [angle, state] : states) {
    rows.push_back(angle);
    for (std::size_t body = 1; body < state->bodies.size(); ++body) append(rows, state->bodies[body]);
  }
  const auto nearest = std::min_element(states.begin(), states.end(), [](const auto& a, const auto& b) {
    return std::abs(a.second->driver_turn) < std::abs(b.second->driver_turn);
  });
  if (!states.empty())
    continue_signs(rows, rows.size() / states.size(), static_cast<std::size_t>(nearest - states.begin()));
  return rows;
}

/// Hands a part over; its triangles are those of the list from where it ended.
PartReply added(MachineReply& to, const MovingLinkage& linkage, const Part& part) {
  const Mesh mesh = mesh_of(part);
  const auto first = static_cast<std::uint32_t>(to.vertices.size() / 3);
  for (const auto& [x, y, z] : mesh.vertices)
    for (const double coordinate : {x, y, z}) to.vertices.push_back(static_cast<float>(coordinate));
  for (const auto& triangle : mesh.triangles)
    for (const int corner : triangle) to.triangles.push_back(first + static_cast<std::uint32_t>(corner));
  return {part.name, linkage.bodies[static_cast<std::size_t>(part.body)], static_cast<int>(mesh.triangles.size())};
}

}  // namespace

static void fields(FieldVisitor& v, const PlateLayer& of) {
  v.object({.name = "plate_layer"}, [&](FieldVisitor& to) {
    to.shown("body", of.body);
    to.shown("layer", of.layer, natural);
  });
}

static void fields(FieldVisitor& v, const CrossingReply& of) {
  const Object described = {"plate_crossing", "What runs into what, and at which driver angles."};
  v.object(described, [&](FieldVisitor& to) {
    to.shown("body", of.body);
    to.shown_if_any(Field("pin", "What it runs into: the pin of a hinge, or another body's plate."), of.pin);
    to.shown_if_any("other", of.other);
    to.shown("from_deg", of.from_deg);
    to.shown("to_deg", of.to_deg);
  });
}

static void fields(FieldVisitor& v, const PartReply& of) {
  v.object({.name = "machine_part"}, [&](FieldVisitor& to) {
    to.shown("name", of.name);
    to.shown(Field("body", "That it moves with."), of.body);
    to.shown(Field("triangles", "How many of its surface, in the list of all."), of.triangles, natural);
  });
}

void fields(FieldVisitor& v, const MachinePlan& of) {
  const Object described = {"machine_plan",
                            "A linkage as plates on pins. Bodies and hinges are called as in the files."};
  std::size_t over = of.over == PlateLayers::Over::travel ? 0 : 1;
  v.object(described, [&](FieldVisitor& to) {
    to.shown("sizes", of.sizes);
    to.shown(Field("layers", "By body, from the ground, which lies in layer 0 (about a centre the innermost)."),
             of.layers, forms::on_a_line);
    to.member(Field("over",
                    "Free of collisions over the whole travel, or at least from the first position to the "
                    "last."),
              true, [&](FieldVisitor& at) {
                visit(at, over, Words{{"travel", "task"}});
              });
    to.shown("crossings", of.crossings, forms::on_a_line);
    to.shown(Field("guided", "The body that the task guides."), of.guided);
    to.shown(Field("at_deg", "The driver angle at which the parts lie as they are told."), of.at_deg);
    to.shown(Field("parts", "Plates by body, then pins by hinge."), of.parts, forms::on_a_line);
  });
}

MachineReply machine_reply(const Result<Machine>& made, const Travel& drive) {
  if (!made) return {refusal_json(made.errors()), {}, {}, {}};
  const MovingLinkage& linkage = made->linkage;
  const DriverAngles angles(linkage, drive);
  MachineReply reply;
  MachinePlan plan{made->sizes};
  for (std::size_t body = 0; body < linkage.bodies.size(); ++body)
    plan.layers.push_back({linkage.bodies[body], made->layers.layer[body]});
  plan.over = made->layers.over;
  for (const Crossing& crossing : made->layers.crossings)
    plan.crossings.push_back(crossing_reply(linkage, crossing, angles));
  plan.guided = linkage.bodies[static_cast<std::size_t>(linkage.guided)];
  plan.at_deg = angles.at(0);
  for (const Part& part : made->parts) plan.parts.push_back(added(reply, linkage, part));
  reply.plan = text_of(plan);
  reply.travel = travel_rows(linkage, angles);
  return reply;
}

}  // namespace linkwright::wasm
