#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "linkwright/algebra/circular_cubic.hpp"
#include "linkwright/mechanism/four_bar.hpp"

namespace linkwright {

/// Where the samples of one axis of a region lie on a picture: a block for each branch of the curve, small gaps
/// between.
class RegionScale {
 public:
  struct Block {
    std::string branch;               ///< name of the branch
    std::size_t first = 0, last = 0;  ///< samples [first, last)
    double from_px = 0, to_px = 0;    ///< from the start of the axis
  };

  /// `coordinates` by rising τ, `length` px in all. `dyads`: the same samples' grounded links, or none.
  RegionScale(const std::vector<CurveBranch>& branches, std::span<const double> coordinates,
              std::span<const Dyad> dyads, double length);

  [[nodiscard]] double length() const { return length_; }
  [[nodiscard]] const std::vector<Block>& blocks() const { return blocks_; }
  [[nodiscard]] std::span<const double> coordinates() const { return coordinates_; }
  /// The sample whose cell is `px` from the start; −1 in a gap.
  [[nodiscard]] int sample_at(double px) const;
  /// px of τ, between samples in proportion; nothing where the samples do not reach.
  [[nodiscard]] std::optional<double> position(double tau) const;
  /// px where a pivot runs through infinity between two neighbouring samples.
  [[nodiscard]] std::vector<double> crossings_of_infinity() const;

 private:
  [[nodiscard]] double middle_of(const Block& block, double sample) const;

  double length_;
  std::vector<double> coordinates_;
  std::vector<Dyad> dyads_;
  std::vector<Block> blocks_;
};

}  // namespace linkwright
