#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "arm_kernel.hpp"
#include "arm_motion.hpp"
#include "linkwright/core/simd.hpp"
#include "linkwright/mechanism/four_bar.hpp"
#include "mechanism/pair_judge.hpp"

namespace linkwright {

/// One to three dyads by rising direction from the known one's centre to theirs, modulo π: the places of a block at
/// which they stand.
struct FurtherDyads {
  std::array<std::uint8_t, ArmBlock::most_dyads> at{};
  std::size_t count = 0;
};

/// The dyads beside a known one, the arm, that meet four conditions, and the verdict over both as a pair: for many
/// arms, as many at once as the machine's vectors hold. Real roots of a cubic: of simple ones there are one or three
/// (docs/theory/path.md). Bits do not depend on the instruction set.
class FurtherDyadSolver {
 public:
  /// Pairs are judged where the arm drives.
  FurtherDyadSolver(std::span<const PathPlace> path, bool arm_drives, Simd simd);

  [[nodiscard]] bool is_full() const { return block_.count == ArmBlock::size; }
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(block_.count); }
  /// Not where it is full. `senses`, `half_turn_senses`: of an arm that drives, as DriverSequence has them.
  void add(Point pivot, const ArmMotion& motion, std::uint8_t senses, std::uint8_t half_turn_senses);
  /// Solves those that were added.
  void solve() { kernel_(block_); }
  /// By the order in which arms were added.
  [[nodiscard]] FurtherDyads of(std::size_t arm) const;
  /// Its coordinate is 0.
  [[nodiscard]] Dyad dyad(std::size_t arm, std::size_t at) const;
  [[nodiscard]] PairJudgement judged(std::size_t arm, std::size_t at) const;
  void clear() { block_.count = 0; }

 private:
  std::span<const PathPlace> path_;
  void (*kernel_)(ArmBlock&);
  ArmBlock block_{};
};

/// The dyad with a given centre that meets the first two conditions: its circle point is the meet of two lines.
[[nodiscard]] Dyad partner_of(const ConditionRows& rows, Point center);

}  // namespace linkwright
