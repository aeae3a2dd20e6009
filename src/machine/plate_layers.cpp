#include "linkwright/machine/plate_layers.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "machine/hull_distance.hpp"
#include "machine/plate_corners.hpp"

namespace linkwright {
namespace {

using Layers = std::vector<int>;

/// Two things that would collide if they lay in one layer: at which states of the travel.
struct Meeting {
  std::vector<bool> at;
  int over_travel = 0, over_task = 0;
};

class Meetings {
 public:
  Meetings(const MovingLinkage& linkage, const PlateSizes& sizes)
      : linkage_(linkage), sizes_(sizes), in_task_(linkage.travel.size(), false) {
    for (const std::size_t state : linkage.task) in_task_[state] = true;
    const std::size_t count = linkage.bodies.size();
    for (std::size_t body = 0; body < count; ++body) corners_.push_back(plate_corners(linkage, static_cast<int>(body)));
    const double inner = sizes.radius > 0 ? (sizes.radius - 4 * sizes.pitch()) / sizes.radius : 1;
    const double plates_reach = sizes.width + sizes.gap, pin_reach = (sizes.width + sizes.pin / inner) / 2 + sizes.gap;
    for (std::size_t a = 1; a < count; ++a) {
      plates_.emplace_back(count);
      for (std::size_t b = a + 1; b < count; ++b) plates_.back()[b] = meeting(a, b, corners_[b], plates_reach);
      pins_.emplace_back();
      for (const Hinge& hinge : linkage.hinges)
        pins_.back().push_back(
            meeting(a, static_cast<std::size_t>(hinge.bodies[0]), std::vector<Vector3>{hinge.point}, pin_reach));
    }
  }

  /// Calls with each meeting that these layers bring about: meeting, body, is it a pin, which obstacle.
  template <class Visit>
  void each(const Layers& layer, Visit visit) const {
    for (std::size_t a = 1; a < layer.size(); ++a) {
      for (std::size_t b = a + 1; b < layer.size(); ++b)
        if (layer[a] == layer[b]) visit(plates_[a - 1][b], a, false, b);
      for (std::size_t pin = 0; pin < linkage_.hinges.size(); ++pin) {
        const auto [low, high] = pin_layers(linkage_.hinges[pin], layer);
        if (layer[a] > low && layer[a] < high) visit(pins_[a - 1][pin], a, true, pin);
      }
    }
  }

 private:
  std::vector<Vector3> placed(const std::vector<Vector3>& corners, const Displacement& there) const {
    std::vector<Vector3> now;
    for (const Vector3 corner : corners) now.push_back(there.apply_to_point(corner));
    return now;
  }
  double distance(const std::vector<Vector3>& one, const std::vector<Vector3>& other) const {
    return sizes_.radius > 0 ? sizes_.radius * arc_distance(one, other) : hull_distance(one, other);
  }
  /// How far the fastest corner has come.
  double way(const std::vector<Vector3>& before, const std::vector<Vector3>& now) const {
    double most = 0;
    for (std::size_t i = 0; i < now.size(); ++i) most = std::max(most, norm(now[i] - before[i]));
    return sizes_.radius > 0 ? sizes_.radius * most : most;
  }
  Meeting meeting(std::size_t a, std::size_t b, const std::vector<Vector3>& corners_of_b, double reach) const {
    Meeting found;
    std::vector<Vector3> a_before, b_before;
    double before = 0;
    for (std::size_t state = 0; state < linkage_.travel.size(); ++state) {
      const auto& bodies = linkage_.travel[state].bodies;
      const std::vector<Vector3> a_now = placed(corners_[a], bodies[a]), b_now = placed(corners_of_b, bodies[b]);
      const double now = distance(a_now, b_now);
      // Between the two states neither has come nearer than half of what both have moved lets it.
      const double ways = state > 0 ? way(a_before, a_now) + way(b_before, b_now) : 0;
      const bool meets = now < reach || (state > 0 && before + now - ways < 2 * reach);
      found.at.push_back(meets);
      found.over_travel += meets ? 1 : 0;
      found.over_task += meets && in_task_[state] ? 1 : 0;
      a_before = a_now;
      b_before = b_now;
      before = now;
    }
    return found;
  }

  const MovingLinkage& linkage_;
  const PlateSizes& sizes_;
  std::vector<bool> in_task_;
  std::vector<std::vector<Vector3>> corners_;
  std::vector<std::vector<Meeting>> plates_, pins_;
};

bool hinged_apart(const MovingLinkage& linkage, const Layers& layer) {
  return std::none_of(linkage.hinges.begin(), linkage.hinges.end(), [&](const Hinge& hinge) {
    return layer[static_cast<std::size_t>(hinge.bodies[0])] == layer[static_cast<std::size_t>(hinge.bodies[1])];
  });
}

/// From 1 on without a gap.
bool fills_its_layers(const Layers& layer) {
  const int top = *std::max_element(layer.begin(), layer.end());
  for (int k = 1; k <= top; ++k)
    if (std::find(layer.begin() + 1, layer.end(), k) == layer.end()) return false;
  return true;
}

/// Fewer layers first, then shorter pins, then the driver low.
std::vector<Layers> all_layers(const MovingLinkage& linkage) {
  const int moving = static_cast<int>(linkage.bodies.size()) - 1;
  std::vector<Layers> all;
  Layers layer(linkage.bodies.size(), 1);
  layer[0] = 0;
  for (std::size_t body = 0; body < layer.size();) {
    if (hinged_apart(linkage, layer) && fills_its_layers(layer)) all.push_back(layer);
    // The next number of so many digits 1 … moving.
    for (body = layer.size() - 1; body > 0 && layer[body] == moving; --body) layer[body] = 1;
    if (body == 0) break;
    ++layer[body];
  }
  const auto order = [&](const Layers& l) {
    const int pins = std::accumulate(linkage.hinges.begin(), linkage.hinges.end(), 0, [&](int sum, const Hinge& hinge) {
      const auto [low, high] = pin_layers(hinge, l);
      return sum + high - low;
    });
    return std::tuple(*std::max_element(l.begin(), l.end()), pins, l);
  };
  std::sort(all.begin(), all.end(), [&](const Layers& a, const Layers& b) { return order(a) < order(b); });
  return all;
}

std::vector<Crossing> crossings(const MovingLinkage& linkage, const Meetings& meetings, const PlateLayers& plan) {
  std::vector<bool> counts(linkage.travel.size(), plan.over == PlateLayers::Over::travel);
  if (plan.over == PlateLayers::Over::task)
    for (const std::size_t state : linkage.task) counts[state] = true;
  std::vector<Crossing> found;
  meetings.each(plan.layer, [&](const Meeting& meeting, std::size_t body, bool is_pin, std::size_t obstacle) {
    bool open = false;
    for (std::size_t state = 0; state < meeting.at.size(); ++state) {
      const double turn = linkage.travel[state].driver_turn;
      if (!(meeting.at[state] && counts[state]))
        open = false;
      else if (open)
        found.back().to_turn = turn;
      else
        found.push_back({static_cast<int>(body), is_pin, obstacle, turn, turn});
      open = meeting.at[state] && counts[state];
    }
  });
  return found;
}

}  // namespace

PlateLayers plate_layers(const MovingLinkage& linkage, const PlateSizes& sizes) {
  const Meetings meetings(linkage, sizes);
  const bool has_task = linkage.task.size() > 1;
  struct Cost {
    int travel = 0, task = 0;
  };
  const auto cost = [&](const Layers& layer) {
    Cost sum;
    meetings.each(layer, [&](const Meeting& meeting, std::size_t, bool, std::size_t) {
      sum.travel += meeting.over_travel;
      sum.task += meeting.over_task;
    });
    return sum;
  };
  const std::vector<Layers> all = all_layers(linkage);
  std::vector<Cost> costs;
  for (const Layers& layer : all) costs.push_back(cost(layer));
  const auto least = [&](int Cost::*over) {
    return static_cast<std::size_t>(
        std::min_element(costs.begin(), costs.end(), [&](const Cost& a, const Cost& b) { return a.*over < b.*over; }) -
        costs.begin());
  };
  std::size_t best = least(&Cost::travel);
  PlateLayers plan;
  if (costs[best].travel > 0 && has_task) {
    plan.over = PlateLayers::Over::task;
    best = least(&Cost::task);
  }
  plan.layer = all[best];
  plan.crossings = crossings(linkage, meetings, plan);
  return plan;
}

}  // namespace linkwright
