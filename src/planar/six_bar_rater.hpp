#pragma once

#include <functional>
#include <vector>

#include "linkwright/planar/six_bar_solution.hpp"
#include "mechanism/six_bar_judge.hpp"

namespace linkwright {

/// Rates six-bars that come one after another, as ratings_of() does. Those that neither shape nor signs turn down wait
/// until a pack of them is driven, so that its lanes are full.
class SixBarRater {
 public:
  using Taker = std::function<void(std::size_t place, const SixBarRating& rating)>;

  /// `take` gets each rating, in some order.
  explicit SixBarRater(Taker take, Simd simd = Simd::automatic) : take_(std::move(take)), simd_(simd) {}

  void add(std::size_t place, const SixBarMember& member);
  /// Of those that still wait.
  void finish();

 private:
  struct Waiting {
    std::size_t place;
    SixBarShape shape;
    SixBarLoops loops;
    std::array<SixBarTurns, 4> turns;
  };
  static constexpr std::size_t pack = 256;  ///< few lanes are idle at its end, and it stays in the cache

  Taker take_;
  Simd simd_;
  std::vector<Waiting> waiting_;
};

}  // namespace linkwright
