#include "machine/task_stretch.hpp"

#include <algorithm>
#include <tuple>

namespace linkwright {
namespace {

/// From a state on, forwards or backwards, until the last position; nothing where another one comes before its turn.
std::vector<std::size_t> stretch(const MovingLinkage& linkage, std::size_t from, bool forwards) {
  const std::size_t count = linkage.travel.size();
  std::vector<std::size_t> states;
  int met = 0;
  for (std::size_t k = 0; k < count; ++k) {
    if (!linkage.full_turn && (forwards ? from + k >= count : k > from)) return {};
    // Both ends of a full turn are the same place.
    const std::size_t ring = linkage.full_turn ? count - 1 : count,
                      at = forwards ? (from + k) % ring : (from + ring - k % ring) % ring;
    const std::optional<int> position = linkage.travel[at].position;
    if (position && *position > met + 1) return {};
    if (position && *position == met + 1) ++met;
    states.push_back(at);
    if (met + 1 == linkage.positions) return states;
  }
  return {};
}

/// The shortest stretch forwards with all positions in it; nothing where the drive does not get to one.
std::vector<std::size_t> covering(const MovingLinkage& linkage) {
  const std::size_t count = linkage.travel.size(), ring = linkage.full_turn ? count - 1 : count;
  std::vector<std::size_t> stops;
  for (int position = 0; position < linkage.positions; ++position) {
    const MovingState* state = linkage.at_position(position);
    if (state == nullptr) return {};
    stops.push_back(static_cast<std::size_t>(state - linkage.travel.data()) % ring);
  }
  std::sort(stops.begin(), stops.end());
  std::size_t from = stops.front(), length = stops.back() - stops.front();
  for (std::size_t k = 1; linkage.full_turn && k < stops.size(); ++k)
    if (const std::size_t round = ring - (stops[k] - stops[k - 1]); round < length)
      std::tie(from, length) = std::pair(stops[k], round);
  std::vector<std::size_t> states;
  for (std::size_t k = 0; k <= length; ++k) states.push_back((from + k) % ring);
  return states;
}

}  // namespace

std::vector<std::size_t> task_stretch(const MovingLinkage& linkage) {
  const MovingState* first = linkage.at_position(0);
  if (first == nullptr || linkage.travel.size() < 2) return {};
  const auto from = static_cast<std::size_t>(first - linkage.travel.data());
  std::vector<std::size_t> on = stretch(linkage, from, true), back = stretch(linkage, from, false);
  if (on.empty() && back.empty()) return covering(linkage);
  return back.empty() || (!on.empty() && on.size() <= back.size()) ? on : back;
}

}  // namespace linkwright
