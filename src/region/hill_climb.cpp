#include "linkwright/region/hill_climb.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

struct Crossed {
  double second = 0, score = 0;
};
using Place = LinePlace<Crossed>;

class Climb {
 public:
  Climb(const Hill& hill, const HillClimbOptions& options, const Progress& progress)
      : hill_(hill), options_(options), progress_(progress) {}

  [[nodiscard]] HillTop top(std::array<double, 2> start, double score) {
    // A further search from the top on takes up what a bend of the ridge or of an edge of what is allowed hid at first.
    constexpr int max_passes = 20;
    constexpr double worth_another = 1e-6;  // of the score: less is not seen in six printed digits
    Place best{start[0], {start[1], score}};
    HillTop top;
    top.end = SearchEnd::evaluation_limit;
    double step = options_.first_step[0];
    for (int pass = 0; pass < max_passes && !progress_.is_cancelled(); ++pass) {
      const Place before = best;
      best = pass_from(best, step).top;
      const bool gained = best.found.score > before.found.score + worth_another * std::abs(before.found.score);
      const double moved = std::abs(best.at - before.at);
      step = std::min(moved, step);
      if (gained && moved > options_.resolution * options_.first_step[0]) continue;
      if (!progress_.is_cancelled()) top.end = SearchEnd::settled;
      break;
    }
    top.place = {hill_.first.onto(best.at), hill_.second.onto(best.found.second)};
    top.score = best.found.score;
    top.evaluations = evaluations_;
    return top;
  }

 private:
  [[nodiscard]] LineSearchResult<Crossed> pass_from(const Place& start, double step) {
    const double share = options_.first_step[0] > 0 ? step / options_.first_step[0] : 1;
    const Place from = along_second(start, share * options_.first_step[1]);
    last_at_ = from.at;
    last_second_ = from.found.second;
    if (!(step > 0)) return {from};
    return climb_line(from, {step, options_.resolution * options_.first_step[0], options_.max_evaluations},
                      [&](double first, const Place& best) { return best_at(first, best); });
  }

  /// The best second coordinate for this first one, sought from where the ridge leads to, or else from where the best
  /// so far has it.
  [[nodiscard]] std::optional<Crossed> best_at(double first, const Place& best) {
    if (progress_.is_cancelled()) return std::nullopt;
    const double share = std::min(1.0, std::abs(first - best.at) / options_.first_step[0]);
    const double step = std::max(share, options_.resolution) * options_.first_step[1];
    auto from = allowed_near(first, best.found.second + slope_at(best) * (first - best.at), step);
    if (!from) from = allowed_near(first, best.found.second, step);
    return from ? std::optional(along_second({first, *from}, step).found) : std::nullopt;
  }

  /// Of the ridge, from the last two places that were the best.
  [[nodiscard]] double slope_at(const Place& best) {
    if (best.at != last_at_) {
      slope_ = (best.found.second - last_second_) / (best.at - last_at_);
      last_at_ = best.at;
      last_second_ = best.found.second;
    }
    return slope_;
  }

  /// What stands at the same second coordinate, or aside where that is not allowed: a few cells off, however short the
  /// step, since along an edge of what is allowed the second coordinate may run far while the first hardly changes.
  [[nodiscard]] std::optional<Crossed> allowed_near(double first, double second, double step) {
    if (const auto found = at(first, second)) return found;
    const double farthest = 4 * options_.first_step[1];
    for (double aside = step; aside > 0 && aside <= farthest; aside *= 2)
      for (const double there : {second + aside, second - aside})
        if (const auto found = at(first, there)) return found;
    return std::nullopt;
  }

  [[nodiscard]] Place along_second(const Place& from, double step) {
    if (!(options_.first_step[1] > 0)) return from;
    const double resolution =
        options_.across * step;  // the gains of the first coordinate must not be noise of this search
    const auto found =
        climb_line(LinePlace<Crossed>{from.found.second, from.found}, {step, resolution, options_.max_evaluations},
                   [&](double second, const LinePlace<Crossed>&) { return at(from.at, second); });
    return {from.at, {found.top.at, found.top.found.score}};
  }

  [[nodiscard]] std::optional<Crossed> at(double first, double second) {
    if (progress_.is_cancelled()) return std::nullopt;
    ++evaluations_;
    const auto score = hill_.score_at(hill_.first.onto(first), hill_.second.onto(second));
    return score ? std::optional(Crossed{second, *score}) : std::nullopt;
  }

  const Hill& hill_;
  HillClimbOptions options_;
  const Progress& progress_;
  int evaluations_ = 0;
  double last_at_ = 0, last_second_ = 0, slope_ = 0;  ///< of the ridge
};

}  // namespace

HillTop climb_hill(const Hill& hill, std::array<double, 2> start, double score, const HillClimbOptions& options,
                   const Progress& progress) {
  return Climb(hill, options, progress).top(start, score);
}

}  // namespace linkwright
