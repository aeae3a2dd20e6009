#include <algorithm>
#include <cmath>

#include "linkwright/mechanism/position.hpp"
#include "robust/block_sampler.hpp"

namespace linkwright {
namespace {

void put(Point from, double to[2]) {
  to[0] = from.real();
  to[1] = from.imag();
}

Point unit_vector(Point from, Point to) { return (to - from) / std::abs(to - from); }

void set_linkage(const TracingFourBar& linkage, SamplingBlock& block) {
  const FourBar& bars = linkage.bars;
  const LinkLengths lengths = bars.lengths();
  block.input = lengths.input;
  block.coupler = lengths.coupler;
  block.output = lengths.output;
  put(bars.input_fixed, block.input_fixed);
  put(bars.output_fixed, block.output_fixed);
  put(std::conj(unit_vector(bars.input_moving, bars.output_moving)) * (linkage.point - bars.input_moving), block.arm);
}

void set_position(const TracingFourBar& linkage, std::size_t j, SamplingBlock& block) {
  const FourBar& bars = linkage.bars;
  put(unit_vector(bars.input_fixed, bars.input_moving), block.input_direction[j]);
  block.assembly[j] = assembly_of(bars) == Assembly::positive ? 1 : -1;
  put(linkage.point, block.point[j]);
  put(unit_vector(block.kind == SamplingBlock::angle ? bars.output_fixed : bars.input_moving, bars.output_moving),
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

}  // namespace

std::unique_ptr<BlockSampler> block_sampler(const PlanarOutput& output, const Tolerances& tolerances, Simd simd) {
  auto made = std::make_unique<SamplingBlock>();
  SamplingBlock& block = *made;
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
  return std::make_unique<KernelSampler<SamplingBlock>>(std::move(made), sampling_kernel.for_simd(simd));
}

}  // namespace linkwright
