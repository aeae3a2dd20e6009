#include "linkwright/straight_line/straight_line_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "line_cases.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/parallel.hpp"
#include "linkwright/region/cell_judge.hpp"
#include "straight_line/line_estimate.hpp"
#include "straight_line/placed_shape.hpp"

namespace linkwright {
namespace {

constexpr std::int64_t draws = 24'000;  // of each kind, effort 1
constexpr std::size_t chunk = 1'000;    // drawn from one seed
constexpr std::size_t starts = 10;      // of each kind, made better, effort 1; more of them where more is drawn
constexpr std::size_t guesses = 5;      // of the atlas, of each kind
// Shares of the longest link: by which designs differ, and by which starts do, so that they climb different hills.
constexpr double different = 0.03, far_apart = 0.25;

double share(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

// A linkage of a shape, estimated: of unit size, its strip as long as its deviation's share of the stroke lets it be.
struct Prospect {
  LineShape shape;
  int layer = 0;
  TracingFourBar linkage;
  double strip = 0, middle = 0;  // of the unit linkage
  double score = 0;
};

bool better(const Prospect& a, const Prospect& b) { return a.score > b.score; }

struct Drawn {
  LineShape shape;
  int layer = 0;
  TracingFourBar linkage;
  double width = 0;  // of the strip, half of it
  LineEstimate estimate{};
};
constexpr double infinite = std::numeric_limits<double>::infinity();

// The best lie at the limits, where an estimate may take what is just beyond them.
Requirements with_room(Requirements wanted, double stroke) {
  constexpr double room = 0.01, angle = radians(1);
  for (std::optional<Box>* box : {&wanted.ground_pivots_within, &wanted.moving_pivots_within}) {
    if (!*box) continue;
    const double x = std::min(room * stroke, 0.1 * ((*box)->x_high - (*box)->x_low)),
                 y = std::min(room * stroke, 0.1 * ((*box)->y_high - (*box)->y_low));
    *box = Box{(*box)->x_low + x, (*box)->x_high - x, (*box)->y_low + y, (*box)->y_high - y};
  }
  if (wanted.min_transmission_angle > 0) wanted.min_transmission_angle += angle;
  if (wanted.max_length) *wanted.max_length *= 1 - room;
  return wanted;
}

// What is looked for, and what judges it. Scaled to the stroke all have the deviation asked for: the longest strip for
// its size is the straightest, too.
class Wish {
 public:
  Wish(const DirectedLine& line, const straight_cases::Search& wanted, const Requirements& requirements,
       Objective objective)
      : line_(line),
        wanted_(wanted),
        requirements_(requirements),
        objective_(objective == Objective::deviation ? Objective::stroke : objective),
        rank_(rank_of(objective_, straight_line_measures)),
        shape_(of_shape(requirements), straight_line_linkages, straight_line_measures),
        rest_(beside_shape(requirements), straight_line_linkages, straight_line_measures) {}

  [[nodiscard]] double stroke() const { return wanted_.stroke; }
  [[nodiscard]] double deviation() const { return wanted_.deviation; }
  [[nodiscard]] double share_of_stroke() const { return wanted_.deviation / wanted_.stroke; }
  [[nodiscard]] const DirectedLine& line() const { return line_; }
  [[nodiscard]] LineMeasuring measuring() const { return {wanted_.deviation, wanted_.stroke, LineMeasure::strip}; }

  // Of a type and of proportions that are asked for, whatever its size.
  [[nodiscard]] bool has_shape(const TracingFourBar& linkage) const {
    return shape_.may_pass(line_cell(linkage, LineWorth::unknown()));
  }
  // Of the strip over the longest link, below which a linkage is too long or, by what ranks, not among the best.
  [[nodiscard]] double least_strip() const { return wanted_.stroke / requirements_.max_length.value_or(infinite); }
  // Beside which a longer strip may do worse.
  [[nodiscard]] bool has_limits() const {
    return requirements_.ground_pivots_within || requirements_.moving_pivots_within ||
           requirements_.min_transmission_angle > 0;
  }
  [[nodiscard]] bool longest_strip_wins() const {
    return objective_ == Objective::stroke || objective_ == Objective::size;
  }
  // Nothing where it does not do what is asked for; as it is scaled and moved to the line.
  [[nodiscard]] std::optional<double> score(const TracingFourBar& linkage, const LineWorth& worth) const {
    const Cell cell = line_cell(linkage, worth);
    return rest_.passes(cell) ? std::optional(rank_.score(cell)) : std::nullopt;
  }

 private:
  static Requirements of_shape(const Requirements& wanted) {
    Requirements shape;
    shape.types = wanted.types;
    shape.max_link_ratio = wanted.max_link_ratio;
    return shape;
  }
  static Requirements beside_shape(Requirements wanted) {
    wanted.types.clear();
    wanted.max_link_ratio = Requirements::unlimited;
    return wanted;
  }

  DirectedLine line_;
  straight_cases::Search wanted_;
  Requirements requirements_;
  Objective objective_;
  Rank rank_;
  CellJudge shape_, rest_;
};

// Of the linkage at unit size, whose line is the x axis and whose strip is to come to the middle of the wish's line.
TracingFourBar at_its_place(const Wish& wish, const TracingFourBar& unit, double strip, Point middle) {
  const double scale = wish.stroke() / strip;
  const auto there = [&](Point p) { return wish.line().to_fixed(scale * (p - middle)); };
  const FourBar& bars = unit.bars;
  return {{there(bars.input_fixed), there(bars.input_moving), there(bars.output_fixed), there(bars.output_moving)},
          there(unit.point)};
}

// How straight a linkage runs depends on the share of the stroke alone: the strip whose width is that share of its own
// length, by fixed points of length over width, which grows with a root of it.
class Estimator {
 public:
  Estimator(const Wish& wish, ShapeKind kind) : wish_(wish), task_(placed(LineShape{kind, {}, 0}).task) {}

  [[nodiscard]] std::vector<Prospect> prospects(std::vector<Drawn> drawn) const {
    // Together those whose lines run the same way.
    std::stable_sort(drawn.begin(), drawn.end(),
                     [](const Drawn& a, const Drawn& b) { return is_reversed(a) < is_reversed(b); });
    constexpr double first_guess = 0.5;  // of the strip over the longest link, which hardly any shape comes to
    for (Drawn& one : drawn) one.width = first_guess * one.linkage.longest() * wish_.share_of_stroke();
    estimate(drawn);
    leave_out_short_ones(drawn, first_guess);
    for (int turn = 0; turn < 2; ++turn) {
      for (Drawn& one : drawn)
        one.width = std::max(one.estimate.usable_strip, 1e-6 * one.linkage.longest()) * wish_.share_of_stroke();
      estimate(drawn);
    }
    std::vector<Prospect> found;
    for (const Drawn& one : drawn) add(one, found);
    return found;
  }

 private:
  static bool is_reversed(const Drawn& one) { return (one.shape.turns & 2) != 0; }

  // A strip that is shorter than guessed is shorter yet when its width is made the share of its length.
  void leave_out_short_ones(std::vector<Drawn>& drawn, double guess) const {
    const std::size_t kept = (wish_.has_limits() ? 64 : 8) * starts;
    const auto share = [](const Drawn& one) { return one.estimate.usable_strip / one.linkage.longest(); };
    std::erase_if(drawn, [&](const Drawn& one) { return share(one) < std::min(wish_.least_strip(), guess); });
    if (!wish_.longest_strip_wins() || drawn.size() <= kept) return;
    std::vector<double> shares;
    for (const Drawn& one : drawn) shares.push_back(share(one));
    std::nth_element(shares.begin(), shares.begin() + static_cast<std::ptrdiff_t>(kept), shares.end(),
                     std::greater<>());
    const double least = std::min(shares[kept], guess);
    std::erase_if(drawn, [&](const Drawn& one) { return share(one) < least; });
  }

  void estimate(std::vector<Drawn>& drawn) const {
    const auto forward =
        static_cast<std::size_t>(std::find_if(drawn.begin(), drawn.end(), is_reversed) - drawn.begin());
    const std::span<Drawn> all(drawn);
    estimate(all.first(forward), {1, 0});
    estimate(all.subspan(forward), {-1, 0});
  }
  void estimate(std::span<Drawn> some, Point along) const {
    std::vector<TracingFourBar> linkages;
    std::vector<double> widths;
    for (const Drawn& one : some) {
      linkages.push_back(one.linkage);
      widths.push_back(one.width);
    }
    std::vector<LineEstimate> estimates(some.size());
    const LineEstimateTask asked{
        along, promised_contact(task_.given), {std::nullopt, std::nullopt, LineMeasure::strip}};
    estimate_lines(linkages, asked, estimates, widths);
    for (std::size_t i = 0; i < some.size(); ++i) some[i].estimate = estimates[i];
  }

  void add(const Drawn& drawn, std::vector<Prospect>& found) const {
    const LineEstimate& estimate = drawn.estimate;
    const double strip = estimate.usable_strip, longest = drawn.linkage.longest();
    if (!(strip > 1e-6 * longest)) return;
    const double middle = estimate.strip_middle;
    const Point along = is_reversed(drawn) ? -1 : 1;
    LineWorth worth = estimate.worth(LineMeasure::strip);
    worth.usable = wish_.stroke();
    worth.deviation = wish_.deviation();
    const auto score =
        wish_.score(at_its_place(wish_, drawn.linkage, strip, drawn.linkage.point + middle * along), worth);
    if (!score) return;
    found.push_back({drawn.shape, drawn.layer, drawn.linkage, strip, middle, *score});
  }

  const Wish& wish_;
  StraightLineTask task_;
};

void add_designs(const LineShape& shape, const Wish& wish, std::vector<Drawn>& drawn) {
  const LineDesigns designs = designs_of_shape(placed(shape));
  const int layers = shape.kind == ShapeKind::symmetric_lambda ? 1 : 3;  // of λs the better
  for (int layer = 0; layer < layers; ++layer) {
    const LineDesign& design = designs[static_cast<std::size_t>(layer)];
    if (design.kind == DesignKind::four_bar && wish.has_shape(design.linkage))
      drawn.push_back({shape, layer, design.linkage});
  }
}

// Those known that do what is asked for, best first.
std::vector<Prospect> guessed(ShapeKind kind, const std::vector<AtlasLinkage>& known, const Wish& wish) {
  std::vector<Drawn> linkages;
  for (const auto& [shape, layer] : known) {
    const LineDesign design = designs_of_shape(placed(shape))[static_cast<std::size_t>(layer)];
    if (design.kind == DesignKind::four_bar && wish.has_shape(design.linkage))
      linkages.push_back({shape, layer, design.linkage});
  }
  auto prospects = Estimator(wish, kind).prospects(std::move(linkages));
  std::stable_sort(prospects.begin(), prospects.end(), better);
  return prospects;
}

std::vector<AtlasLinkage> classics(ShapeKind kind) {
  std::vector<AtlasLinkage> known;
  for (const LineShape& shape : line_classics(kind)) known.push_back({shape, 0});
  return known;
}

TracingFourBar seen(const Wish& wish, const Prospect& of) {
  const Point along = (of.shape.turns & 2) != 0 ? -1 : 1;
  return at_its_place(wish, of.linkage, of.strip, of.linkage.point + of.middle * along);
}

bool alike(const TracingFourBar& a, const TracingFourBar& b, double share = different) {
  return farthest_pivot(a.bars, b.bars) < share * std::max(a.longest(), b.longest());
}

// The best of all that came by, no two of them alike.
class Collection {
 public:
  Collection(const Wish& wish, std::size_t most, double apart) : wish_(wish), most_(most), apart_(apart) {}

  void add(const Prospect& next) {
    if (kept_.size() == most_ && !better(next, kept_.back().prospect)) return;
    const Kept one{next, seen(wish_, next)};
    const auto place = std::upper_bound(kept_.begin(), kept_.end(), one,
                                        [](const Kept& a, const Kept& b) { return better(a.prospect, b.prospect); });
    const auto looks_alike = [&](const Kept& other) { return alike(one.place, other.place, apart_); };
    if (std::any_of(kept_.begin(), place, looks_alike)) return;
    const auto worse = kept_.insert(place, one) + 1;
    kept_.erase(std::remove_if(worse, kept_.end(), looks_alike), kept_.end());
    if (kept_.size() > most_) kept_.pop_back();
  }
  void add(const std::vector<Prospect>& some) {
    for (const Prospect& next : some) add(next);
  }
  /// Best first.
  [[nodiscard]] std::vector<Prospect> prospects() const {
    std::vector<Prospect> found;
    for (const Kept& one : kept_) found.push_back(one.prospect);
    return found;
  }

 private:
  struct Kept {
    Prospect prospect;
    TracingFourBar place;
  };

  const Wish& wish_;
  std::size_t most_;
  double apart_;
  std::vector<Kept> kept_;
};

std::vector<Prospect> without_likes(const std::vector<Prospect>& some, std::size_t most, double apart,
                                    const Wish& wish) {
  Collection kept(wish, most, apart);
  kept.add(some);
  return kept.prospects();
}

// The best of `count` shapes drawn from one seed that are far apart.
struct Harvest {
  std::vector<Prospect> best;
  std::int64_t drawn = 0;
};

Harvest draw(ShapeKind kind, std::uint64_t seed, std::size_t count, const Wish& wish) {
  std::mt19937_64 random(seed);
  std::vector<Drawn> drawn;
  for (std::size_t i = 0; i < count; ++i) {
    LineShape shape{kind, {}, static_cast<unsigned>(random() >> 61)};
    for (std::size_t k = 0; k < number_count(kind); ++k) shape.numbers[k] = share(random);
    add_designs(shape, wish, drawn);
  }
  const auto found = Estimator(wish, kind).prospects(std::move(drawn));
  return {without_likes(found, 2 * starts, far_apart, wish), static_cast<std::int64_t>(count)};
}

// Tries places around the best so far, closer and closer.
Prospect made_better(Prospect best, std::uint64_t seed, const Wish& wish, const Progress& progress) {
  constexpr double first_step = 0.08, last_step = 1e-5, most_step = 0.15;
  constexpr int rounds = 80;
  constexpr std::size_t tries = 16;  // two packs of the widest lanes
  std::mt19937_64 random(seed);
  double step = first_step;
  for (int round = 0; round < rounds && step > last_step && !progress.is_cancelled(); ++round) {
    std::vector<Drawn> drawn;
    for (std::size_t i = 0; i < tries; ++i) {
      LineShape shape = best.shape;
      for (std::size_t k = 0; k < number_count(shape.kind); ++k)
        shape.numbers[k] = std::clamp(shape.numbers[k] + step * (2 * share(random) - 1), 0.0, 1.0);
      const LineDesign design = designs_of_shape(placed(shape))[static_cast<std::size_t>(best.layer)];
      if (design.kind == DesignKind::four_bar && wish.has_shape(design.linkage))
        drawn.push_back({shape, best.layer, design.linkage});
    }
    const auto found = Estimator(wish, best.shape.kind).prospects(std::move(drawn));
    const auto top = std::min_element(found.begin(), found.end(), better);
    const bool improves = top != found.end() && top->score > best.score;
    if (improves) best = *top;
    step = improves ? std::min(1.3 * step, most_step) : 0.6 * step;
  }
  return best;
}

// The prospect measured exactly, scaled and moved; nothing where that shows that it does not do it.
std::optional<StraightLineSolution> measured(const Prospect& of, const Wish& wish) {
  const PlacedShape unit = placed(of.shape);
  const Point along = unit.task.line.direction;
  PathLimits limits;
  limits.max_deviation = 8 * wish.share_of_stroke() * of.strip;
  const auto path = StraightPath::of(of.linkage, along, limits);
  if (!path) return std::nullopt;
  UsableLine strip;
  double length = of.strip;
  constexpr int turns = 12;
  constexpr double settled = 1e-7, a_hair = 1e-6;  // the scale has so much room
  for (int turn = 0; turn < turns; ++turn) {
    strip = path->usable_strip(wish.share_of_stroke() * length);
    const bool ends = std::abs(strip.length() - length) < settled * length;
    length = strip.length();
    if (ends) break;
    if (!(length > 0)) return std::nullopt;
  }
  const auto figures = path->stroke_figures(strip.from, strip.to);
  if (!figures) return std::nullopt;
  const double middle = (strip.from + strip.to) / 2, scale = (1 + a_hair) * wish.stroke() / length;
  const double off = figures->middle_deviation;  // that comes to the line
  const Point center = of.linkage.point + along * Point{middle, off};
  const PlacedShape there = moved(unit, scale, wish.line(), -scale * center);
  const StraightLineFamily family(there.task, wish.measuring());
  const auto axes = axes_of(there.task);
  MapNumbers place{of.layer, there.at};
  for (std::size_t i = 0; i < 2; ++i)
    if (is_angle(axes[i].quantity)) place.at[i] = degrees(place.at[i]);
  const auto point = family.point_of(place);
  auto found = point ? make_straight_line(family, *point) : std::nullopt;
  if (found && !found->defects.none()) return std::nullopt;
  if (!found || !wish.has_shape(found->linkage)) return std::nullopt;
  const double mid = (found->usable_strip.from + found->usable_strip.to) / 2;
  if (!(found->usable_strip.length() >= wish.stroke())) return std::nullopt;
  PathLimits reach;
  reach.from = found->usable_strip.from;
  reach.to = found->usable_strip.to;
  const auto exact = StraightPath::of(found->linkage, there.task.line.direction, reach);
  if (exact) found->stroke = exact->stroke(mid - wish.stroke() / 2, mid + wish.stroke() / 2);
  found->shape = of.shape;
  found->local_optimum = true;
  return found->stroke ? found : std::nullopt;
}

std::optional<double> score_of(const StraightLineSolution& found, const Wish& wish) {
  LineWorth worth = LineWorth::of(*found.stroke, found.stroke->parallel_line_deviation);
  worth.usable = wish.stroke();  // but for the rounding of its ends
  return wish.score(found.linkage, worth);
}

struct Ranked {
  StraightLineSolution found;
  double score = 0;
};

// Best first; no case more often than a third of the list while others are left.
std::vector<StraightLineSolution> listed(std::vector<Ranked> all, std::size_t most) {
  std::stable_sort(all.begin(), all.end(), [](const Ranked& a, const Ranked& b) { return a.score > b.score; });
  std::vector<Ranked> kept;
  std::vector<Ranked> rest;
  const std::size_t of_a_case = std::max<std::size_t>(2, most / 3);
  for (Ranked& next : all) {
    if (std::any_of(kept.begin(), kept.end(),
                    [&](const Ranked& other) { return alike(next.found.linkage, other.found.linkage); }))
      continue;
    const auto same = std::count_if(kept.begin(), kept.end(), [&](const Ranked& other) {
      return other.found.task.given.index() == next.found.task.given.index();
    });
    (static_cast<std::size_t>(same) < of_a_case ? kept : rest).push_back(std::move(next));
  }
  for (Ranked& next : rest)
    if (kept.size() < most) kept.push_back(std::move(next));
  std::stable_sort(kept.begin(), kept.end(), [](const Ranked& a, const Ranked& b) { return a.score > b.score; });
  std::vector<StraightLineSolution> linkages;
  for (Ranked& one : kept)
    if (linkages.size() < most) linkages.push_back(std::move(one.found));
  return linkages;
}

// What is drawn of each kind: the starts of climbs, the more the longer the search.
struct Gathered {
  std::vector<Collection> best;
  std::int64_t drawn = 0;

  Gathered(const Wish& wish, double effort)
      : best(shape_kind_count,
             {wish, std::max(starts, static_cast<std::size_t>(std::lround(starts * effort))), far_apart}) {}

  void add(std::size_t kind, const Harvest& harvest) {
    best[kind].add(harvest.best);
    drawn += harvest.drawn;
  }
};

Gathered gathered(const Wish& wish, const StraightLineSearchOptions& options, const Progress& progress) {
  constexpr std::size_t at_once = 32;  // chunks between two reports
  const auto of_kind = static_cast<std::size_t>(std::ceil(draws * options.effort / static_cast<double>(chunk)));
  const std::size_t chunks = shape_kind_count * of_kind;
  Gathered all(wish, options.effort);
  for (std::size_t begin = 0; begin < chunks && !progress.is_cancelled(); begin += at_once) {
    std::vector<Harvest> harvests(std::min(at_once, chunks - begin));
    const auto kind_of = [&](std::size_t i) { return (begin + i) % shape_kind_count; };
    parallel_for(harvests.size(), options.threads, [&](std::size_t from, std::size_t to) {
      for (std::size_t i = from; i < to && !progress.is_cancelled(); ++i)
        harvests[i] = draw(static_cast<ShapeKind>(kind_of(i)),
                           options.seed * 1'000'003 + static_cast<std::uint64_t>(begin + i), chunk, wish);
    });
    for (std::size_t i = 0; i < harvests.size(); ++i) all.add(kind_of(i), harvests[i]);
    progress(0.6 * static_cast<double>(begin + harvests.size()) / static_cast<double>(chunks));
  }
  return all;
}

// The best of each kind, drawn and known, climbed; best first, without likes.
std::vector<Prospect> climbed_prospects(const Gathered& all, const Wish& wish, const StraightLineSearchOptions& options,
                                        const Progress& progress) {
  std::vector<Prospect> prospects;
  const auto add = [&](const std::vector<Prospect>& some) {
    prospects.insert(prospects.end(), some.begin(), some.end());
  };
  for (std::size_t kind = 0; kind < all.best.size(); ++kind) {
    const auto of = static_cast<ShapeKind>(kind);
    add(all.best[kind].prospects());
    add(without_likes(guessed(of, line_atlas(of), wish), guesses, far_apart, wish));
    add(guessed(of, classics(of), wish));
  }
  parallel_for(prospects.size(), options.threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      prospects[i] = made_better(prospects[i], options.seed + i, wish, progress);
  });
  return without_likes(prospects, std::max<std::size_t>(3 * static_cast<std::size_t>(options.best), 12), different,
                       wish);
}

std::vector<Ranked> measured_prospects(const std::vector<Prospect>& prospects, const Wish& wish, int threads) {
  std::vector<std::optional<StraightLineSolution>> made(prospects.size());
  parallel_for(made.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) made[i] = measured(prospects[i], wish);
  });
  std::vector<Ranked> ranked;
  for (auto& found : made)
    if (const auto score = found ? score_of(*found, wish) : std::nullopt) ranked.push_back({*std::move(found), *score});
  return ranked;
}

}  // namespace

StraightLineSearchResult search_straight_lines(const DirectedLine& line, const straight_cases::Search& wanted,
                                               const Requirements& requirements,
                                               const StraightLineSearchOptions& options, const Progress& progress) {
  const Wish wish(line, wanted, with_room(requirements, wanted.stroke), options.objective),
      exact(line, wanted, requirements, options.objective);
  const Gathered all = gathered(wish, options, progress);
  const auto prospects = climbed_prospects(all, wish, options, progress);
  progress(0.8);
  StraightLineSearchResult result;
  result.drawn = all.drawn;
  result.linkages =
      listed(measured_prospects(prospects, exact, options.threads), static_cast<std::size_t>(options.best));
  result.interrupted = progress.is_cancelled();
  progress(1);
  return result;
}

}  // namespace linkwright
