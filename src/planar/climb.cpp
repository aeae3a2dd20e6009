#include <algorithm>
#include <array>
#include <cmath>

#include "linkwright/core/angle.hpp"
#include "planar/candidate.hpp"

namespace linkwright {

double change_point_margin(const FourBar& bars) {
  const GrashofExcesses t = grashof_excesses(bars.lengths());
  return std::min({std::abs(t.t1), std::abs(t.t2), std::abs(t.t3)}) / bars.lengths().perimeter();
}

namespace {

/// The least transmission angle is the smaller of several smooth functions, so hills have sharp ridges on which steps
/// in fixed directions get stuck: for each value of one coordinate the best value of the other is sought, and each of
/// the two searches is on a line.
class Climb {
 public:
  Climb(const Judge& judge, const Candidate& start, double first_step)
      : judge_(judge),
        start_(start),
        best_(start),
        first_step_(first_step),
        least_margin_(std::min(buildable_margin, change_point_margin(start.bars))) {}

  [[nodiscard]] Candidate top() {
    constexpr double smallest_step = 1e-10;
    for (double step = first_step_; step > smallest_step;) {
      const double before = best_.score, from = best_.place.input;
      for (const double input : {from + step, from - step}) try_input(input, step);
      step = best_.score > before ? std::min(1.5 * step, first_step_) : 0.4 * step;
    }
    best_.local_optimum = true;
    return best_;
  }

 private:
  /// The best output for this input, sought from where the best one was.
  void try_input(double input, double step) {
    auto found = first_allowed(input, step);
    if (!found) return;
    for (double move = step; move > 1e-3 * step;) {
      const Candidate here = *found;
      for (const double output : {here.place.output + move, here.place.output - move}) {
        const auto tried = allowed({input, output});
        if (tried && tried->score > found->score) found = tried;
      }
      move *= found->score > here.score ? 1.5 : 0.4;
    }
    if (found->score > best_.score) best_ = *found;
  }

  /// The output that was best, or one close by where that is no longer allowed.
  [[nodiscard]] std::optional<Candidate> first_allowed(double input, double step) const {
    constexpr std::array<double, 7> steps_aside = {0, 1, -1, 2, -2, 4, -4};
    for (const double aside : steps_aside)
      if (const auto found = allowed({input, best_.place.output + aside * step})) return found;
    return std::nullopt;
  }

  [[nodiscard]] std::optional<Candidate> allowed(RegionPlace place) const {
    const auto found = judge_.candidate(on_branches(place));
    if (!found || found->report.type != start_.report.type) return std::nullopt;
    return change_point_margin(found->bars) < least_margin_ ? std::nullopt : found;
  }

  /// Leaving a closed branch at its end is entering it at its beginning; others end there.
  [[nodiscard]] RegionPlace on_branches(RegionPlace place) const {
    return {on_branch(LinkageFamily::Side::input, start_.place.input, place.input),
            on_branch(LinkageFamily::Side::output, start_.place.output, place.output)};
  }
  [[nodiscard]] double on_branch(LinkageFamily::Side side, double start, double tau) const {
    const double branch = std::floor(start);
    if (judge_.family().axis(side).is_closed()) return branch + wrap_period(tau - branch, 1);
    return std::clamp(tau, branch, std::nextafter(branch + 1, branch));
  }

  const Judge& judge_;
  Candidate start_, best_;
  double first_step_, least_margin_;
};

}  // namespace

Candidate climbed(const Judge& judge, const Candidate& start, double first_step) {
  return Climb(judge, start, first_step).top();
}

}  // namespace linkwright
