#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "arm_layers.hpp"
#include "core/function_ref.hpp"
#include "further_dyads.hpp"
#include "linkwright/planar/four_bar_family.hpp"
#include "linkwright/planar/four_bar_map.hpp"
#include "linkwright/region/cell_judge.hpp"
#include "linkwright/region/objective.hpp"

namespace linkwright {

/// What maps hold whose places have several linkages: which one is shown, too.
inline constexpr auto arm_measures = [] {
  std::array<Measure, planar_measures.size() + 1> all{};
  std::copy(planar_measures.begin(), planar_measures.end(), all.begin());
  all.back() = measures::layer;
  return all;
}();

/// What decides which of several linkages at a place is shown: those that meet the requirements, then those without
/// defects, then the better score.
struct ArmRating {
  bool passes = false, is_clean = false;
  double score = 0;

  [[nodiscard]] bool is_better_than(const ArmRating& other) const {
    if (passes != other.passes) return passes;
    if (is_clean != other.is_clean) return is_clean;
    return score > other.score;
  }
};

/// A linkage of an arm, as a map holds it.
struct ArmLinkage {
  MapPoint place;  ///< in its layer
  FourBar bars;    ///< working frame
  PairJudgement judged;
  Point first_arm{}, last_arm{};  ///< of the driver, at the first and at the last point
  std::uint8_t senses = 0;        ///< of the driver, as DriverSequence has them
  ArmRating rating;

  [[nodiscard]] DriverTravel travel() const;
  /// `unit`: user's length of one unit of the working frame.
  [[nodiscard]] MapCell verdict(double unit) const;
  [[nodiscard]] Cell cell(const WorkingFrame& frame) const;
  /// Both links with the coordinates of the place.
  [[nodiscard]] DyadPair links() const;
};

/// What linkages are rated by.
struct ArmWishes {
  CellJudge judge;
  Rank rank;
  bool only_in_order = false;  ///< the arm drives, and its order is required
};

/// Arms are added, and their linkages come out some time later, in the order in which their arms came: each is put
/// where `Take` wants it that is told how it is rated. Keeps what it is made with.
class ArmSolver {
 public:
  /// Where a linkage that is rated so is to be put, `tag` being that of its arm; nothing where it is not wanted.
  using Take = FunctionRef<ArmLinkage*(std::size_t tag, const ArmRating& rating)>;

  ArmSolver(const ArmTask& task, const ArmLayers& layers, const ArmWishes& wishes, bool respect_direction, Simd simd);

  /// All linkages of an arm, or that which the coordinates of its place name. Where the arm drives and has to come in
  /// order, what does not is not solved, unless it is named.
  void add_all(std::size_t tag, MapPoint place, const ArmAtPlace& here, const Take& take);
  /// Those of one pattern, in order or not: to see what is wrong with all.
  void add_any(std::size_t tag, MapPoint place, const ArmAtPlace& here, const Take& take);
  /// Solves what has been added.
  void finish(const Take& take);

 private:
  struct Senses {
    std::uint8_t all = 0, half_turn = 0;
  };
  struct Arms {
    std::size_t tag;
    MapPoint place;
    ElbowPattern pattern;
    std::optional<std::size_t> dyad;  ///< only that
    Point pivot;
    ArmMotion motion;
    Senses senses;  ///< of an arm that drives
  };

  [[nodiscard]] std::size_t count() const { return task_.path.size(); }
  [[nodiscard]] bool arm_drives() const { return task_.side == Side::input; }
  [[nodiscard]] bool has_twice(const ArmMotion& motion) const;

  bool add(Arms arms, const ArmAtPlace& here, bool out_of_order_too, const Take& take);
  void take_dyad(std::size_t i, std::size_t number, std::size_t at, const Take& take);
  void take_pair(const Arms& arms, std::size_t number, const Dyad& other, const Take& take);

  [[nodiscard]] Arms arms_of(std::size_t tag, MapPoint place, const ArmAtPlace& here, const ElbowPattern& pattern,
                             std::optional<std::size_t> dyad) const;
  [[nodiscard]] std::optional<FourBar> bars_of(const Arms& arms, const Dyad& other) const;
  [[nodiscard]] LinkInPositions other_in_positions(const Arms& arms, const FourBar& bars) const;
  [[nodiscard]] ArmRating rated(const PairJudgement& judged, MapPoint place, const std::optional<FourBar>& bars);

  [[nodiscard]] Senses of_arm(const Arms& arms) const;
  [[nodiscard]] Senses of_turns(const std::array<Point, ArmElbows::most_points>& link) const;
  [[nodiscard]] Senses of_other(const ArmMotion& motion, const LinkInPositions& link) const;

  const ArmTask& task_;
  const ArmLayers& layers_;
  const ArmWishes& wishes_;
  bool respect_direction_, judges_pivots_, all_are_plain_;
  FurtherDyadSolver dyads_;
  std::vector<Arms> waiting_;
  Cell scratch_;
};

}  // namespace linkwright
