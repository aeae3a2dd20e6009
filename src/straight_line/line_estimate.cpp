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

  // The longest over which e ranges over `width`: one end at a sample, then between the samples beside the best.
  [[nodiscard]] Stretch strip(double width) const {
    const Ranges from_middle = ranges();
    Stretch longest;
    for (const int sense : {-1, 1}) {
      double best = middle;
      Stretch found;
      const auto look = [&](double place) {
        const Stretch there = strip_from(place, sense, width, from_middle);
        if (there.length() <= found.length()) return there.length() > 0;
        found = there;
        best = place;
        return true;
      };
      for (int i = middle; look(i) && i != end(sense);) i += sense;
      constexpr int parts = 8;
      const double around = best;
      for (int k = 1 - parts; k < parts; ++k) {
        const double place = around + static_cast<double>(k) / parts;
        if (sense * (place - middle) >= 0 && sense * (end(sense) - place) >= 0) look(place);
      }
      if (found.length() > longest.length()) longest = found;
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
    double slowest = infinity, fastest = -infinity, sweep = 0;
    const auto look = [&](double sine_square, double velocity) {
      drive.least_sine_square = std::min(drive.least_sine_square, sine_square);
      slowest = std::min(slowest, velocity);
      fastest = std::max(fastest, velocity);
    };
    for (int i = before(over); i < last_ && s(i) < over.to; ++i) {
      const double from = std::max(s(i), over.from), to = std::min(s(i + 1), over.to);
      const double begin = at(block_.velocity, i, from), finish = at(block_.velocity, i, to);
      look(at(block_.sine_square, i, from), begin);
      look(at(block_.sine_square, i, to), finish);
      sweep += (to - from) * 0.5 * (1 / begin + 1 / finish);
    }
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

  // One end at a place between samples, the other as far as it goes; empty where e ranges wider before that.
  [[nodiscard]] Stretch strip_from(double place, int sense, double width, const Ranges& from_middle) const {
    const int inner = sense > 0 ? static_cast<int>(std::floor(place)) : static_cast<int>(std::ceil(place));
    const double share = std::abs(place - inner);
    Range here = from_middle[at_index(inner)];
    double at = s(inner);
    if (share > 0) {
      at += share * (s(inner + sense) - s(inner));
      here = here.with(e(inner) + share * (e(inner + sense) - e(inner)));
    }
    if (here.width() > width) return {};
    int low = middle, high = end(-sense);  // the last sample that the other end reaches lies between
    while (low != high) {
      const int next = high - (high - low) / 2;
      const int probe = next == low ? high : next;
      if (here.with(from_middle[at_index(probe)]).width() > width)
        high = probe - (-sense);
      else
        low = probe;
    }
    const double far = low == end(-sense) ? s(low) : leaves(here.with(from_middle[at_index(low)]), width, low, -sense);
    return sense < 0 ? Stretch{at, far} : Stretch{far, at};
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
