#include <algorithm>
#include <cmath>
#include <limits>

#include "approximate/coupler_circuit.hpp"
#include "approximate/curve_least_squares.hpp"
#include "approximate/fit_result.hpp"

namespace linkwright {
namespace {

constexpr double unreached = std::numeric_limits<double>::infinity();

// States of a circuit to each point of a target, in one sense from one state on: the least sum of squares of all that
// come in turn.
struct Assignment {
  double cost = unreached;
  std::vector<std::size_t> states;
};

class CircuitAssignment {
 public:
  CircuitAssignment(const CouplerCircuit& circuit, const CurveTarget& target)
      : points_(circuit.points().begin(), circuit.points().end() - (circuit.closed() ? 1 : 0)),
        target_(target),
        round_(circuit.closed()) {}

  [[nodiscard]] Assignment best() const {
    Assignment best;
    for (const std::size_t start : starts()) {
      for (const bool forwards : {true, false}) {
        Assignment other = in_turn(start, forwards);
        if (other.cost < best.cost) best = std::move(other);
      }
    }
    return best;
  }

 private:
  // Where the path is nearest to the first point, and other places where it comes near.
  [[nodiscard]] std::vector<std::size_t> starts() const {
    constexpr std::size_t most = 4;
    const std::size_t n = points_.size();
    const auto distance = [&](std::size_t k) { return std::norm(points_[k % n] - target_.points.front()); };
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < n; ++k)
      if (distance(k) <= distance(k + 1) && distance(k) < distance(k + n - 1)) found.push_back(k);
    if (found.empty()) found.push_back(0);
    std::stable_sort(found.begin(), found.end(),
                     [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
    found.resize(std::min(found.size(), most));
    return found;
  }

  // The state that is passed as the k-th from a start.
  [[nodiscard]] std::size_t passed(std::size_t start, bool forwards, std::size_t k) const {
    const std::size_t n = points_.size();
    return forwards ? (start + k) % n : (start + n - k) % n;
  }

  [[nodiscard]] Assignment in_turn(std::size_t start, bool forwards) const {
    const std::size_t n = points_.size(), targets = target_.points.size();
    const std::size_t reach = round_ ? n : forwards ? n - start : start + 1;
    std::vector<double> cost(reach, unreached);
    std::vector<std::vector<std::uint32_t>> before(targets, std::vector<std::uint32_t>(reach));
    cost[0] = std::norm(points_[start] - target_.points[0]);
    for (std::size_t j = 1; j < targets; ++j) {
      std::uint32_t least = 0;
      double so_far = unreached;
      for (std::size_t k = 0; k < reach; ++k) {
        if (cost[k] < so_far) {
          so_far = cost[k];
          least = static_cast<std::uint32_t>(k);
        }
        before[j][k] = least;
        cost[k] = so_far + std::norm(points_[passed(start, forwards, k)] - target_.points[j]);
      }
    }
    auto last = static_cast<std::size_t>(std::min_element(cost.begin(), cost.end()) - cost.begin());
    Assignment found{cost[last], std::vector<std::size_t>(targets)};
    for (std::size_t j = targets; j-- > 0; last = before[j][last]) found.states[j] = passed(start, forwards, last);
    return found;
  }

  std::vector<Point> points_;
  const CurveTarget& target_;
  bool round_;
};

}  // namespace

std::optional<CurveFit> compare_with_curve(const TracingFourBar& linkage, const CurveTarget& target,
                                           const CurveFitOptions& options) {
  require_curve_target(target);
  if (!can_move(linkage)) return std::nullopt;
  const CouplerLinkage as_it_lies = coupler_linkage(linkage);
  const CouplerCircuit circuit(as_it_lies, loop_state(linkage));
  if (circuit.states().size() < 3) return std::nullopt;
  CurveStart nearest{as_it_lies, {}};
  for (const std::size_t k : CircuitAssignment(circuit, target).best().states)
    nearest.states.push_back(circuit.states()[k]);
  const std::vector<double> weights(target.points.size(), 1.0);
  slide_to_nearest({target.points, weights, {}}, nearest);
  return curve_fit_of(as_it_lies, nearest.states, target, options, FirstRealisation::as_given);
}

}  // namespace linkwright
