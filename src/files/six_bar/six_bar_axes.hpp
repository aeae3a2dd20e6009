#pragma once

#include <optional>
#include <string>
#include <vector>

#include "linkwright/algebra/circular_cubic.hpp"
#include "linkwright/planar/four_bar_family.hpp"
#include "linkwright/planar/six_bar_family.hpp"
#include "linkwright/planar/six_bar_task.hpp"

namespace linkwright {

/// The family of a task's chain; nothing without a chain, or with one that does not reach all poses.
[[nodiscard]] std::optional<SixBarFamily> six_bar_family(const SixBarTask& task);

/// How an axis of a chain's map is spoken of.
struct SixBarAxis {
  std::string name;                   ///< in files: "link 4 between 0 and 2, place on its curve"
  std::string title;                  ///< at the axis of a drawing
  bool is_share = false;              ///< a share of the curve, which is another for each link 4, instead of τ
  std::vector<CurveBranch> branches;  ///< of the curve; of shares one from 0 to 1
};
[[nodiscard]] SixBarAxis six_bar_axis(const SixBarTask& task, Side side);

}  // namespace linkwright
