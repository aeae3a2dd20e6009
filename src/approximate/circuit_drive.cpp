#include <algorithm>
#include <cmath>
#include <optional>

#include "approximate/coupler_circuit.hpp"

namespace linkwright {
namespace {

// The way from the first target to the last, as positions that go on beyond the ends of the circuit, which is round.
struct Way {
  std::vector<double> positions;  ///< of the targets; of a closed target the first comes again at the end
  double low = 0, high = 0;
};

// Travel in one sense, +1 along the circuit or −1 against it.
class Travel {
 public:
  Travel(const CouplerCircuit& circuit, int sense, double noise)
      : circuit_(circuit), sense_(sense), noise_(noise), round_(static_cast<double>(circuit.states().size() - 1)) {}

  // Nothing where the targets do not come in turn within a round.
  [[nodiscard]] std::optional<Way> through(std::span<const double> places, bool closed) const {
    Way way{{places[0]}, places[0], places[0]};
    double front = places[0];
    for (std::size_t j = 1; j < places.size() + (closed ? 1 : 0); ++j) {
      const double to = places[j % places.size()];
      const double next = way.positions.back() + step_between(places[j - 1], to, front);
      if (sense_ > 0 ? next > way.high : next < way.low) front = to;
      way.positions.push_back(next);
      way.low = std::min(way.low, next);
      way.high = std::max(way.high, next);
    }
    const double gone = sense_ * (way.positions.back() - way.positions.front());
    constexpr double rounding = 0.5;  // of a step: a closed way ends where it began
    if (closed) return std::abs(gone - round_) < rounding ? std::optional(way) : std::nullopt;
    return way.high - way.low <= round_ + rounding ? std::optional(way) : std::nullopt;
  }

 private:
  // Forwards, but back where that is a matter of noise: never farther than that behind the front, the farthest place
  // so far, or points close to each other would lead back all the way.
  [[nodiscard]] double step_between(double from, double to, double front) const {
    double forward = std::fmod(sense_ * (to - from), round_);
    if (forward < 0) forward += round_;
    const double back = round_ - forward;
    const bool is_noise = back < forward && path_between(to, front) <= noise_;
    return sense_ * (is_noise ? -back : forward);
  }
  // Of the path, in the sense of travel.
  [[nodiscard]] double path_between(double from, double to) const {
    const double whole = circuit_.path().back(), gone = sense_ * (circuit_.path_at(to) - circuit_.path_at(from));
    return gone < 0 ? gone + whole : gone;
  }

  const CouplerCircuit& circuit_;
  int sense_;
  double noise_, round_;
};

// The two directions that are in line at a dead point of a driver.
std::array<Point, 2> joined(CurveDriver driver, const LoopState& at, Point output) {
  switch (driver) {
    case CurveDriver::e:
      return {at.u, output};
    case CurveDriver::u:
      return {at.e, output};
    default:
      return {at.e, at.u};
  }
}

class DriverCheck {
 public:
  DriverCheck(const CouplerLinkage& linkage, const CouplerCircuit& circuit, const Way& way, bool closed)
      : linkage_(linkage), circuit_(circuit), way_(way), round_(circuit.states().size() - 1) {
    first_ = static_cast<long>(std::ceil(way.low));
    last_ = closed ? first_ + static_cast<long>(round_) : std::max(first_, static_cast<long>(std::floor(way.high)));
  }

  [[nodiscard]] CircuitDrive::OfDriver of(CurveDriver driver) const {
    CircuitDrive::OfDriver found{true, false, 1, {}};
    int side = 0;
    for (long k = first_; k <= last_; ++k) {
      const auto [one, other] = joined(driver, state(k), output(state(k)));
      const double sine = cross(one, other);
      const int here = sine > 0 ? 1 : -1;
      if (side != 0 && here != side) found.no_dead_point = false;
      side = here;
      found.min_sine = std::min(found.min_sine, std::abs(sine));
    }
    if (!found.no_dead_point) found.min_sine = 0;
    const std::vector<double> turned = turned_along(driver);
    found.full_turn = std::abs(std::abs(turned.back()) - 6.283185307179586) < 1e-3;
    for (const double position : way_.positions)
      found.turns.push_back(turn_to(position, turned) - turn_to(way_.positions[0], turned));
    return found;
  }

 private:
  [[nodiscard]] const LoopState& state(long k) const {
    const long n = static_cast<long>(round_);
    return circuit_.states()[static_cast<std::size_t>(((k % n) + n) % n)];
  }
  [[nodiscard]] Point output(const LoopState& at) const { return LoopGradient(linkage_, at).g / linkage_.b; }
  [[nodiscard]] Point direction_of(CurveDriver driver, const LoopState& at) const {
    return driver == CurveDriver::e ? at.e : driver == CurveDriver::u ? at.u : output(at);
  }
  // Up to each state of the circuit; at the end that of a whole round.
  [[nodiscard]] std::vector<double> turned_along(CurveDriver driver) const {
    std::vector<double> turned = {0};
    for (long k = 0; k < static_cast<long>(round_); ++k) {
      const Point from = direction_of(driver, state(k)), to = direction_of(driver, state(k + 1));
      turned.push_back(turned.back() + std::atan2(cross(from, to), dot(from, to)));
    }
    return turned;
  }
  [[nodiscard]] double turn_to(double position, const std::vector<double>& turned) const {
    const auto round = static_cast<double>(round_);
    const double rounds = std::floor(position / round);
    const auto at = static_cast<std::size_t>(position - rounds * round);
    return rounds * turned.back() + turned[std::min(at, round_)];
  }

  const CouplerLinkage& linkage_;
  const CouplerCircuit& circuit_;
  const Way& way_;
  std::size_t round_;
  long first_ = 0, last_ = 0;
};

double distance_to_segment(Point p, Point from, Point to) {
  const Point along = to - from;
  const double square = std::norm(along);
  const double share = square > 0 ? std::clamp(dot(p - from, along) / square, 0.0, 1.0) : 0;
  return std::abs(p - from - share * along);
}

// Of the way, what it goes to and fro by noise once; closed: all round.
double path_length(const CouplerCircuit& circuit, const Way& way, bool closed) {
  const double whole = circuit.path().back(), round = static_cast<double>(circuit.states().size() - 1);
  if (closed) return whole;
  const double base = std::floor(way.low / round) * round, high = way.high - base;
  const double over = std::max(high - round, 0.0);
  return circuit.path_at(std::min(high, round)) - circuit.path_at(way.low - base) + circuit.path_at(over);
}

// How the path between the targets compares with the polygon: each stretch with its own side and those beside it.
void compare_paths(const CouplerCircuit& circuit, const Way& way, std::span<const Point> targets, bool closed,
                   CircuitDrive& drive) {
  const auto n = static_cast<long>(targets.size()), sides = closed ? n : n - 1;
  const auto round = static_cast<long>(circuit.states().size() - 1);
  const auto side_distance = [&](long side, Point p) {
    const long at = closed ? (side + sides) % sides : std::clamp(side, 0L, sides - 1);
    return distance_to_segment(p, targets[static_cast<std::size_t>(at)],
                               targets[static_cast<std::size_t>((at + 1) % n)]);
  };
  double polygon = 0;
  for (long j = 0; j < sides; ++j) {
    const auto k = static_cast<std::size_t>(j);
    polygon += std::abs(targets[static_cast<std::size_t>((j + 1) % n)] - targets[k]);
    const double low = std::min(way.positions[k], way.positions[k + 1]);
    const double high = std::max(way.positions[k], way.positions[k + 1]);
    for (long at = static_cast<long>(std::ceil(low)); static_cast<double>(at) <= high; ++at) {
      const Point p = circuit.points()[static_cast<std::size_t>(((at % round) + round) % round)];
      const double off = std::min({side_distance(j - 1, p), side_distance(j, p), side_distance(j + 1, p)});
      drive.excursion = std::max(drive.excursion, off);
    }
  }
  drive.path_length_ratio = polygon > 0 ? path_length(circuit, way, closed) / polygon : 0;
}

}  // namespace

CircuitDrive drive_along_circuit(const CouplerLinkage& linkage, std::span<const LoopState> states,
                                 std::span<const Point> targets, bool closed, double noise, double turning_length) {
  CircuitDrive drive;
  const CouplerCircuit circuit(linkage, states.front(), turning_length);
  if (!circuit.closed()) return drive;
  std::vector<double> places;
  for (const LoopState& state : states) {
    places.push_back(circuit.position_of(state, places.empty() ? 0 : places.back()));
    if (places.back() < 0) return drive;
  }
  drive.one_circuit = true;
  std::optional<Way> way;
  for (const int sense : {1, -1}) {
    const auto other = Travel(circuit, sense, noise).through(places, closed);
    if (other && (!way || other->high - other->low < way->high - way->low)) way = other;
  }
  if (!way) return drive;
  drive.in_order = true;
  const DriverCheck check(linkage, circuit, *way, closed);
  for (const CurveDriver driver : {CurveDriver::e, CurveDriver::u, CurveDriver::g})
    drive.drivers[static_cast<std::size_t>(driver)] = check.of(driver);
  compare_paths(circuit, *way, targets, closed, drive);
  return drive;
}

}  // namespace linkwright
