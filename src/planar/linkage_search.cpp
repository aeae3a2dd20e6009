#include "planar/linkage_search.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

/// A place on the map, as a continuous pair of curve coordinates.
struct Place {
  double input = 0, output = 0;
};

struct Candidate {
  Place place;
  double score = 0;
  bool local_optimum = false;
};

// Two linkages count as different designs when a pivot differs by this share of the characteristic length.
constexpr double different_design = 0.02;
constexpr double clearly_different_design = 0.15;

// The climb stops where the type would hang on this share of the perimeter: near a change point the numbers look best
// and a workshop's tolerances decide what the linkage does.
constexpr double buildable_margin = 1e-3;

double change_point_margin(const FourBar& bars) {
  const GrashofExcesses t = grashof_excesses(bars.lengths());
  return std::min({std::abs(t.t1), std::abs(t.t2), std::abs(t.t3)}) / bars.lengths().perimeter();
}

/// Judges any place of the map by the same rules as the cells.
class Judge {
 public:
  Judge(const MotionTask& task, const MotionSolution& solution)
      : solution_(solution), frame_(solution.conditions.frame), poses_(frame_.to_working(task.poses)) {}

  [[nodiscard]] std::optional<FourBar> four_bar(Place place) const {
    const Dyad input = solution_.curve->dyad(place.input), output = solution_.curve->dyad(place.output);
    const auto a = finite_point(input.center), b = finite_point(input.circle);
    const auto c = finite_point(output.center), d = finite_point(output.circle);
    if (!a || !b || !c || !d) return std::nullopt;
    return FourBar{*a, *b, *c, *d};
  }

  [[nodiscard]] DefectReport report(const FourBar& bars) const {
    return find_defects(bars, poses_, solution_.requirements.respect_direction);
  }

  /// Score of a linkage that meets the requirements; nothing for others.
  [[nodiscard]] std::optional<double> score(const FourBar& bars, const DefectReport& found) const {
    const Requirements& wanted = solution_.requirements;
    if (found.type == LinkageType::degenerate) return std::nullopt;
    const auto& types = wanted.types;
    if (!types.empty() && std::find(types.begin(), types.end(), found.type) == types.end()) return std::nullopt;
    if (wanted.no_defects && !found.defects.none()) return std::nullopt;
    if (std::acos(found.worst_transmission_cosine) < wanted.min_transmission_angle) return std::nullopt;
    const LinkLengths lengths = bars.lengths();
    const double ratio = lengths.longest() / lengths.shortest(), longest = frame_.scale * lengths.longest();
    if (ratio > wanted.max_link_ratio || longest > *wanted.max_length) return std::nullopt;
    if (!inside(wanted.ground_pivots_within, bars.input_center, bars.output_center)) return std::nullopt;
    if (!inside(wanted.moving_pivots_within, bars.input_circle, bars.output_circle)) return std::nullopt;
    return score_of(solution_.options.objective, 1 - found.worst_transmission_cosine, ratio, longest);
  }

 private:
  [[nodiscard]] bool inside(const std::optional<Box>& box, Point p, Point q) const {
    return !box || (box->contains(frame_.to_user(p)) && box->contains(frame_.to_user(q)));
  }

  const MotionSolution& solution_;
  const WorkingFrame& frame_;
  std::vector<PrescribedPose> poses_;
};

/// Climbs from a cell to the top of its hill, keeping branch, type and requirements. The least transmission angle is
/// the smaller of several smooth functions, so hills have sharp ridges on which steps in fixed directions get stuck:
/// along one coordinate the best partner is sought for each value of the other, and each of the two searches is on a
/// line.
class Climb {
 public:
  Climb(const Judge& judge, Candidate start, double first_step)
      : judge_(judge), start_(start.place), best_(start), first_step_(first_step) {
    if (const auto bars = judge.four_bar(start.place)) {
      type_ = judge.report(*bars).type;
      least_margin_ = std::min(least_margin_, change_point_margin(*bars));
    }
  }

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
  /// Looks for the best output for this input, from where the best one was, or close by when that is no longer allowed.
  void try_input(double input, double step) {
    Place place = on_branches({input, best_.place.output});
    auto score = score_at(place);
    for (int reach = 1; !score && reach <= 4; reach *= 2)
      for (const double side : {1.0, -1.0}) {
        if (score) break;
        place = on_branches({input, best_.place.output + side * reach * step});
        score = score_at(place);
      }
    if (!score) return;
    for (double move = step; move > 1e-3 * step;) {
      const Place here = place;
      const double before = *score;
      for (const double output : {here.output + move, here.output - move}) {
        const Place there = on_branches({input, output});
        const auto tried = score_at(there);
        if (!tried || !(*tried > *score)) continue;
        place = there;
        score = tried;
      }
      move *= *score > before ? 1.5 : 0.4;
    }
    if (*score > best_.score) best_ = {place, *score, false};
  }

  /// Branches are closed: leaving one at its end is entering it at its beginning.
  [[nodiscard]] Place on_branches(Place place) const {
    const double input = std::floor(start_.input), output = std::floor(start_.output);
    return {input + wrap_period(place.input - input, 1), output + wrap_period(place.output - output, 1)};
  }

  [[nodiscard]] std::optional<double> score_at(Place place) const {
    const auto bars = judge_.four_bar(place);
    if (!bars) return std::nullopt;
    const DefectReport report = judge_.report(*bars);
    if (report.type != type_ || change_point_margin(*bars) < least_margin_) return std::nullopt;
    return judge_.score(*bars, report);
  }

  const Judge& judge_;
  Place start_;
  Candidate best_;
  double first_step_;
  LinkageType type_ = LinkageType::degenerate;
  double least_margin_ = buildable_margin;
};

// Largest distance that a pivot moves between two linkages, the same bars in either driver's naming.
double distance(const FourBar& a, const FourBar& b) {
  const auto pivots = [](const FourBar& p, const FourBar& q) {
    return std::max({std::abs(p.input_center - q.input_center), std::abs(p.input_circle - q.input_circle),
                     std::abs(p.output_center - q.output_center), std::abs(p.output_circle - q.output_circle)});
  };
  return std::min(pivots(a, b), pivots(a, b.swapped()));
}

/// Of the two drivers of the same bars the better one: meeting the requirements, no defects, score, transmission angle,
/// smaller coordinate.
Candidate from_better_side(const Judge& judge, const Candidate& candidate) {
  const auto bars = judge.four_bar(candidate.place);
  const DefectReport here = judge.report(*bars), there = judge.report(bars->swapped());
  const auto there_score = judge.score(bars->swapped(), there);
  if (!there_score) return candidate;
  const Candidate swapped{{candidate.place.output, candidate.place.input}, *there_score, candidate.local_optimum};
  if (here.defects.none() != there.defects.none()) return here.defects.none() ? candidate : swapped;
  if (swapped.score != candidate.score) return swapped.score > candidate.score ? swapped : candidate;
  if (here.worst_transmission_cosine != there.worst_transmission_cosine)
    return there.worst_transmission_cosine < here.worst_transmission_cosine ? swapped : candidate;
  return candidate.place.input < candidate.place.output ? candidate : swapped;
}

class Choice {
 public:
  Choice(const Judge& judge, std::size_t wanted) : judge_(judge), wanted_(wanted) {}

  void offer(const Candidate& candidate, double least_difference) {
    const FourBar bars = *judge_.four_bar(candidate.place);
    for (const FourBar& other : bars_)
      if (distance(bars, other) < least_difference) return;
    candidates_.push_back(candidate);
    bars_.push_back(bars);
  }

  [[nodiscard]] bool full() const { return candidates_.size() >= wanted_; }

  [[nodiscard]] std::vector<Candidate> best_first() const {
    std::vector<Candidate> sorted = candidates_;
    std::sort(sorted.begin(), sorted.end(), [](const Candidate& a, const Candidate& b) {
      if (a.score != b.score) return a.score > b.score;
      return a.place.input != b.place.input ? a.place.input < b.place.input : a.place.output < b.place.output;
    });
    return sorted;
  }

 private:
  const Judge& judge_;
  std::size_t wanted_;
  std::vector<Candidate> candidates_;
  std::vector<FourBar> bars_;
};

std::vector<Candidate> candidates_at(const MotionSolution& solution, const Judge& judge,
                                     const std::vector<RankedCell>& cells) {
  std::vector<Candidate> found;
  for (const RankedCell& cell : cells) {
    const Place place{solution.region.input_dyads()[cell.row].coordinate,
                      solution.region.output_dyads()[cell.column].coordinate};
    // The map's numbers are single: a cell on the very edge of a requirement may fail here.
    const auto bars = judge.four_bar(place);
    if (!bars) continue;
    if (const auto score = judge.score(*bars, judge.report(*bars))) found.push_back({place, *score, false});
  }
  return found;
}

std::vector<Candidate> chosen(const MotionSolution& solution, const Judge& judge, const RequirementFilter& filter,
                              const Progress& progress) {
  constexpr std::size_t tiles = 48;
  const auto wanted = static_cast<std::size_t>(solution.options.best);
  const double first_step = solution.curve->coordinate_length() / static_cast<double>(solution.region.rows());
  const Objective objective = solution.options.objective;

  std::vector<Candidate> climbs;
  for (const Candidate& foot :
       candidates_at(solution, judge, hill_tops(solution.region, filter, objective, 3 * wanted))) {
    if (progress.is_cancelled()) return {};
    climbs.push_back(from_better_side(judge, Climb(judge, foot, first_step).top()));
  }
  std::sort(climbs.begin(), climbs.end(), [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
  Choice choice(judge, wanted);
  for (const Candidate& top : climbs)
    if (!choice.full()) choice.offer(top, different_design);
  if (!choice.full())
    for (const Candidate& other : candidates_at(solution, judge, tile_bests(solution.region, filter, objective, tiles)))
      if (!choice.full()) choice.offer(from_better_side(judge, other), clearly_different_design);
  return choice.best_first();
}

}  // namespace

std::vector<FourBarSolution> best_linkages(const MotionTask& task, const MotionSolution& solution,
                                           const RequirementFilter& filter, const Progress& progress) {
  if (solution.options.best == 0 || solution.meeting_requirements == 0) return {};
  const Judge judge(task, solution);
  const WorkingFrame& frame = solution.conditions.frame;
  std::vector<FourBarSolution> linkages;
  for (const Candidate& candidate : chosen(solution, judge, filter, progress)) {
    if (progress.is_cancelled()) return {};
    auto found = make_four_bar(task, frame, frame.to_user(solution.curve->dyad(candidate.place.input)),
                               frame.to_user(solution.curve->dyad(candidate.place.output)),
                               solution.requirements.respect_direction, true);
    if (!found) continue;
    found->local_optimum = candidate.local_optimum;
    linkages.push_back(*found);
  }
  return linkages;
}

}  // namespace linkwright
