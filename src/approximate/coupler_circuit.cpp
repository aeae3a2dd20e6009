#include "approximate/coupler_circuit.hpp"

#include <algorithm>
#include <cmath>

namespace linkwright {
namespace {

constexpr double usual_step = 0.015, shortest_step = 1e-5;  // radians of the arc of the state
constexpr int most_steps = 20000;

// Angles by which e and u turn from one state to another near it.
Point turns_between(const LoopState& from, const LoopState& to) {
  return {std::atan2(cross(from.e, to.e), dot(from.e, to.e)), std::atan2(cross(from.u, to.u), dot(from.u, to.u))};
}

double square_between(const LoopState& a, const LoopState& b) { return std::norm(a.e - b.e) + std::norm(a.u - b.u); }

// Unit tangent, by the turns of e and u; none where strands meet.
Point tangent_at(const CouplerLinkage& linkage, const LoopState& at) {
  const LoopGradient loop(linkage, at);
  const double length = std::sqrt(loop.square());
  return length > 0 ? Point{-loop.f_u / length, loop.f_e / length} : Point{};
}

// A step that stays on its strand: there the tangent turns little.
struct CircuitStep {
  LoopState state;
  Point tangent;
  bool taken = false;
};
CircuitStep step_on(const CouplerLinkage& linkage, const LoopState& from, Point tangent, double step) {
  constexpr double same_way = 0.97;
  CircuitStep next{turned(from, step * tangent.real(), step * tangent.imag()), {}, false};
  if (!close_loop(linkage, next.state)) return next;
  next.tangent = tangent_at(linkage, next.state);
  next.taken = dot(next.tangent, tangent) > same_way && square_between(from, next.state) < 4 * step * step;
  return next;
}

}  // namespace

CouplerCircuit::CouplerCircuit(const CouplerLinkage& linkage, const LoopState& start, double turning_length)
    : linkage_(linkage), turning_length_(turning_length) {
  append(start);
  const Point first = tangent_at(linkage, start);
  Point tangent = first;
  double step = usual_step, travelled = 0;
  LoopState at = start;
  for (int taken = 0; taken < most_steps && step >= shortest_step;) {
    const CircuitStep next = step_on(linkage, at, tangent, step);
    if (!next.taken) {
      step /= 2;
      continue;
    }
    const Point left = turns_between(at, start);  // what is left to the first state
    const double ahead = dot(left, tangent), beside = std::abs(cross(left, tangent));
    if (travelled > 4 * usual_step && ahead >= 0 && ahead <= step && beside < 0.2 * usual_step &&
        dot(tangent, first) > 0.9) {
      append(start);
      closed_ = true;
      return;
    }
    at = next.state;
    tangent = next.tangent;
    travelled += step;
    append(at);
    step = std::min(1.5 * step, usual_step);
    ++taken;
  }
}

void CouplerCircuit::append(const LoopState& state) {
  states_.push_back(state);
  points_.push_back(traced_point(linkage_, state));
  if (path_.empty()) {
    path_.push_back(0);
    return;
  }
  const std::size_t before = states_.size() - 2;
  const double turned = turning_length_ * turns_between(states_[before], state).imag();
  path_.push_back(path_.back() + std::hypot(std::abs(points_.back() - points_[before]), turned));
}

double CouplerCircuit::position_of(const LoopState& state, double near) const {
  const std::size_t n = states_.size(), window = n / 8 + 2;
  const auto middle = static_cast<std::size_t>(std::clamp(near, 0.0, static_cast<double>(n - 1)));
  const double beside = position_within(state, middle > window ? middle - window : 0, std::min(n, middle + window));
  return beside >= 0 ? beside : position_within(state, 0, n);
}

double CouplerCircuit::position_within(const LoopState& state, std::size_t from, std::size_t to) const {
  std::size_t nearest = from;
  for (std::size_t k = from; k < to; ++k)
    if (square_between(states_[k], state) < square_between(states_[nearest], state)) nearest = k;
  const double reach = 1.1 * usual_step;
  if (square_between(states_[nearest], state) > reach * reach) return -1;
  const std::size_t before = nearest > 0 ? nearest - 1 : nearest, after = std::min(nearest + 1, states_.size() - 1);
  const auto share = [&](std::size_t a, std::size_t b) {
    const Point whole = turns_between(states_[a], states_[b]), part = turns_between(states_[a], state);
    return std::norm(whole) > 0 ? dot(part, whole) / std::norm(whole) : 0;
  };
  const auto index = static_cast<double>(nearest);
  const double ahead = share(nearest, after);
  if (after != nearest && ahead >= 0) return index + std::min(ahead, 1.0);
  return before == nearest ? index : index - std::clamp(1 - share(before, nearest), 0.0, 1.0);
}

double CouplerCircuit::path_at(double position) const {
  const auto below = static_cast<std::size_t>(position);
  if (below + 1 >= path_.size()) return path_.back();
  return path_[below] + (position - static_cast<double>(below)) * (path_[below + 1] - path_[below]);
}

}  // namespace linkwright
