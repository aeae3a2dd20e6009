#pragma once

#include <memory>

#include "linkwright/core/simd.hpp"
#include "linkwright/robust/made_dimension.hpp"
#include "robust/sampling_kernel.hpp"

namespace linkwright {

/// Takes one linkage's errors, block by block.
class BlockSampler {
 public:
  virtual ~BlockSampler() = default;

  /// Of the first `samples` of those with these errors of the parameters.
  [[nodiscard]] virtual const SampledBlock& sampled(const double (*deviation)[DrawBlock::size], int samples) = 0;
};

/// Numbers to be drawn for the dimensions of a linkage.
[[nodiscard]] DrawBlock draw_block(const LinkageOutput& output, const Tolerances& tolerances);

[[nodiscard]] std::unique_ptr<BlockSampler> block_sampler(const PlanarOutput& output, const Tolerances& tolerances,
                                                          Simd simd);
[[nodiscard]] std::unique_ptr<BlockSampler> block_sampler(const SphericalOutput& output, const Tolerances& tolerances,
                                                          Simd simd);

[[nodiscard]] std::unique_ptr<BlockSampler> block_sampler(const SixBarOutput& output, const Tolerances& tolerances,
                                                          Simd simd);

/// What all samplers that hold a kernel's block do.
template <class Block>
class KernelSampler : public BlockSampler {
 public:
  KernelSampler(std::unique_ptr<Block> block, void (*kernel)(Block&)) : block_(std::move(block)), kernel_(kernel) {}

  [[nodiscard]] const SampledBlock& sampled(const double (*deviation)[DrawBlock::size], int samples) override {
    block_->deviation = deviation;
    block_->samples = samples;
    kernel_(*block_);
    return *block_;
  }

 private:
  std::unique_ptr<Block> block_;
  void (*kernel_)(Block&);
};

}  // namespace linkwright
