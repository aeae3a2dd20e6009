#include "straight_line/line_estimate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "linkwright/core/precondition.hpp"
#include "straight_line/line_trace_kernel.hpp"

namespace linkwright {
namespace {

constexpr int middle = LineTraceBlock::steps;
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

// The samples of one linkage's path.
class TracedPath {
 public:
  TracedPath(const LineTraceBlock& block, std::size_t lane)
      : block_(block), lane_(lane), first_(block.first[lane]), last_(block.last[lane]) {}

  [[nodiscard]] double s(int i) const { return block_.s[i][lane_]; }
  [[nodiscard]] double e(int i) const { return block_.e[i][lane_]; }
  [[nodiscard]] int end(int sense) const { return sense > 0 ? last_ : first_; }

  // s where e first leaves [low, high] on the way from sample i.
  [[nodiscard]] double leaves(double low, double high, int i, int sense) const {
    for (const int end = this->end(sense); i != end; i += sense) {
      const double there = e(i + sense);
      if (there >= low && there <= high) continue;
      const double edge = there > high ? high : low;
      return s(i) + (s(i + sense) - s(i)) * (edge - e(i)) / (there - e(i));
    }
    return s(i);
  }
  [[nodiscard]] Stretch within(double low, double high) const {
    return {leaves(low, high, middle, -1), leaves(low, high, middle, 1)};
  }

  // The longest over which e, straight between samples, ranges over `width`. Either one end is at a sample, or a turn
  // of e inside holds the edge of the strip: then an end at a sample is moved on to the other edge.
  [[nodiscard]] Stretch strip(double width) const {
    const Ranges from_middle = ranges();
    Stretch longest;
    for (const int sense : {-1, 1}) {
      int i = middle, far = middle;
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
        if (i == middle) break;
      }
    }
    return longest;
  }

  [[nodiscard]] double largest_deviation(Stretch over) const {
    double largest = 0;
    for (int i = before(over); i < last_ && s(i) < over.to; ++i) {
      const double from = std::max(s(i), over.from), to = std::min(s(i + 1), over.to);
      largest = std::max({largest, std::abs(from == s(i) ? e(i) : e_between(i, from)),
                          std::abs(to == s(i + 1) ? e(i + 1) : e_between(i, to))});
    }
    return largest;
  }
  [[nodiscard]] bool reaches(Stretch over) const { return s(first_) <= over.from && s(last_) >= over.to; }

  struct Drive {
    double least_sine_square = 1, nonuniformity = 0;
  };
  [[nodiscard]] Drive drive(Stretch over) const {
    Drive drive;
    double slowest = infinity, fastest = -infinity, sweep = 0, way = 0, slowness = 0;
    const auto look = [&](double s, double sine_square, double velocity) {
      drive.least_sine_square = std::min(drive.least_sine_square, sine_square);
      slowest = std::min(slowest, velocity);
      fastest = std::max(fastest, velocity);
      const double here = 1 / velocity;
      if (s > over.from) sweep += (s - way) * 0.5 * (slowness + here);
      way = s;
      slowness = here;
    };
    const auto look_between = [&](int i, double s) {
      look(s, at(block_.sine_square, i, s), at(block_.velocity, i, s));
    };
    if (!(over.length() > 0)) return {1, infinity};
    int i = before(over);
    look_between(i, over.from);
    for (++i; i < last_ && s(i) < over.to; ++i) look(s(i), block_.sine_square[i][lane_], block_.velocity[i][lane_]);
    look_between(i - 1, over.to);
    const bool one_way = slowest > 0 || fastest < 0;
    drive.nonuniformity = one_way ? (fastest - slowest) * std::abs(sweep) / over.length() : infinity;
    return drive;
  }

 private:
  using Ranges = std::array<Range, LineTraceBlock::samples>;

  // Of e from the middle to each sample.
  [[nodiscard]] Ranges ranges() const {
    Ranges from_middle;
    from_middle[middle] = {};
    for (const int sense : {-1, 1})
      for (int i = middle; i != end(sense); i += sense)
        from_middle[at_index(i + sense)] = from_middle[at_index(i)].with(e(i + sense));
    return from_middle;
  }

  // Both ends beyond samples between which e has a range, as far as the strip that the farther one leaves lets the
  // other.
  [[nodiscard]] Stretch strip_between(int near, int far, int sense, Range both, double width) const {
    double to = s(far), from = s(near);
    if (far != end(-sense)) {
      const double low = e(far - sense) < both.low ? both.high - width : both.low;
      to = leaves(both, width, far, -sense);
      from = leaves(low, low + width, near, sense);
    } else if (near != end(sense) && both.with(e(near + sense)).width() > width) {
      from = leaves(both, width, near, sense);
    }
    return sense < 0 ? Stretch{from, to} : Stretch{to, from};
  }

  // s between sample i, up to which e has a range, and the next, where that grows wider than `width`.
  [[nodiscard]] double leaves(Range range, double width, int i, int sense) const {
    const double there = e(i + sense), edge = there > range.high ? range.low + width : range.high - width;
    return s(i) + (s(i + sense) - s(i)) * (edge - e(i)) / (there - e(i));
  }
  // By e / s^contact, which is all but straight where e is not.
  [[nodiscard]] double e_between(int i, double s) const {
    const auto power = [&](double base) {
      double value = 1;
      for (int k = 0; k < block_.contact; ++k) value *= base;
      return value;
    };
    const auto share = [&](int k) { return k == middle ? block_.coefficient[lane_] : e(k) / power(this->s(k)); };
    const double way = (s - this->s(i)) / (this->s(i + 1) - this->s(i));
    return power(s) * (share(i) + way * (share(i + 1) - share(i)));
  }
  // The last sample that does not lie in the stretch, or the first.
  [[nodiscard]] int before(Stretch over) const {
    int i = middle;
    while (i > first_ && s(i) > over.from) --i;
    return i;
  }
  [[nodiscard]] double at(const double (&values)[LineTraceBlock::samples][LineTraceBlock::size], int i,
                          double s) const {
    const double share = (s - this->s(i)) / (this->s(i + 1) - this->s(i));
    return values[i][lane_] + share * (values[i + 1][lane_] - values[i][lane_]);
  }

  const LineTraceBlock& block_;
  std::size_t lane_;
  int first_, last_;
};

LineEstimate estimate_of(const LineTraceBlock& block, std::size_t lane, const LineEstimateTask& task) {
  const LineMeasuring& measuring = task.measuring;
  const TracedPath path(block, lane);
  const double deviation = block.deviation[lane];
  const Stretch tangent = path.within(-deviation, deviation), strip = path.strip(2 * deviation);
  const bool by_strip = measuring.measure == LineMeasure::strip;
  const Stretch usable = by_strip ? strip : tangent;
  LineEstimate estimate{tangent.length(),
                        std::max(strip.length(), tangent.length()),
                        0,
                        0,
                        0,
                        std::abs(block.coefficient[lane]),
                        (strip.from + strip.to) / 2};
  if (task.stroke) {
    const Stretch stroke{(*task.stroke)[0], (*task.stroke)[1]};
    estimate.deviation = path.reaches(stroke) ? path.largest_deviation(stroke) : infinity;
  } else {
    estimate.deviation = std::min(deviation, path.largest_deviation(usable));
  }
  const auto drive = path.drive(usable);
  estimate.min_transmission_sine = std::sqrt(drive.least_sine_square);
  estimate.velocity_nonuniformity = drive.nonuniformity;
  return estimate;
}

void fill(LineTraceBlock& block, std::span<const TracingFourBar> linkages, const LineMeasuring& measuring) {
  for (std::size_t lane = 0; lane < LineTraceBlock::size; ++lane) {
    const TracingFourBar& linkage = linkages[std::min(lane, linkages.size() - 1)];  // the last fills what is left
    const auto put = [&](double(&numbers)[2][LineTraceBlock::size], Point p) {
      numbers[0][lane] = p.real();
      numbers[1][lane] = p.imag();
    };
    put(block.input_center, linkage.bars.input_center);
    put(block.input_circle, linkage.bars.input_circle);
    put(block.output_center, linkage.bars.output_center);
    put(block.output_circle, linkage.bars.output_circle);
    put(block.point, linkage.point);
    block.deviation[lane] = measuring.deviation_of(linkage);
  }
}

}  // namespace

void estimate_lines(std::span<const TracingFourBar> linkages, const LineEstimateTask& task,
                    std::span<LineEstimate> estimates, std::span<const double> deviations) {
  require(estimates.size() >= linkages.size(), "there is room for each estimate");
  const auto kernel = line_trace_kernel.for_simd(task.simd);
  LineTraceBlock block;
  block.direction[0] = task.direction.real();
  block.direction[1] = task.direction.imag();
  block.contact = task.contact;
  block.by_input = task.by_input;
  if (task.stroke) block.half_stroke = std::max(-(*task.stroke)[0], (*task.stroke)[1]);
  constexpr std::size_t size = LineTraceBlock::size;
  for (std::size_t begin = 0; begin < linkages.size(); begin += size) {
    const auto some = linkages.subspan(begin, std::min(size, linkages.size() - begin));
    fill(block, some, task.measuring);
    for (std::size_t lane = 0; lane < size && !deviations.empty(); ++lane)
      block.deviation[lane] = deviations[std::min(begin + lane, linkages.size() - 1)];
    kernel(block);
    for (std::size_t lane = 0; lane < some.size(); ++lane) estimates[begin + lane] = estimate_of(block, lane, task);
  }
}

LineEstimateTask estimate_task(const StraightLineFamily& family, Simd simd) {
  return {family.task().line.direction,
          family.contact(),
          std::holds_alternative<straight_cases::ParallelSideLinks>(family.task().given),
          family.measuring(),
          family.stroke(),
          simd};
}

LineEstimate estimate_of(const StraightLineFamily& family, const TracingFourBar& linkage) {
  LineEstimate estimate;
  estimate_lines({&linkage, 1}, estimate_task(family), {&estimate, 1});
  return estimate;
}

}  // namespace linkwright
