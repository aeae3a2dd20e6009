#include "chosen_length.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

#include "linkwright/algebra/line_search.hpp"
#include "linkwright/core/precondition.hpp"
#include "region/window_look.hpp"

namespace linkwright {
namespace {

// How much the linkages of a length have to offer; the larger is the better one.
struct LengthSummary {
  double best_score = no_score;
  std::int64_t meeting = 0, failing_one = 0, defect_free = 0, whole = 0;
  /// How far from their windows the hinges of the nearest linkage lie that meets all else, user's unit.
  double off_windows = std::numeric_limits<double>::infinity();

  [[nodiscard]] bool has_linkage() const { return best_score > no_score; }
  [[nodiscard]] bool beats(const LengthSummary& other) const {
    const auto rank = [](const LengthSummary& s) {
      return std::tie(s.best_score, s.meeting, s.failing_one, s.defect_free, s.whole);
    };
    return rank(*this) > rank(other);
  }
};

/// Tries lengths, the best so far in hand.
class LengthTrials {
 public:
  LengthTrials(const FamilyOfLength& family_of, const Requirements& requirements, Objective objective,
               const Progress& progress)
      : family_of_(family_of),
        progress_(progress),
        requirements_(requirements),
        // Tolerances are measured of one map, that of the length chosen.
        objective_(is_of_analysis(objective) ? Objective::min_transmission_angle : objective) {}

  LengthSummary try_length(double length) {
    const LengthSummary summary = summary_of(*family_of_(length));
    if (tried_.empty() || summary.beats(best_)) {
      best_ = summary;
      length_ = length;
    }
    tried_.push_back({length, summary.off_windows});
    return summary;
  }

  /// At least one is tried.
  [[nodiscard]] bool goes_on() const { return tried_.empty() || !progress_.is_cancelled(); }
  [[nodiscard]] bool has_linkage() const { return best_.has_linkage(); }
  [[nodiscard]] double best_score() const { return best_.best_score; }
  [[nodiscard]] double length() const { return length_; }
  [[nodiscard]] int tried() const { return static_cast<int>(tried_.size()); }
  [[nodiscard]] std::int64_t meeting() const { return best_.meeting; }

  struct Tried {
    double length, off_windows;
  };
  /// Those whose linkages come nearest to the windows, at most so many.
  [[nodiscard]] std::vector<Tried> nearest_to_windows(std::size_t most) const {
    std::vector<Tried> nearest;
    for (const Tried& one : tried_)
      if (std::isfinite(one.off_windows)) nearest.push_back(one);
    std::sort(nearest.begin(), nearest.end(), [](const Tried& a, const Tried& b) {
      return std::tie(a.off_windows, a.length) < std::tie(b.off_windows, b.length);
    });
    nearest.resize(std::min(nearest.size(), most));
    return nearest;
  }

 private:
  static constexpr std::size_t followed = 6;  // of many lengths each is looked at less closely
  static constexpr bool doubts_samples = false;

  [[nodiscard]] LengthSummary summary_of(const FourBarFamily& family) {
    const std::vector<double> input = family.samples(Side::input, ChosenLength::samples, Spacing::coordinate),
                              output = family.samples(Side::output, ChosenLength::samples, Spacing::coordinate);
    if (input.empty() || output.empty()) return {};
    const MapMaking making{[&](RegionMap& map, std::span<const double> rows, std::span<const double> columns) {
                             family.classify(map, rows, columns, requirements_.respect_direction, {}, progress_);
                           },
                           ChosenLength::samples,
                           {},
                           followed,
                           doubts_samples};
    making.fill(map_, input, output);
    const RequirementFilter filter = filter_of(family, map_, requirements_);
    LengthSummary summary;
    const RegionCounts counts = map_.counts();
    summary.defect_free = counts.defect_free;
    summary.whole = counts.pairs - counts.types[static_cast<std::size_t>(LinkageType::degenerate)];
    const MapPoint step = {family.axis(Side::input).coordinate_length() / static_cast<double>(input.size()),
                           family.axis(Side::output).coordinate_length() / static_cast<double>(output.size())};
    add({&map_, &filter, step}, summary);
    if (summary.meeting == 0)
      for (const auto& closer :
           look_into_windows(family, {&map_, &filter, step}, requirements_, making, progress_).maps)
        add(closer->view(), summary);
    return summary;
  }

  void add(const SearchMap& of, LengthSummary& summary) const {
    const RequirementCensus census = of.filter->census();
    summary.meeting += census.meeting;
    for (const auto& [set, cells] : census.failing)
      if (std::has_single_bit(set)) summary.failing_one += cells;
    if (const auto best = tile_bests(*of.map, *of.filter, objective_, 1); !best.empty())
      summary.best_score = std::max(summary.best_score, best.front().score);
    if (requirements_.ground_pivots_within || requirements_.moving_pivots_within)
      summary.off_windows = std::min(summary.off_windows, off_windows(of));
  }

  [[nodiscard]] double off_windows(const SearchMap& of) const {
    const std::size_t columns = of.map->columns();
    std::vector<FailureBits> failures(of.map->rows() * columns);
    of.filter->failures_of_all(failures, progress_);
    unsigned places = 0;
    for (const RequirementKind kind : {RequirementKind::ground_pivots_within, RequirementKind::moving_pivots_within})
      places |= 1U << place_among(of.filter->kinds(), kind);
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t cell = 0; cell < failures.size(); ++cell)
      if ((failures[cell] & ~places) == 0)
        nearest = std::min(nearest, of.filter->distance_to_windows(cell / columns, cell % columns));
    return nearest;
  }

  const FamilyOfLength& family_of_;
  const Progress& progress_;
  const Requirements& requirements_;
  Objective objective_;
  RegionMap map_;
  LengthSummary best_;
  double length_ = 0;
  std::vector<Tried> tried_;
};

/// Lengths in equal ratios by their share of the way from the shortest to the longest.
class LengthScale {
 public:
  explicit LengthScale(const LengthRange& range) : range_(range), whole_(std::log(range[1] / range[0])) {}

  [[nodiscard]] bool is_single() const { return !(whole_ > 0); }
  [[nodiscard]] double share(double length) const { return std::log(length / range_[0]) / whole_; }
  /// The longest itself, not what rounding makes of it: there may be linkages at the limit.
  [[nodiscard]] double length(double share) const {
    return share >= 1 ? range_[1] : std::min(range_[1], range_[0] * std::exp(whole_ * share));
  }

 private:
  LengthRange range_;
  double whole_;
};

struct Score {
  double score;
};

/// From the lengths whose linkages come nearest to the windows to those beside them, nearer and nearer: what stands in
/// small windows may do so at lengths between any two in a row.
void approach_windows(LengthTrials& trials, const LengthScale& scale, double step) {
  constexpr std::size_t followed = 4;
  constexpr int turns = 12;
  constexpr double resolution = 1e-3;  // of a step
  for (const auto& [length, off] : trials.nearest_to_windows(followed)) {
    const auto at = [&](double there, const LinePlace<Score>& /*best*/) -> std::optional<Score> {
      if (!(there >= 0 && there <= 1) || trials.has_linkage() || !trials.goes_on()) return std::nullopt;
      return Score{-trials.try_length(scale.length(there)).off_windows};
    };
    static_cast<void>(
        climb_line(LinePlace<Score>{scale.share(length), {-off}}, {step / 2, resolution * step, turns}, at));
  }
}

/// To the length whose best linkage is best.
void climb(LengthTrials& trials, const LengthScale& scale, double step) {
  constexpr int turns = 16;
  constexpr double resolution = 0.02;  // of a step: lengths that near have the same best linkage to a part in a hundred
  const auto at = [&](double there, const LinePlace<Score>& /*best*/) -> std::optional<Score> {
    if (!(there >= 0 && there <= 1) || !trials.goes_on()) return std::nullopt;
    const LengthSummary found = trials.try_length(scale.length(there));
    return found.has_linkage() ? std::optional(Score{found.best_score}) : std::nullopt;
  };
  static_cast<void>(climb_line(LinePlace<Score>{scale.share(trials.length()), {trials.best_score()}},
                               {step / 4, resolution * step, turns}, at));
}

LengthRange common(const LengthRange& a, const LengthRange& b) { return {std::max(a[0], b[0]), std::min(a[1], b[1])}; }

/// Of the dyads with a pivot in the box; an empty range where none of those looked at is finite.
LengthRange lengths_with_pivot_in(const Box& box, PivotKind kind, const ThreePoseDyads& dyads,
                                  const WorkingFrame& frame) {
  constexpr int sides = 12;
  constexpr double wider = 0.1;  // what lies between places looked at
  LengthRange found = {std::numeric_limits<double>::infinity(), 0};
  for (int i = 0; i <= sides; ++i)
    for (int j = 0; j <= sides; ++j) {
      const Point place{std::lerp(box.x_low, box.x_high, static_cast<double>(i) / sides),
                        std::lerp(box.y_low, box.y_high, static_cast<double>(j) / sides)};
      const auto dyad = dyads.dyad_with(kind, frame.to_working(Homogeneous::of(place)));
      const auto center = dyad ? finite_point(dyad->center) : std::nullopt,
                 circle = dyad ? finite_point(dyad->circle) : std::nullopt;
      if (!center || !circle) continue;
      const double length = frame.scale * std::abs(*circle - *center);
      found = {std::min(found[0], length), std::max(found[1], length)};
    }
  const double margin = wider * std::max(found[1] - found[0], 0.0);
  return {found[0] - margin, found[1] + margin};
}

/// From a point of one box to one of the other.
LengthRange distances_between(const Box& a, const Box& b) {
  const auto nearest = [](double low, double high, double other_low, double other_high) {
    return std::max({other_low - high, low - other_high, 0.0});
  };
  const auto farthest = [](double low, double high, double other_low, double other_high) {
    return std::max(other_high - low, high - other_low);
  };
  return {std::hypot(nearest(a.x_low, a.x_high, b.x_low, b.x_high), nearest(a.y_low, a.y_high, b.y_low, b.y_high)),
          std::hypot(farthest(a.x_low, a.x_high, b.x_low, b.x_high), farthest(a.y_low, a.y_high, b.y_low, b.y_high))};
}

// What the requirements leave of a length.
LengthRange allowed_lengths(const WorkingFrame& frame, const Requirements& requirements,
                            const std::optional<LengthRange>& within, double partner) {
  // A grounded link longer than the longest link allowed is of no use: with small turns L is far larger than the
  // machine.
  double longest = std::min(ChosenLength::longest * frame.scale, *requirements.max_length);
  double shortest = longest / ChosenLength::range;
  const auto narrow = [&](double least, double most) {
    if (!(std::max(least, shortest) < std::min(most, longest))) return;
    shortest = std::max(least, shortest);
    longest = std::min(most, longest);
  };
  if (partner > 0 && std::isfinite(requirements.max_link_ratio)) {
    const double least = std::max(partner / requirements.max_link_ratio, requirements.min_length.value_or(0)),
                 most = std::min(partner * requirements.max_link_ratio, *requirements.max_length);
    narrow(least, most);
  } else {
    narrow(requirements.min_length.value_or(0), longest);
  }
  if (within) narrow((*within)[0], (*within)[1]);
  return {shortest, longest};
}

}  // namespace

std::optional<LengthRange> lengths_in_windows(const ThreePoseDyads& dyads, const WorkingFrame& frame,
                                              const Requirements& requirements) {
  const auto &ground = requirements.ground_pivots_within, &moving = requirements.moving_pivots_within;
  if (!ground && !moving) return std::nullopt;
  LengthRange left = {0, std::numeric_limits<double>::infinity()};
  if (ground) left = common(left, lengths_with_pivot_in(*ground, PivotKind::ground, dyads, frame));
  if (moving) left = common(left, lengths_with_pivot_in(*moving, PivotKind::moving, dyads, frame));
  if (ground && moving) left = common(left, distances_between(*ground, *moving));
  return left[0] < left[1] ? std::optional(left) : std::nullopt;
}

ChosenLength chosen_length(const FamilyOfLength& family_of, const WorkingFrame& frame, const Requirements& requirements,
                           Objective objective, const std::optional<LengthRange>& within, double partner,
                           const Progress& progress) {
  require(requirements.max_length.has_value(), "max_length is set");
  const LengthRange range = allowed_lengths(frame, requirements, within, partner);
  const LengthScale scale(range);
  LengthTrials trials(family_of, requirements, objective, progress);
  int count = ChosenLength::first_trials;
  for (int i = 0; i < count && trials.goes_on(); ++i)
    trials.try_length(scale.length(static_cast<double>(i) / (count - 1)));
  double step = 1.0 / (count - 1);
  for (int doubling = 0; doubling < ChosenLength::doublings && !trials.has_linkage(); ++doubling, step /= 2) {
    count = static_cast<int>(std::lround(1 / step));
    for (int i = 0; i < count && trials.goes_on(); ++i) trials.try_length(scale.length((i + 0.5) * step));
  }
  if (!scale.is_single() && !trials.has_linkage()) approach_windows(trials, scale, step);
  if (!scale.is_single() && trials.has_linkage()) climb(trials, scale, step);
  return {trials.length(), trials.meeting(), trials.tried(), range};
}

}  // namespace linkwright
