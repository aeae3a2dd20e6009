#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "core/uniform.hpp"
#include "linkwright/algebra/line_search.hpp"
#include "linkwright/core/count_text.hpp"
#include "linkwright/core/parallel.hpp"
#include "linkwright/core/tolerance.hpp"
#include "linkwright/planar/six_bar_synthesis.hpp"
#include "planar/six_bar_glance.hpp"

namespace linkwright {
namespace {

constexpr std::int64_t draws_a_chain = 200;  // drawn for each that is to be tried, at most
constexpr double different_chain = 0.05;     // share of the box

bool contains_all(const Box& box, std::span<const Point> points) {
  return std::all_of(points.begin(), points.end(), [&](Point p) { return box.contains(p); });
}

Box common(const Box& x, const std::optional<Box>& y) {
  if (!y) return x;
  return {std::max(x.x_low, y->x_low), std::min(x.x_high, y->x_high), std::max(x.y_low, y->y_low),
          std::min(x.y_high, y->y_high)};
}

/// Where the chain's pivots may lie.
struct ChainBoxes {
  Box ground, moving;
  [[nodiscard]] bool empty() const {
    return !(ground.x_low <= ground.x_high && ground.y_low <= ground.y_high && moving.x_low <= moving.x_high &&
             moving.y_low <= moving.y_high);
  }
};

ThreeLinkChain drawn(std::mt19937_64& random, const ChainBoxes& boxes) {
  const auto point = [&](const Box& box) {
    const double x = uniform(random, box.x_low, box.x_high);
    return Point{x, uniform(random, box.y_low, box.y_high)};
  };
  ThreeLinkChain chain;
  chain.a = point(boxes.ground);
  chain.b = point(boxes.moving);
  chain.d = point(boxes.moving);
  return chain;
}

struct ChainInPositions {
  ThreeLinkChain chain;
  std::array<BodyPositions, 4> bodies;
};

/// What trying a chain showed.
struct Trial {
  bool done = false;  ///< not cut off by an interruption
  std::int64_t six_bars = 0, driven = 0, defect_free = 0;
  std::optional<SixBarProspect> best;
};

/// Tries chains against one task.
class Search {
 public:
  Search(const SixBarTask& task, const SixBarRow& row, const Box& box, const Requirements& wanted, Objective objective)
      : task_(task), row_(row), box_(box), wanted_(wanted), objective_(objective) {}

  /// The chain where it reaches all poses and has links of some length.
  [[nodiscard]] std::optional<ChainInPositions> in_positions(const ThreeLinkChain& chain) const;

  /// The best of some of the chain's six-bars. Only those are driven that could be it.
  [[nodiscard]] Trial trial(const ChainInPositions& chain) const;

  /// The same six-bar with chain and links moved to where random steps, shorter and shorter, find nothing better.
  [[nodiscard]] SixBarProspect refined(SixBarProspect here, std::uint64_t seed, const Progress& progress) const;

 private:
  struct Bounded {
    double bound = 0;
    SixBarMember member;
  };
  [[nodiscard]] bool is_in_box(const SixBarMember& member) const {
    return std::all_of(member.six_bar.joints.begin(), member.six_bar.joints.end(),
                       [&](const SixBarJoint& joint) { return box_.contains(joint.point); });
  }
  [[nodiscard]] std::optional<Bounded> bounded(const SixBarMember& member, const Requirements& wanted) const;
  [[nodiscard]] std::vector<Bounded> glanced_at(const ChainInPositions& chain, const Requirements& wanted,
                                                Trial& trial) const;
  /// The same six-bar by its coordinates on the curves of its chain; nothing where they have none.
  [[nodiscard]] std::optional<SixBarMember> on_curves(const SixBarFamily& family, const SixBarMember& member) const;
  /// Nothing where it does not better this score.
  [[nodiscard]] std::optional<SixBarProspect> prospect(const ThreeLinkChain& chain, std::array<double, 2> tau,
                                                       double to_better) const;

  const SixBarTask& task_;
  SixBarRow row_;
  Box box_;
  Requirements wanted_;
  Objective objective_;
};

std::optional<ChainInPositions> Search::in_positions(const ThreeLinkChain& chain) const {
  if (!contains_all(box_, std::array{chain.a, chain.b, chain.d})) return std::nullopt;
  const double least = tolerance::same_linkage * chain.size();
  if (!(chain.first_length() > least && chain.second_length() > least)) return std::nullopt;
  const auto bodies = chain_positions(task_.poses, chain);
  return bodies ? std::optional(ChainInPositions{chain, *bodies}) : std::nullopt;
}

/// A score that driving cannot better; nothing where it need not be driven.
std::optional<Search::Bounded> Search::bounded(const SixBarMember& member, const Requirements& wanted) const {
  const auto sine = sine_upper_bound(member.six_bar, member.turns);
  if (!sine && wanted.no_defects) return std::nullopt;
  SixBarRating best{shape_of(member.six_bar), {}};
  best.drive.completed = true;
  best.drive.min_sine = sine.value_or(0);
  if (!meets(wanted, member.six_bar, best)) return std::nullopt;
  return Bounded{score_of(objective_, best), member};
}

std::vector<Search::Bounded> Search::glanced_at(const ChainInPositions& chain, const Requirements& wanted,
                                                Trial& trial) const {
  const auto seen = SixBarGlance(row_.added, box_, wanted).look_at(chain.bodies);
  trial.six_bars = seen.six_bars;
  std::vector<Bounded> found;
  for (const auto& [link_4, link_5] : seen.promising) {
    const auto body = [&](int i) -> const BodyPositions& { return chain.bodies[static_cast<std::size_t>(i)]; };
    const auto positions = positions_of_link(link_4, body(row_.added[0].a), body(row_.added[0].b));
    const auto candidate =
        bounded(six_bar_member(chain.chain, row_.added, chain.bodies, link_4, positions, link_5), wanted);
    if (candidate) found.push_back(*candidate);
  }
  std::stable_sort(found.begin(), found.end(), [](const Bounded& x, const Bounded& y) { return x.bound > y.bound; });
  return found;
}

std::optional<SixBarMember> Search::on_curves(const SixBarFamily& family, const SixBarMember& member) const {
  const auto tau = [&](const AddedLinks& links, SixBar::JointIndex circle) {
    const Point seen = links.conditions.frame.to_working(member.six_bar.at(circle));
    return links.curve->coordinate_of(Homogeneous::of(seen));
  };
  const auto tau_4 = tau(family.first(), SixBar::z4);
  const auto first = tau_4 ? family.with_first(*tau_4) : std::nullopt;
  const auto tau_5 = first ? tau(*first->second, SixBar::z5) : std::nullopt;
  return tau_5 ? family.member(*first, *tau_5) : std::nullopt;
}

Trial Search::trial(const ChainInPositions& chain) const {
  Trial trial;
  const Requirements wanted = with_defaults(wanted_, chain.chain);
  const std::vector<Bounded> candidates = glanced_at(chain, wanted, trial);
  if (candidates.empty()) return trial;
  const SixBarFamily its_family(chain.chain, row_.added, chain.bodies);
  for (const Bounded& candidate : candidates) {
    if (trial.best && candidate.bound <= trial.best->score) break;
    const auto member = on_curves(its_family, candidate.member);
    if (!member || !is_in_box(*member)) continue;
    const SixBarRating rating = rating_of(*member, false);
    ++trial.driven;
    if (rating.drive.completed && rating.drive.defects.none()) ++trial.defect_free;
    if (!meets(wanted, member->six_bar, rating)) continue;
    const SixBarProspect found{chain.chain, member->coordinates, score_of(objective_, rating), *member, false};
    if (!trial.best || is_better(found, *trial.best)) trial.best = found;
  }
  return trial;
}

std::optional<SixBarProspect> Search::prospect(const ThreeLinkChain& chain, std::array<double, 2> tau,
                                               double to_better) const {
  const auto reached = in_positions(chain);
  if (!reached) return std::nullopt;
  const SixBarFamily its_family(chain, row_.added, reached->bodies);
  const auto first = its_family.with_first(tau[0]);
  if (!first || !contains_all(box_, first->hinges)) return std::nullopt;
  const auto member = its_family.member(*first, tau[1]);
  if (!member || !is_in_box(*member)) return std::nullopt;
  const Requirements wanted = with_defaults(wanted_, chain);
  const auto at_most = bounded(*member, wanted);
  if (!at_most || !is_real_gain(at_most->bound, to_better)) return std::nullopt;
  const SixBarRating rating = rating_of(*member, false);
  const double score = score_of(objective_, rating);
  if (!meets(wanted, member->six_bar, rating) || !is_real_gain(score, to_better)) return std::nullopt;
  return SixBarProspect{chain, tau, score, *member, false};
}

SixBarProspect Search::refined(SixBarProspect here, std::uint64_t seed, const Progress& progress) const {
  constexpr int failures_a_length = 40, steps_a_length = 2000;
  constexpr double first_length = 0.1, shortest = 3e-4;  // shares of the box, and of a branch of a curve
  std::mt19937_64 random(seed);
  const double width = box_.x_high - box_.x_low, height = box_.y_high - box_.y_low;
  for (double length = first_length; length > shortest && !progress.is_cancelled(); length /= 2)
    for (int steps = 0, failures = 0; steps < steps_a_length && failures < failures_a_length; ++steps) {
      if (progress.is_cancelled()) break;
      const auto step = [&](double size) { return length * size * uniform(random, -1, 1); };
      ThreeLinkChain chain = here.chain;
      for (Point* pivot : {&chain.a, &chain.b, &chain.d}) {
        const double x = step(width);
        *pivot += Point{x, step(height)};
      }
      const double tau_4 = here.tau[0] + step(1);
      const auto better = prospect(chain, {tau_4, here.tau[1] + step(1)}, here.score);
      if (better) here = *better;
      failures = better ? 0 : failures + 1;
    }
  here.local_optimum = true;
  return here;
}

/// The chains that reach all poses among the next ones drawn; as many as asked for unless few do.
std::vector<ChainInPositions> next_chains(const Search& search, const ChainBoxes& boxes, std::mt19937_64& random,
                                          std::size_t count, std::int64_t& drawn_so_far) {
  std::vector<ChainInPositions> chains;
  for (std::int64_t i = 0; chains.size() < count && i < draws_a_chain * static_cast<std::int64_t>(count); ++i) {
    const auto reached = search.in_positions(drawn(random, boxes));
    ++drawn_so_far;
    if (reached) chains.push_back(*reached);
  }
  return chains;
}

/// `any`: some six-bar meets the requirements, whether one was asked for or not.
Notice words(const SixBarSearchResult& result, bool any) {
  const auto count = [](std::string name, std::int64_t value) {
    return NamedValue{std::move(name), static_cast<double>(value)};
  };
  Notice notice{
      "searched",
      "",
      {count("chains", result.chains_tried), count("six_bars", result.six_bars),
       count("defect_free", result.defect_free), count("found", static_cast<std::int64_t>(result.linkages.size()))}};
  notice.message =
      fmt::format("{} chains that reach all poses were tried, with {} six-bars with all pivots in the box; ",
                  grouped_text(result.chains_tried), grouped_text(result.six_bars));
  if (result.chains_drawn == 0 && !result.interrupted) {
    notice.code = "no_chain";
    notice.message = "The box for the pivots and the boxes of the requirements have nothing in common.";
  } else if (result.chains_tried == 0 && !result.interrupted) {
    notice.code = "no_chain";
    notice.message = fmt::format("None of {} chains with pivots in the box reaches all poses; enlarge the box.",
                                 grouped_text(result.chains_drawn));
  } else if (!any) {
    notice.code = "nothing_found";
    notice.message +=
        "none is free of defects and meets all requirements. Enlarge the box, relax a requirement, add the "
        "links between other bodies, or raise the effort.";
  } else if (result.linkages.empty()) {
    notice.message += "some meet all requirements, and none was asked for.";
  } else {
    notice.message += fmt::format("the best {} were refined.", result.linkages.size());
  }
  if (result.interrupted) notice.message += " The search was interrupted: this is the best so far.";
  return notice;
}

void keep_best(std::vector<SixBarProspect>& held, std::size_t most, double least) {
  std::sort(held.begin(), held.end(), is_better);
  held = distinct(held, most, least);
}

}  // namespace

SixBarSearchResult search_six_bars(const SixBarTask& task, const Requirements& requirements, const SixBarChoice& choice,
                                   const SixBarSearchOptions& options, const Progress& progress) {
  constexpr std::size_t chunk = 64;  // chains between two looks at the progress; no part of the answer
  constexpr double share_of_trials = 0.7;
  SixBarSearchResult result;
  const auto row = six_bar_row(task.added);
  if (!row || !task.box) return result;
  const Box box = *task.box;
  const Search search(task, *row, box, requirements, choice.objective);
  const double least = different_chain * std::hypot(box.x_high - box.x_low, box.y_high - box.y_low);
  const std::size_t kept = 2 * static_cast<std::size_t>(std::max(choice.best, 0)) + 4;
  const auto effort = static_cast<std::int64_t>(std::max(options.effort, 0));

  const ChainBoxes boxes = {common(box, requirements.ground_pivots_within),
                            common(box, requirements.moving_pivots_within)};
  std::mt19937_64 random(options.seed);
  std::vector<SixBarProspect> held;
  while (!boxes.empty() && result.chains_tried < effort && !progress.is_cancelled()) {
    const auto count = static_cast<std::size_t>(std::min<std::int64_t>(chunk, effort - result.chains_tried));
    const auto chains = next_chains(search, boxes, random, count, result.chains_drawn);
    if (chains.empty()) break;
    std::vector<Trial> trials(chains.size());
    parallel_for(chains.size(), choice.threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end && !progress.is_cancelled(); ++i) {
        trials[i] = search.trial(chains[i]);
        trials[i].done = true;
      }
    });
    for (const Trial& trial : trials) {
      result.chains_tried += trial.done ? 1 : 0;
      result.six_bars += trial.six_bars;
      result.driven += trial.driven;
      result.defect_free += trial.defect_free;
      if (trial.best) held.push_back(*trial.best);
    }
    keep_best(held, kept, least);
    progress(share_of_trials * static_cast<double>(result.chains_tried) / static_cast<double>(effort));
  }
  parallel_for(held.size(), choice.threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) held[i] = search.refined(held[i], options.seed + i + 1, progress);
  });
  result.interrupted = progress.is_cancelled();
  const bool any = !held.empty();
  keep_best(held, static_cast<std::size_t>(std::max(choice.best, 0)), least);
  result.linkages = driven_exactly(held, task, *row, requirements, choice);
  if (result.interrupted)
    for (SixBarSolution& found : result.linkages) found.local_optimum = false;
  result.reason = words(result, any);
  if (!result.interrupted) progress(1);
  return result;
}

}  // namespace linkwright
