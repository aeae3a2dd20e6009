#pragma once

#include <string>
#include <vector>

#include "linkwright/algebra/circular_cubic.hpp"
#include "linkwright/planar/chain_family.hpp"
#include "linkwright/planar/six_bar_task.hpp"

namespace linkwright {

/// How an axis of a chain's map is spoken of.
struct SixBarAxis {
  std::string name;                   ///< in files: "link 4 between 0 and 2, place on its curve"
  std::string title;                  ///< at the axis of a drawing
  bool is_share = false;              ///< a share of the curve, which is another for each link 4, instead of τ
  std::vector<CurveBranch> branches;  ///< of the curve; of shares one from 0 to 1
};
/// `family` of the task's chain; null without one.
[[nodiscard]] SixBarAxis six_bar_axis(const SixBarTask& task, const ChainFamily* family, Side side);

}  // namespace linkwright
