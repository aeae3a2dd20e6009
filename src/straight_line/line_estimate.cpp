#include "straight_line/line_estimate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <string_view>
#include <vector>

#include "linkwright/core/precondition.hpp"
#include "linkwright/straight_line/straight_path.hpp"
#include "straight_line/line_trace_kernel.hpp"
#include "straight_line/placed_shape.hpp"

namespace linkwright {
namespace {

constexpr int middle = LineTraceBlock::most_steps;
constexpr double infinity = std::numeric_limits<double>::infinity();

struct Stretch {
  double from = 0, to = 0;
  [[nodiscard]] double length() const { return to - from; }
};

struct Range {
  double low = 0, high = 0;
  [[nodiscard]] double width() const { return high - low; }
  [[nodiscard]] Range with(double value) const { return {std::min(low, value), std::max(high, value)}; }
  [[nodiscard]] Range with(Range other) const { return {std::min(low, other.low), std::max(high, other.high)}; }
};

constexpr std::size_t at_index(int sample) { return static_cast<std::size_t>(sample); }

// A way along the path by its samples, the cubic between two of them.
class Cubic {
 public:
  Cubic(double from, double to, double slope_from, double slope_to, double step)
      : from_(from), to_(to), slope_from_(step * slope_from), slope_to_(step * slope_to) {}

  [[nodiscard]] double operator()(double share) const {
    const double rest = 1 - share;
    return rest * rest * ((1 + 2 * share) * from_ + share * slope_from_) +
           share * share * ((1 + 2 * rest) * to_ - rest * slope_to_);
  }
  [[nodiscard]] double slope(double share) const {
    const double rest = 1 - share;
    return rest * (1 - 3 * share) * slope_from_ + share * (1 - 3 * rest) * slope_to_ + 6 * share * rest * (to_ - from_);
  }
  // Where it turns, if its slopes at both ends have different signs.
  [[nodiscard]] double turn() const {
    return root(0, 1, [&](double share) { return slope(share); });
  }
  // Where it crosses a level between two places, on different sides of it.
  [[nodiscard]] double crossing(double level, double low, double high) const {
    return root(low, high, [&](double share) { return (*this)(share)-level; });
  }

 private:
  // By the Illinois method.
  template <class Function>
  static double root(double low, double high, const Function& of) {
    constexpr double close = 1e-6;
    constexpr int turns = 20;
    double below = of(low), above = of(high);
    if (!(below * above < 0)) return std::abs(below) < std::abs(above) ? low : high;
    for (int turn = 0; turn < turns && std::abs(high - low) > close; ++turn) {
      const double next = high - above * (high - low) / (above - below), there = of(next);
      if (std::abs(next - high) < close) return next;
      if (there * above < 0) {
        low = high;
        below = above;
      } else {
        below /= 2;
      }
      high = next;
      above = there;
    }
    return high;
  }

  double from_, to_, slope_from_, slope_to_;
};

// One linkage's path: its samples, and the turns of e between them, so that e rises or falls between two knots.
class TracedPath {
 public:
  TracedPath(const LineTraceBlock& block, std::size_t lane)
      : block_(block), lane_(lane), first_(block.first[lane]), last_(block.last[lane]) {
    for (int i = first_;; ++i) {
      if (i == middle) middle_ = count_;
      add({s(i), e(i), i, 0});
      if (i == last_) break;
      if (!(de(i) * de(i + 1) < 0)) continue;
      const Cubic off = e_after(i);
      const double share = off.turn();
      if (share > 0 && share < 1) add({s_after(i)(share), off(share), i, share});
    }
  }

  [[nodiscard]] Stretch within(double low, double high) const {
    return {leaves(low, high, middle_, -1), leaves(low, high, middle_, 1)};
  }

  // The longest over which e ranges over `width`. Either one end is at a knot, or a turn of e inside holds the edge of
  // the strip: then an end at a knot is moved on to the other edge.
  [[nodiscard]] Stretch strip(double width) const {
    const Ranges from_middle = ranges();
    const auto s = [&](int k) { return knot(k).s; };
    Stretch longest;
    for (const int sense : {-1, 1}) {
      int i = middle_, far = middle_;
      while (i != end(sense) && from_middle[at_index(i + sense)].width() <= width) i += sense;
      for (;; i -= sense) {  // the farther in, the farther the other end goes
        const Range here = from_middle[at_index(i)];
        Range both = here.with(from_middle[at_index(far)]);
        while (far != end(-sense)) {
          const Range next = here.with(from_middle[at_index(far - sense)]);
          if (next.width() > width) break;
          both = next;
          far -= sense;
        }
        const int beyond = i == end(sense) ? i : i + sense, beyond_far = far == end(-sense) ? far : far - sense;
        if (sense * (s(beyond) - s(beyond_far)) > longest.length()) {
          const Stretch found = strip_between(i, far, sense, both, width);
          if (found.length() > longest.length()) longest = found;
        }
        if (i == middle_) break;
      }
    }
    return longest;
  }

  [[nodiscard]] double largest_deviation(Stretch over) const {
    double largest = 0;
    for (int k = 0; k < count_; ++k)
      if (knot(k).s >= over.from && knot(k).s <= over.to) largest = std::max(largest, std::abs(knot(k).e));
    for (const double end : {over.from, over.to}) {
      const int i = before(end);
      if (i < last_) largest = std::max(largest, std::abs(e_between(i, std::clamp(end, s(i), s(i + 1)))));
    }
    return largest;
  }
  [[nodiscard]] bool reaches(Stretch over) const { return s(first_) <= over.from && s(last_) >= over.to; }

  struct Drive {
    double least_sine = 1, nonuniformity = infinity;
  };
  [[nodiscard]] Drive drive(Stretch over) const {
    Drive drive;
    if (!(over.length() > 0)) return drive;
    double slowest = infinity, fastest = 0, low = infinity, high = -infinity, sine = 0, first_turn = 0, last_turn = 0;
    const auto look = [&](double sine_there, double ds, double dturn) {
      const bool passes_dead_point = sine * sine_there < 0;
      drive.least_sine = passes_dead_point ? 0 : std::min(drive.least_sine, std::abs(sine_there));  // and stays 0
      sine = sine_there;
      slowest = std::min(slowest, std::abs(ds / dturn));
      fastest = std::max(fastest, std::abs(ds / dturn));
      low = std::min(low, dturn);
      high = std::max(high, dturn);
    };
    const auto look_between = [&](int i, double s, double& turn) {
      const Cubic along = s_after(i);
      const double share = along.crossing(s, 0, 1);
      const Cubic turns(block_.turn[i][lane_], block_.turn[i + 1][lane_], block_.dturn[i][lane_],
                        block_.dturn[i + 1][lane_], step_after(i));
      turn = turns(share);
      const double before = block_.sine[i][lane_];
      look(before + share * (block_.sine[i + 1][lane_] - before), along.slope(share), turns.slope(share));
    };
    int i = std::min(before(over.from), last_ - 1);
    look_between(i, over.from, first_turn);
    for (++i; i < last_ && s(i) < over.to; ++i)
      look(block_.sine[i][lane_], block_.ds[i][lane_], block_.dturn[i][lane_]);
    look_between(i - 1, over.to, last_turn);
    if (low > 0 || high < 0)
      drive.nonuniformity = (fastest - slowest) * std::abs(last_turn - first_turn) / over.length();
    return drive;
  }

 private:
  static constexpr std::size_t most_knots = 2 * static_cast<std::size_t>(LineTraceBlock::samples);
  // A sample, or a place at a share of the way from one to the next.
  struct Knot {
    double s, e;
    int sample;
    double share;
  };
  using Ranges = std::array<Range, most_knots>;

  void add(const Knot& next) { knots_[at_index(count_++)] = next; }
  [[nodiscard]] const Knot& knot(int k) const { return knots_[at_index(k)]; }
  [[nodiscard]] int end(int sense) const { return sense > 0 ? count_ - 1 : 0; }
  [[nodiscard]] double s(int i) const { return block_.s[i][lane_]; }
  [[nodiscard]] double e(int i) const { return block_.e[i][lane_]; }
  [[nodiscard]] double de(int i) const { return block_.de[i][lane_]; }
  [[nodiscard]] double step_after(int i) const { return block_.step[i < middle ? i : i + 1][lane_]; }
  // Between samples i and i + 1.
  [[nodiscard]] Cubic s_after(int i) const {
    return {s(i), s(i + 1), block_.ds[i][lane_], block_.ds[i + 1][lane_], step_after(i)};
  }
  [[nodiscard]] Cubic e_after(int i) const { return {e(i), e(i + 1), de(i), de(i + 1), step_after(i)}; }

  // Of e from the middle to each knot.
  [[nodiscard]] Ranges ranges() const {
    Ranges from_middle;
    from_middle[at_index(middle_)] = {};
    for (const int sense : {-1, 1})
      for (int k = middle_; k != end(sense); k += sense)
        from_middle[at_index(k + sense)] = from_middle[at_index(k)].with(knot(k + sense).e);
    return from_middle;
  }

  // s between knot k and the next, where e crosses a level.
  [[nodiscard]] double crossing(int k, int sense, double level) const {
    const Knot &low = knot(sense > 0 ? k : k - 1), &high = knot(sense > 0 ? k + 1 : k);
    const double share = e_after(low.sample).crossing(level, low.share, high.sample == low.sample ? high.share : 1.0);
    return s_after(low.sample)(share);
  }
  // s where e first leaves [low, high] on the way from knot k.
  [[nodiscard]] double leaves(double low, double high, int k, int sense) const {
    for (const int end = this->end(sense); k != end; k += sense) {
      const double there = knot(k + sense).e;
      if (there < low || there > high) return crossing(k, sense, there > high ? high : low);
    }
    return knot(k).s;
  }

  // Both ends beyond knots between which e has a range, as far as the strip that the farther one leaves lets the other.
  [[nodiscard]] Stretch strip_between(int near, int far, int sense, Range both, double width) const {
    double to = knot(far).s, from = knot(near).s;
    if (far != end(-sense)) {
      const double low = knot(far - sense).e < both.low ? both.high - width : both.low;
      to = leaves_wide(both, width, far, -sense);
      from = leaves(low, low + width, near, sense);
    } else if (near != end(sense) && both.with(knot(near + sense).e).width() > width) {
      from = leaves_wide(both, width, near, sense);
    }
    return sense < 0 ? Stretch{from, to} : Stretch{to, from};
  }
  // s between knot k, up to which e has a range, and the next, where that grows wider than `width`.
  [[nodiscard]] double leaves_wide(Range range, double width, int k, int sense) const {
    return crossing(k, sense, knot(k + sense).e > range.high ? range.low + width : range.high - width);
  }
  // Next to the middle by e / s^contact, which is all but straight where e is not.
  [[nodiscard]] double e_between(int i, double s) const {
    if (i != middle && i + 1 != middle) return e_after(i)(s_after(i).crossing(s, 0, 1));
    const auto power = [&](double base) {
      double value = 1;
      for (int k = 0; k < block_.contact; ++k) value *= base;
      return value;
    };
    const auto share = [&](int k) { return k == middle ? block_.coefficient[lane_] : e(k) / power(this->s(k)); };
    const double way = (s - this->s(i)) / (this->s(i + 1) - this->s(i));
    return power(s) * (share(i) + way * (share(i + 1) - share(i)));
  }
  // The last sample before s, or the first.
  [[nodiscard]] int before(double s) const {
    int i = s > 0 ? last_ : middle;
    while (i > first_ && this->s(i) > s) --i;
    return i;
  }

  const LineTraceBlock& block_;
  std::size_t lane_;
  int first_, last_;
  std::array<Knot, most_knots> knots_;  // the first count_ of them
  int count_ = 0, middle_ = 0;
};

LineEstimate estimate_of(const LineTraceBlock& block, std::size_t lane, const LineEstimateTask& task) {
  const TracedPath path(block, lane);
  const double deviation = block.deviation[lane];
  const Stretch tangent = path.within(-deviation, deviation), strip = path.strip(2 * deviation);
  const bool by_strip = task.measuring.measure == LineMeasure::strip;
  const Stretch usable = by_strip ? strip : tangent;
  LineEstimate estimate{tangent.length(),
                        std::max(strip.length(), tangent.length()),
                        infinity,
                        0,
                        0,
                        std::abs(block.coefficient[lane]),
                        (strip.from + strip.to) / 2};
  Stretch judged = usable;
  if (!task.stroke) {
    estimate.deviation = std::min(by_strip ? 2 * deviation : deviation, path.largest_deviation(usable));
  } else if (const Stretch stroke{(*task.stroke)[0], (*task.stroke)[1]}; path.reaches(stroke)) {
    estimate.deviation = path.largest_deviation(stroke);
    judged = stroke;
  }
  const auto drive = path.drive(judged);
  estimate.min_transmission_sine = drive.least_sine;
  estimate.velocity_nonuniformity = drive.nonuniformity;
  return estimate;
}

// Linkages whose lines are estimated, and a δ for each.
struct Estimated {
  std::span<const TracingFourBar> linkages;
  std::vector<double> deviations;
  std::span<LineEstimate> estimates;
};

void fill(LineTraceBlock& block, std::size_t lane, const TracingFourBar& linkage, double deviation) {
  const auto put = [&](double(&numbers)[2][LineTraceBlock::size], Point p) {
    numbers[0][lane] = p.real();
    numbers[1][lane] = p.imag();
  };
  put(block.input_fixed, linkage.bars.input_fixed);
  put(block.input_moving, linkage.bars.input_moving);
  put(block.output_fixed, linkage.bars.output_fixed);
  put(block.output_moving, linkage.bars.output_moving);
  put(block.point, linkage.point);
  block.deviation[lane] = deviation;
}

// Of some of them by the block's steps; left are those that these do not tell.
std::vector<std::size_t> estimate_some(const Estimated& of, std::span<const std::size_t> some,
                                       const LineEstimateTask& task, LineTraceBlock& block) {
  const auto kernel = line_trace_kernel.for_simd(task.simd);
  std::vector<std::size_t> left;
  for (; !some.empty(); some = some.subspan(std::min(some.size(), LineTraceBlock::size))) {
    const auto lanes = some.first(std::min(some.size(), LineTraceBlock::size));
    for (std::size_t lane = 0; lane < LineTraceBlock::size; ++lane) {
      const std::size_t i = lanes[std::min(lane, lanes.size() - 1)];  // the last fills what is left
      fill(block, lane, of.linkages[i], of.deviations[i]);
    }
    kernel(block);
    for (std::size_t lane = 0; lane < lanes.size(); ++lane) {
      LineEstimate& estimate = of.estimates[lanes[lane]];
      if (block.doubtful[lane]) {
        estimate.contact_coefficient = std::abs(block.coefficient[lane]);
        left.push_back(lanes[lane]);
      } else {
        estimate = estimate_of(block, lane, task);
      }
    }
  }
  return left;
}

// Over the stroke that is asked for; nothing where the path does not reach so far. Traced no farther than that.
std::optional<StrokeFigures> figures_over(const TracingFourBar& linkage, const LineEstimateTask& task,
                                          const StraightPath& near) {
  const auto& [from, to] = *task.stroke;
  if (near.reaches(from, to)) return near.stroke_figures(from, to);
  constexpr double a_hair = 1e-6;
  const double beyond = a_hair * (to - from);
  const auto path = StraightPath::of(linkage, task.direction,
                                     {.from = std::min(from, 0.0) - beyond, .to = std::max(to, 0.0) + beyond});
  return path ? path->stroke_figures(from, to) : std::nullopt;
}

struct Row {
  std::string_view case_name;
  int layer = 0;
  unsigned turns = 0;
  std::array<float, 4> numbers{};
};

constexpr Row rows[] = {
#include "line_atlas.inc"  // by cmake/line_atlas.cmake
};

}  // namespace

void estimate_lines(std::span<const TracingFourBar> linkages, const LineEstimateTask& task,
                    std::span<LineEstimate> estimates, std::span<const double> deviations) {
  require(estimates.size() >= linkages.size(), "there is room for each estimate");
  Estimated of{linkages, {deviations.begin(), deviations.end()}, estimates};
  for (std::size_t i = deviations.size(); i < linkages.size(); ++i)
    of.deviations.push_back(task.measuring.deviation_of(linkages[i]));
  LineTraceBlock block;
  block.direction[0] = task.direction.real();
  block.direction[1] = task.direction.imag();
  block.contact = task.contact;
  if (task.stroke) block.half_stroke = std::max(-(*task.stroke)[0], (*task.stroke)[1]);
  std::vector<std::size_t> left(linkages.size());
  std::iota(left.begin(), left.end(), std::size_t{0});
  left = estimate_some(of, left, task, block);
  block.steps = LineTraceBlock::most_steps;
  block.growth = 1.15;
  block.tries = 8;
  left = estimate_some(of, left, task, block);
  for (const std::size_t i : left) {
    const double coefficient = estimates[i].contact_coefficient;
    estimates[i] = exact_line(linkages[i], task, of.deviations[i], true).value_or(LineEstimate{});
    estimates[i].contact_coefficient = coefficient;
  }
}

std::optional<LineEstimate> exact_line(const TracingFourBar& linkage, const LineEstimateTask& task, double deviation,
                                       bool by_both) {
  constexpr double a_hair = 1e-6;  // by which ends of deviation are told from those of the path
  const bool by_strip = task.measuring.measure == LineMeasure::strip;
  const double farthest = by_both || by_strip ? 2 * deviation : deviation;
  const auto path = StraightPath::of(linkage, task.direction, {.max_deviation = (1 + a_hair) * farthest});
  if (!path) return std::nullopt;
  const UsableLine strip = by_both || by_strip ? path->usable_strip(deviation) : UsableLine{},
                   tangent = by_both || !by_strip ? path->usable(deviation) : UsableLine{};
  const UsableLine& usable = by_strip ? strip : tangent;
  auto judged = path->stroke_figures(usable.from, usable.to);
  if (!judged) return std::nullopt;
  LineEstimate line{tangent.length(), strip.length(), infinity, 0, 0, 0, (strip.from + strip.to) / 2};
  if (!task.stroke) {
    line.deviation = judged->max_deviation;
  } else if (const auto over = figures_over(linkage, task, *path)) {
    line.deviation = over->max_deviation;
    judged = over;
  }
  line.min_transmission_sine = std::sin(judged->min_transmission_angle);
  line.velocity_nonuniformity = judged->drive ? judged->drive->nonuniformity(judged->to - judged->from) : infinity;
  return line;
}

LineEstimateTask estimate_task(const StraightLineFamily& family, Simd simd) {
  return {family.task().line.direction, family.contact(), family.measuring(), family.stroke(), simd};
}

std::vector<AtlasLinkage> line_atlas(ShapeKind kind) {
  const std::string_view case_name = name(placed(LineShape{kind, {}, 0}).task.given);
  std::vector<AtlasLinkage> linkages;
  for (const Row& row : rows) {
    if (row.case_name != case_name) continue;
    AtlasLinkage linkage{{kind, {}, row.turns}, row.layer};
    for (std::size_t k = 0; k < row.numbers.size(); ++k) linkage.shape.numbers[k] = static_cast<double>(row.numbers[k]);
    linkages.push_back(linkage);
  }
  return linkages;
}

}  // namespace linkwright
