#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

namespace linkwright {

/// Why a search ended.
enum class SearchEnd : std::uint8_t {
  settled,           ///< nothing better lies farther away than the resolution
  evaluation_limit,  ///< the bound on its turns was reached first
};

struct LineSearchOptions {
  double first_step = 1;      ///< > 0: how far from the start it looks first
  double resolution = 0;      ///< ≥ 0: how closely the top is to be bracketed
  int max_evaluations = 100;  ///< evaluations of the function, at most
};

/// A place on a line and what was found there; `found` has a member `score`, larger is better.
template <class Found>
struct LinePlace {
  double at = 0;
  Found found;
};

template <class Found>
struct LineSearchResult {
  LinePlace<Found> top;
  int turns = 0;  ///< evaluations
  SearchEnd end = SearchEnd::settled;
};

/// What the arithmetic of a score can make up: a gain below it is none.
[[nodiscard]] inline bool is_real_gain(double score, double before) {
  return score > before + 4 * std::numeric_limits<double>::epsilon() * std::abs(before);
}

/// The top of the hill of a function of one number on which a place stands: steps twice as long each until the top is
/// passed, then parabolas through three places, golden sections where they do not help (R. P. Brent, "Algorithms for
/// minimization without derivatives", 1973, ch. 5). `at(x, best)` is what stands at x, nothing where the function is
/// not defined; `best` is the best place so far. The top of a function that is defined on a part of the line only may
/// be an end of that part. Never worse than the start.
template <class Found, class At>
[[nodiscard]] LineSearchResult<Found> climb_line(LinePlace<Found> start, const LineSearchOptions& options, At at);

/// Where between two places a function that falls and then rises is least: a golden section, each turn of which leaves
/// 0.618 of the way. `value_at(x)` may be infinite.
template <class Function>
[[nodiscard]] double least_between(double low, double high, int turns, const Function& value_at) {
  constexpr double share = 0.6180339887498949;  // (√5 − 1)/2
  double one = high - share * (high - low), other = low + share * (high - low);
  double at_one = value_at(one), at_other = value_at(other);
  for (int i = 0; i < turns; ++i) {
    const bool first_is_less = at_one <= at_other;
    (first_is_less ? high : low) = first_is_less ? other : one;
    (first_is_less ? other : one) = first_is_less ? one : other;
    (first_is_less ? at_other : at_one) = first_is_less ? at_one : at_other;
    const double next = first_is_less ? high - share * (high - low) : low + share * (high - low);
    (first_is_less ? one : other) = next;
    (first_is_less ? at_one : at_other) = value_at(next);
  }
  return (low + high) / 2;
}

namespace line_search {

inline constexpr double nowhere = -std::numeric_limits<double>::infinity();
inline constexpr double golden = 0.3819660112501051;  ///< (3 − √5)/2

/// A place where it is not better than at the top.
struct Flank {
  double at = 0, score = nowhere;
};

/// Where the parabola through a top and its flanks is highest; nothing where there is none.
[[nodiscard]] inline std::optional<double> vertex(const Flank& low, const Flank& top, const Flank& high) {
  if (low.score == nowhere || high.score == nowhere) return std::nullopt;
  const double left = (top.at - low.at) * (top.score - high.score),
               right = (top.at - high.at) * (top.score - low.score);
  const double p = (top.at - low.at) * left - (top.at - high.at) * right, q = 2 * (left - right);
  const double there = top.at - p / q;
  return q != 0 && there > low.at && there < high.at ? std::optional(there) : std::nullopt;
}

/// Between the flanks of a top: the place to look at next. Where three turns have not halved the distance of the
/// flanks, parabolas give way to a golden section of the longer side: at a sharp top they close in from one side only.
class Section {
 public:
  /// The next point to evaluate.
  [[nodiscard]] double next(const Flank& low, const Flank& top, const Flank& high, double resolution) {
    const double width = high.at - low.at;
    const bool shrinks = width < 0.5 * widths_[turn_ % widths_.size()];
    widths_[turn_++ % widths_.size()] = width;
    if (const auto there = shrinks ? vertex(low, top, high) : std::nullopt)
      return away(*there, low, top, high, resolution);
    const bool upwards = high.at - top.at > top.at - low.at;
    return top.at + golden * (upwards ? high.at - top.at : low.at - top.at);
  }

 private:
  /// Not closer to the top than what is to be told apart, so that brackets close from both sides.
  [[nodiscard]] static double away(double there, const Flank& low, const Flank& top, const Flank& high,
                                   double resolution) {
    const double least = 0.5 * resolution;
    if (std::abs(there - top.at) >= least) return there;
    const bool upwards = high.at - top.at > top.at - low.at;
    return top.at + (upwards ? least : -least);
  }

  static constexpr double wide = std::numeric_limits<double>::infinity();
  std::array<double, 3> widths_ = {wide, wide, wide};  ///< of the last turns
  std::size_t turn_ = 0;
};

}  // namespace line_search

template <class Found, class At>
LineSearchResult<Found> climb_line(LinePlace<Found> start, const LineSearchOptions& options, At at) {
  using line_search::Flank;
  LineSearchResult<Found> result{std::move(start)};
  LinePlace<Found>& top = result.top;
  const double doubled_at_most = 64 * options.first_step;
  Flank low{top.at}, high{top.at};
  // What stands at x: the new top, with the old one as a flank, or a flank itself. True where it is the new top.
  const auto look = [&](double x) {
    ++result.turns;
    const Flank old{top.at, top.found.score};
    auto found = at(x, std::as_const(top));
    const bool better = found && is_real_gain(found->score, top.found.score);
    const Flank here{x, found ? found->score : line_search::nowhere};
    if (better) top = {x, *std::move(found)};
    (x > old.at ? (better ? low : high) : (better ? high : low)) = better ? old : here;
    return better;
  };

  double step = options.first_step;
  if (look(top.at + step)) {
    while (result.turns < options.max_evaluations && look(top.at + step)) step = std::min(2 * step, doubled_at_most);
  } else if (look(top.at - step)) {
    while (result.turns < options.max_evaluations && look(top.at - step)) step = std::min(2 * step, doubled_at_most);
  }
  line_search::Section section;
  while (result.turns < options.max_evaluations && high.at - low.at > 2 * options.resolution) {
    const double next = section.next(low, {top.at, top.found.score}, high, options.resolution);
    if (next == top.at || next <= low.at || next >= high.at) return result;
    look(next);
  }
  if (result.turns >= options.max_evaluations) result.end = SearchEnd::evaluation_limit;
  return result;
}

}  // namespace linkwright
