#include "linkwright/robust/tolerance_sampling.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "linkwright/analysis/position.hpp"
#include "linkwright/core/parallel.hpp"
#include "linkwright/core/precondition.hpp"
#include "robust/sampling_kernel.hpp"

namespace linkwright {
namespace {

static_assert(DrawBlock::parameters == planar_parameters);
static_assert(SamplingBlock::most_positions == most_sampled_positions);

void put(Point from, double to[2]) {
  to[0] = from.real();
  to[1] = from.imag();
}

Point unit_vector(Point from, Point to) { return (to - from) / std::abs(to - from); }

DrawBlock draw_block(const Tolerances& tolerances) {
  DrawBlock block;
  block.seed = tolerances.seed;
  block.distribution = static_cast<DrawBlock::Distribution>(tolerances.distribution);
  const PlanarValues half = planar_half_tolerances(tolerances);
  std::copy(half.begin(), half.end(), block.half_tolerance);
  block.clearance = tolerances.clearance;
  return block;
}

void set_linkage(const TracingFourBar& linkage, SamplingBlock& block) {
  const FourBar& bars = linkage.bars;
  const LinkLengths lengths = bars.lengths();
  block.input = lengths.input;
  block.coupler = lengths.coupler;
  block.output = lengths.output;
  put(bars.input_center, block.input_center);
  put(bars.output_center, block.output_center);
  put(std::conj(unit_vector(bars.input_circle, bars.output_circle)) * (linkage.point - bars.input_circle), block.arm);
}

void set_position(const TracingFourBar& linkage, std::size_t j, SamplingBlock& block) {
  const FourBar& bars = linkage.bars;
  put(unit_vector(bars.input_center, bars.input_circle), block.input_direction[j]);
  block.assembly[j] = assembly_of(bars) == Assembly::positive ? 1 : -1;
  put(linkage.point, block.point[j]);
  put(unit_vector(block.kind == SamplingBlock::angle ? bars.output_center : bars.input_circle, bars.output_circle),
      block.direction[j]);
}

// Distances of the nominal linkage, and its places.
void set_line(const PlanarOutput& output, SamplingBlock& block) {
  put(output.line.point, block.line_point);
  put(output.line.left(), block.line_left);
  block.realigned = output.realigned;
  std::vector<double> places, distances;
  for (const TracingFourBar& linkage : output.positions) {
    const Point on_line = output.line.to_line(linkage.point);
    places.push_back(on_line.real());
    distances.push_back(on_line.imag());
  }
  if (output.realigned) take_away_best_line(places, distances);
  std::copy(distances.begin(), distances.end(), block.nominal);
  double mean = 0, square = 0;
  for (const double place : places) mean += place / static_cast<double>(places.size());
  for (const double place : places) square += (place - mean) * (place - mean);
  for (std::size_t j = 0; j < places.size(); ++j) block.place[j] = (places[j] - mean) / std::sqrt(square);
}

SamplingBlock sampling_block(const PlanarOutput& output, const Tolerances& tolerances) {
  SamplingBlock block;
  block.kind = static_cast<SamplingBlock::Kind>(output.kind);
  block.positions = static_cast<int>(output.positions.size());
  set_linkage(output.positions.front(), block);
  for (std::size_t j = 0; j < output.positions.size(); ++j) set_position(output.positions[j], j, block);
  block.driver_errs = tolerances.driver > 0;
  block.error_of_angle = output.turning_length * output.turning_length;
  if (tolerances.limit) block.limit_square = tolerances.limit->value * tolerances.limit->value;
  if (tolerances.limit && tolerances.limit->kind == ToleranceLimit::Kind::angle) {
    block.limit_of_point = 0;
    block.limit_of_angle = 1;
  }
  if (output.kind == PlanarOutput::Kind::line) set_line(output, block);
  return block;
}

// What a block of samples adds up to.
struct Totals {
  std::vector<double> square_sums;
  double worst = 0, worst_square = 0;
  std::int64_t assembled = 0, good = 0;

  void add(const Totals& other) {
    for (std::size_t j = 0; j < square_sums.size(); ++j) square_sums[j] += other.square_sums[j];
    worst += other.worst;
    worst_square += other.worst_square;
    assembled += other.assembled;
    good += other.good;
  }
};

Totals totals_of(const SamplingBlock& block) {
  return {{block.square_sum, block.square_sum + block.positions},
          block.worst_sum,
          block.worst_square_sum,
          block.assembled_count,
          block.good_count};
}

SampledErrors errors_of(const std::vector<Totals>& blocks, const PlanarOutput& output, const Tolerances& tolerances) {
  Totals totals{std::vector<double>(output.positions.size())};
  for (const Totals& block : blocks) totals.add(block);
  SampledErrors errors{.samples = tolerances.samples, .not_assembled = tolerances.samples - totals.assembled};
  if (tolerances.limit) errors.yield = counted_share(totals.good, errors.samples);
  const auto count = static_cast<double>(totals.assembled);
  double squares = 0, largest = 0;
  for (const double sum : totals.square_sums) {
    const double square = count > 0 ? sum / count : 0;
    errors.deviations.push_back(std::sqrt(square));
    squares += square;
    largest = std::max(largest, errors.deviations.back());
  }
  errors.error = output.kind == PlanarOutput::Kind::line
                     ? 3 * largest
                     : std::sqrt(squares / static_cast<double>(totals.square_sums.size()));
  if (count > 0) {
    errors.mean = totals.worst / count;
    errors.standard_deviation = std::sqrt(std::max(0.0, totals.worst_square / count - errors.mean * errors.mean));
  }
  return errors;
}

constexpr double normal_975 = 1.959963984540054;  // Φ of it is 0.975

constexpr std::size_t draws_a_block = DrawBlock::parameters * DrawBlock::size;

std::size_t blocks_of(const Tolerances& tolerances) {
  return (static_cast<std::size_t>(tolerances.samples) - 1) / DrawBlock::size + 1;
}

// Takes one linkage's errors, block by block.
class BlockSampler {
 public:
  BlockSampler(const PlanarOutput& output, const Tolerances& tolerances, Simd simd)
      : block_(std::make_unique<SamplingBlock>(sampling_block(output, tolerances))),
        kernel_(sampling_kernel.for_simd(simd)),
        samples_(tolerances.samples) {}

  [[nodiscard]] Totals totals(std::size_t number, const double (*deviation)[DrawBlock::size]) {
    block_->deviation = deviation;
    block_->samples = std::min(samples_ - static_cast<int>(number) * DrawBlock::size, DrawBlock::size);
    kernel_(*block_);
    return totals_of(*block_);
  }

 private:
  std::unique_ptr<SamplingBlock> block_;
  void (*kernel_)(SamplingBlock&);
  int samples_;
};

void require_samples(const PlanarOutput& output, const Tolerances& tolerances) {
  require(!output.positions.empty() && output.positions.size() <= most_sampled_positions,
          "positions: one at least, most_sampled_positions at most");
  require(tolerances.samples > 0, "samples: one at least");
}

}  // namespace

CountedShare counted_share(std::int64_t count, std::int64_t of) {
  constexpr double z = normal_975;
  const auto n = static_cast<double>(of);
  const double share = static_cast<double>(count) / n, spread = z * z / n;
  const double middle = (share + spread / 2) / (1 + spread);
  const double half = std::sqrt(share * (1 - share) * spread + spread * spread / 4) / (1 + spread);
  return {share, count == 0 ? 0 : middle - half, count == of ? 1 : middle + half};
}

double SampledErrors::error_interval() const {
  return error * normal_975 / std::sqrt(2 * static_cast<double>(std::max<std::int64_t>(1, assembled())));
}

bool SampledErrors::is_beyond_first_order(double first_order_error) const {
  return !(std::abs(first_order_error - error) <= error_interval());
}

double SampledErrors::signal_to_noise() const {
  return -10 * std::log10(mean * mean + standard_deviation * standard_deviation);
}

SampledErrors sample_errors(const PlanarOutput& output, const Tolerances& tolerances, int threads, Simd simd) {
  require_samples(output, tolerances);
  std::vector<Totals> totals(blocks_of(tolerances));
  parallel_for(totals.size(), threads, [&](std::size_t begin, std::size_t end) {
    DrawBlock draws = draw_block(tolerances);
    BlockSampler sampler(output, tolerances, simd);
    for (std::size_t k = begin; k < end; ++k) {
      draws.first = k * DrawBlock::size;
      draw_kernel.for_simd(simd)(draws);
      totals[k] = sampler.totals(k, draws.deviation);
    }
  });
  return errors_of(totals, output, tolerances);
}

ToleranceSampler::ToleranceSampler(const Tolerances& tolerances, Simd simd) : tolerances_(tolerances), simd_(simd) {
  DrawBlock block = draw_block(tolerances);
  for (std::size_t k = 0; k < blocks_of(tolerances); ++k) {
    block.first = k * DrawBlock::size;
    draw_kernel.for_simd(simd)(block);
    draws_.insert(draws_.end(), &block.deviation[0][0], &block.deviation[0][0] + draws_a_block);
  }
}

SampledErrors ToleranceSampler::errors_of(const PlanarOutput& output) const {
  require_samples(output, tolerances_);
  std::vector<Totals> totals(blocks_of(tolerances_));
  BlockSampler sampler(output, tolerances_, simd_);
  for (std::size_t k = 0; k < totals.size(); ++k)
    totals[k] = sampler.totals(k, reinterpret_cast<const double(*)[DrawBlock::size]>(&draws_[k * draws_a_block]));
  return linkwright::errors_of(totals, output, tolerances_);
}

std::vector<PlanarValues> sampled_deviations(const Tolerances& tolerances, std::size_t count) {
  std::vector<PlanarValues> samples(count);
  DrawBlock block = draw_block(tolerances);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t place = k % DrawBlock::size;
    if (place == 0) {
      block.first = k;
      draw_kernel.for_simd(Simd::automatic)(block);
    }
    for (std::size_t i = 0; i < planar_parameters; ++i) samples[k][i] = block.deviation[i][place];
  }
  return samples;
}

}  // namespace linkwright
