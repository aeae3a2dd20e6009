#include "linkwright/robust/tolerance_sampling.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "linkwright/core/parallel.hpp"
#include "linkwright/core/precondition.hpp"
#include "robust/block_sampler.hpp"

namespace linkwright {
namespace {

static_assert(DrawBlock::most_parameters >= planar_parameters);
static_assert(SampledBlock::most_positions == most_sampled_positions);

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

Totals totals_of(const SampledBlock& block) {
  return {{block.square_sum, block.square_sum + block.positions},
          block.worst_sum,
          block.worst_square_sum,
          block.assembled_count,
          block.good_count};
}

SampledErrors errors_of(const std::vector<Totals>& blocks, const LinkageOutput& output, const Tolerances& tolerances) {
  Totals totals{std::vector<double>(positions_of(output))};
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
  errors.error = is_line(output) ? 3 * largest : std::sqrt(squares / static_cast<double>(totals.square_sums.size()));
  if (count > 0) {
    errors.mean = totals.worst / count;
    errors.standard_deviation = std::sqrt(std::max(0.0, totals.worst_square / count - errors.mean * errors.mean));
  }
  return errors;
}

constexpr double normal_975 = 1.959963984540054;  // Φ of it is 0.975

std::size_t blocks_of(const Tolerances& tolerances) {
  return (static_cast<std::size_t>(tolerances.samples) - 1) / DrawBlock::size + 1;
}

std::unique_ptr<BlockSampler> sampler_of(const LinkageOutput& output, const Tolerances& tolerances, Simd simd) {
  return std::visit([&](const auto& one) { return block_sampler(one, tolerances, simd); }, output);
}

Totals totals(BlockSampler& sampler, const Tolerances& tolerances, std::size_t block,
              const double (*deviation)[DrawBlock::size]) {
  const int left = tolerances.samples - static_cast<int>(block) * DrawBlock::size;
  return totals_of(sampler.sampled(deviation, std::min(left, DrawBlock::size)));
}

void require_samples(const LinkageOutput& output, const Tolerances& tolerances) {
  require(positions_of(output) > 0 && positions_of(output) <= most_sampled_positions,
          "positions: one at least, most_sampled_positions at most");
  require(tolerances.samples > 0, "samples: one at least");
}

}  // namespace

DrawBlock draw_block(const LinkageOutput& output, const Tolerances& tolerances) {
  DrawBlock block;
  block.seed = tolerances.seed;
  block.distribution = static_cast<DrawBlock::Distribution>(tolerances.distribution);
  block.clearance = tolerances.clearance;
  for (const MadeDimension& made : made_dimensions(output, tolerances)) {
    block.half_tolerance[block.parameters++] = made.tolerance;
    if (made.pins > 0) ++block.pinned;
  }
  return block;
}

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

SampledErrors sample_errors(const LinkageOutput& output, const Tolerances& tolerances, int threads, Simd simd) {
  require_samples(output, tolerances);
  std::vector<Totals> all(blocks_of(tolerances));
  parallel_for(all.size(), threads, [&](std::size_t begin, std::size_t end) {
    DrawBlock draws = draw_block(output, tolerances);
    const auto sampler = sampler_of(output, tolerances, simd);
    for (std::size_t k = begin; k < end; ++k) {
      draws.first = k * DrawBlock::size;
      draw_kernel.for_simd(simd)(draws);
      all[k] = totals(*sampler, tolerances, k, draws.deviation);
    }
  });
  return errors_of(all, output, tolerances);
}

ToleranceSampler::ToleranceSampler(const LinkageOutput& like, const Tolerances& tolerances, Simd simd)
    : tolerances_(tolerances), simd_(simd) {
  DrawBlock block = draw_block(like, tolerances);
  draws_a_block_ = static_cast<std::size_t>(block.parameters) * DrawBlock::size;
  for (std::size_t k = 0; k < blocks_of(tolerances); ++k) {
    block.first = k * DrawBlock::size;
    draw_kernel.for_simd(simd)(block);
    draws_.insert(draws_.end(), &block.deviation[0][0], &block.deviation[0][0] + draws_a_block_);
  }
}

SampledErrors ToleranceSampler::errors_of(const LinkageOutput& output) const {
  require_samples(output, tolerances_);
  std::vector<Totals> all(blocks_of(tolerances_));
  const auto sampler = sampler_of(output, tolerances_, simd_);
  for (std::size_t k = 0; k < all.size(); ++k)
    all[k] = totals(*sampler, tolerances_, k,
                    reinterpret_cast<const double(*)[DrawBlock::size]>(&draws_[k * draws_a_block_]));
  return linkwright::errors_of(all, output, tolerances_);
}

ErrorSamples error_samples(const LinkageOutput& output, const Tolerances& tolerances, std::size_t count, Simd simd) {
  require_samples(output, tolerances);
  ErrorSamples samples{std::vector<std::vector<double>>(positions_of(output))};
  DrawBlock draws = draw_block(output, tolerances);
  const auto sampler = sampler_of(output, tolerances, simd);
  for (std::size_t first = 0; first < count; first += DrawBlock::size) {
    draws.first = first;
    draw_kernel.for_simd(simd)(draws);
    const auto size = static_cast<int>(std::min<std::size_t>(count - first, DrawBlock::size));
    const SampledBlock& block = sampler->sampled(draws.deviation, size);
    samples.not_assembled += size - block.assembled_count;
    for (int at = 0; at < size; ++at)
      for (std::size_t j = 0; j < samples.errors.size() && (block.assembled[at / 8] >> at % 8 & 1); ++j)
        samples.errors[j].push_back(is_line(output) ? block.error[j][at] : std::sqrt(block.error[j][at]));
  }
  return samples;
}

std::vector<std::vector<double>> sampled_deviations(const LinkageOutput& output, const Tolerances& tolerances,
                                                    std::size_t count) {
  DrawBlock block = draw_block(output, tolerances);
  std::vector<std::vector<double>> samples(count, std::vector<double>(static_cast<std::size_t>(block.parameters)));
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t place = k % DrawBlock::size;
    if (place == 0) {
      block.first = k;
      draw_kernel.for_simd(Simd::automatic)(block);
    }
    for (std::size_t i = 0; i < samples[k].size(); ++i) samples[k][i] = block.deviation[i][place];
  }
  return samples;
}

}  // namespace linkwright
