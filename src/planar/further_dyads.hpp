#pragma once

#include <array>
#include <cstddef>

#include "five_conditions.hpp"
#include "further_dyad_kernel.hpp"
#include "linkwright/algebra/point.hpp"
#include "linkwright/core/simd.hpp"
#include "linkwright/mechanism/four_bar.hpp"

namespace linkwright {

/// One to three dyads by rising direction from the known one's centre to theirs, modulo π; coordinates are 0.
struct FurtherDyads {
  std::array<Dyad, FurtherDyadBlock::most> dyads;
  std::size_t count = 0;
};

/// The dyads beside a known one that meet four conditions, for many tasks: as many at once as the machine's vectors
/// hold. Real roots of a cubic: of simple ones there are one or three (docs/theory/path.md). Bits do not depend on the
/// instruction set.
class FurtherDyadSolver {
 public:
  explicit FurtherDyadSolver(Simd simd = Simd::automatic) : kernel_(further_dyad_kernel.for_simd(simd)) {}

  [[nodiscard]] bool is_full() const { return block_.count == FurtherDyadBlock::size; }
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(block_.count); }
  /// Not where it is full. `center`, `circle`: of the known dyad.
  void add(const ConditionRows& rows, Point center, Point circle);
  /// Solves those that were added.
  void solve() { kernel_(block_); }
  /// By the order in which they were added.
  [[nodiscard]] FurtherDyads of(std::size_t task) const;
  void clear() { block_.count = 0; }

 private:
  void (*kernel_)(FurtherDyadBlock&);
  FurtherDyadBlock block_{};
};

/// The dyad with a given centre that meets the first two conditions: its circle point is the meet of two lines.
[[nodiscard]] Dyad partner_of(const ConditionRows& rows, Point center);

}  // namespace linkwright
