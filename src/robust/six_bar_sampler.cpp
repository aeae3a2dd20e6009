#include <algorithm>
#include <cmath>

#include "robust/block_sampler.hpp"
#include "robust/six_bar_solver.hpp"

namespace linkwright {
namespace {

double squared_turn(Point from, Point to) {
  const double turn = std::arg(to * std::conj(from));
  return turn * turn;
}

class SixBarSampler : public BlockSampler {
 public:
  SixBarSampler(const SixBarOutput& output, const Tolerances& tolerances)
      : distances_(output.six_bar), turning_length_(output.turning_length), limit_(tolerances.limit) {
    for (std::size_t j = 0; j < output.positions.size(); ++j) positions_.emplace_back(distances_, output, j);
    block_->positions = static_cast<int>(positions_.size());
  }

  [[nodiscard]] const SampledBlock& sampled(const double (*deviation)[DrawBlock::size], int samples) override {
    SampledBlock& block = *block_;
    std::fill_n(block.assembled, std::size(block.assembled), static_cast<unsigned char>(0));
    std::fill_n(block.square_sum, block.positions, 0.0);
    block.worst_sum = block.worst_square_sum = 0;
    block.assembled_count = block.good_count = 0;
    for (int at = 0; at < samples; ++at)
      if (sample(deviation, at)) add(at);
    return block;
  }

 private:
  // Whether it assembles in all positions.
  bool sample(const double (*deviation)[DrawBlock::size], int at) {
    SixBarDeviations off{};
    for (std::size_t i = 0; i < distances_.parameters(); ++i) off[i] = deviation[i][at];
    double worst = 0;
    limited_ = 0;
    for (std::size_t j = 0; j < positions_.size(); ++j) {
      const auto made = positions_[j].made(off);
      if (!made) return false;
      const double of_point = std::norm(made->origin - positions_[j].nominal().origin);
      const double of_angle = squared_turn(positions_[j].nominal().direction, made->direction);
      block_->error[j][at] = of_point + turning_length_ * turning_length_ * of_angle;
      worst = std::max(worst, block_->error[j][at]);
      limited_ = std::max(limited_, limit_ && limit_->kind == ToleranceLimit::Kind::angle ? of_angle : of_point);
    }
    block_->worst[at] = worst;
    return true;
  }

  void add(int at) {
    SampledBlock& block = *block_;
    block.assembled[at / 8] = static_cast<unsigned char>(block.assembled[at / 8] | 1 << at % 8);
    for (int j = 0; j < block.positions; ++j) block.square_sum[j] += block.error[j][at];
    block.worst_square_sum += block.worst[at];
    block.worst_sum += std::sqrt(block.worst[at]);
    ++block.assembled_count;
    if (limit_ && limited_ <= limit_->value * limit_->value) ++block.good_count;
  }

  SixBarDistances distances_;
  std::vector<SixBarSolver> positions_;
  double turning_length_;
  std::optional<ToleranceLimit> limit_;
  double limited_ = 0;  ///< largest error of the last sample that the limit is on, squared
  std::unique_ptr<SampledBlock> block_ = std::make_unique<SampledBlock>();
};

}  // namespace

std::unique_ptr<BlockSampler> block_sampler(const SixBarOutput& output, const Tolerances& tolerances, Simd /*simd*/) {
  return std::make_unique<SixBarSampler>(output, tolerances);
}

}  // namespace linkwright
