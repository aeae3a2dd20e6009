#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "approximate/coupler_circuit.hpp"

namespace linkwright {

/// Of each state of a circuit at each of some targets, ≥ 0.
using StateCost = std::function<double(std::size_t state, std::size_t target)>;

/// A state of the circuit to each target, in one sense from one state on: the least sum of costs of all that come in
/// turn and begin at one of a few states that suit the first target.
[[nodiscard]] std::vector<LoopState> states_in_turn(const CouplerCircuit& circuit, std::size_t targets,
                                                    const StateCost& cost);

}  // namespace linkwright
