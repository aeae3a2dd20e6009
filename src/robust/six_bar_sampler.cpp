#include "linkwright/core/precondition.hpp"
#include "robust/block_sampler.hpp"

namespace linkwright {

std::unique_ptr<BlockSampler> block_sampler(const SixBarOutput& /*output*/, const Tolerances& /*tolerances*/,
                                            Simd /*simd*/) {
  require(false, "six-bars cannot be sampled yet");
  return nullptr;
}

}  // namespace linkwright
