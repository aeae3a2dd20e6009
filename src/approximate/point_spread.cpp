#include <cmath>

#include "approximate/start_list.hpp"

namespace linkwright {
namespace {

bool fill_between(const ScaledTarget& target, CurveStart& start, std::size_t from, std::size_t to,
                  const LoopState& first, const LoopState& last) {
  const std::size_t n = target.points.size();
  const auto along = [&](std::size_t j) { return std::abs(target.points[(j + 1) % n] - target.points[j % n]); };
  double whole = 0, gone = 0;
  for (std::size_t j = from; j < to; ++j) whole += along(j);
  const auto between = [](Point a, Point b, double share) {
    const Point mixed = (1 - share) * a + share * b;
    return std::norm(mixed) > 0 ? mixed / std::abs(mixed) : a;
  };
  bool closes = true;
  for (std::size_t j = from; j < to; ++j) {
    const double share = whole > 0 ? gone / whole : 0;
    LoopState state{between(first.e, last.e, share), between(first.u, last.u, share)};
    closes = close_loop(start.linkage, state) && closes;
    start.states[j % n] = state;
    gone += along(j);
  }
  return closes;
}

}  // namespace

bool spread_to_all_points(const ScaledTarget& target, CurveStart& start) {
  const std::vector<LoopState> coarse = start.states;
  start.states.resize(target.points.size());
  bool closes = true;
  for (std::size_t k = 0; k < coarse.size(); ++k) {
    const std::size_t from = target.chosen[k];
    const bool is_last = k + 1 == coarse.size();
    if (is_last && !target.closed) {
      start.states[from] = coarse[k];
      break;
    }
    const std::size_t to = is_last ? target.points.size() + target.chosen[0] : target.chosen[k + 1];
    closes = closes && fill_between(target, start, from, to, coarse[k], coarse[(k + 1) % coarse.size()]);
  }
  return closes;
}

}  // namespace linkwright
