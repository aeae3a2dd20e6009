#include "approximate/circuit_assignment.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace linkwright {
namespace {

constexpr double unreached = std::numeric_limits<double>::infinity();

struct Assignment {
  double cost = unreached;
  std::vector<std::size_t> states;
};

class CircuitAssignment {
 public:
  CircuitAssignment(const CouplerCircuit& circuit, std::size_t targets, const StateCost& cost)
      : count_(circuit.states().size() - (circuit.closed() ? 1 : 0)),
        targets_(targets),
        cost_(cost),
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
  // Where the first target costs least, and other places where it costs little.
  [[nodiscard]] std::vector<std::size_t> starts() const {
    constexpr std::size_t most = 4;
    const std::size_t n = count_;
    const auto distance = [&](std::size_t k) { return cost_(k % n, 0); };
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
    const std::size_t n = count_;
    return forwards ? (start + k) % n : (start + n - k) % n;
  }

  [[nodiscard]] Assignment in_turn(std::size_t start, bool forwards) const {
    const std::size_t n = count_;
    const std::size_t reach = round_ ? n : forwards ? n - start : start + 1;
    std::vector<double> cost(reach, unreached);
    std::vector<std::vector<std::uint32_t>> before(targets_, std::vector<std::uint32_t>(reach));
    cost[0] = cost_(start, 0);
    for (std::size_t j = 1; j < targets_; ++j) {
      std::uint32_t least = 0;
      double so_far = unreached;
      for (std::size_t k = 0; k < reach; ++k) {
        if (cost[k] < so_far) {
          so_far = cost[k];
          least = static_cast<std::uint32_t>(k);
        }
        before[j][k] = least;
        cost[k] = so_far + cost_(passed(start, forwards, k), j);
      }
    }
    auto last = static_cast<std::size_t>(std::min_element(cost.begin(), cost.end()) - cost.begin());
    Assignment found{cost[last], std::vector<std::size_t>(targets_)};
    for (std::size_t j = targets_; j-- > 0; last = before[j][last]) found.states[j] = passed(start, forwards, last);
    return found;
  }

  std::size_t count_, targets_;
  const StateCost& cost_;
  bool round_;
};

}  // namespace

std::vector<LoopState> states_in_turn(const CouplerCircuit& circuit, std::size_t targets, const StateCost& cost) {
  std::vector<LoopState> states;
  for (const std::size_t k : CircuitAssignment(circuit, targets, cost).best().states)
    states.push_back(circuit.states()[k]);
  return states;
}

}  // namespace linkwright
