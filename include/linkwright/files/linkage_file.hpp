#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "linkwright/core/result.hpp"
#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/pose.hpp"

namespace linkwright {

/// A linkage as files carry it: pivots, and what is needed to draw it in its positions.
struct StoredLinkage {
  FourBar four_bar;                   ///< as it lies in position 1
  std::string title, length_unit;     ///< empty when the file does not say
  std::vector<PrescribedPose> poses;  ///< empty when the file does not say
  std::string record;                 ///< the element of a result's `linkages` it came from, JSON text; or empty
  std::optional<Point> point{};       ///< of the coupler, whose path is looked at, as it lies
};

/// One linkage: an element of a result's `linkages`, or `{"lengths": {"ground": …, "input": …, "coupler": …, "output":
/// …}}`, or
/// `{"pivots": {"input_center": [x, y], "input_circle": …, "output_center": …, "output_circle": …}}`, or
/// `{"pivots": {"input_fixed": …, "input_moving": …, "output_moving": …, "output_fixed": …, "point": …}}` with a point
/// of the coupler (beside links given otherwise: `"point": [x, y]`), or what write_linkage() wrote. Links given by
/// their lengths are laid with the ground link from (0, 0) along x, the input in the middle of what it can reach (at
/// right angles to the ground link when it can reach all), the output's joint sign positive. A problem file is the
/// mistake `problem_without_linkage`.
[[nodiscard]] Result<StoredLinkage> read_linkage(std::string_view text);

/// One linkage as JSON text that read_linkage() reads back bit-identical.
[[nodiscard]] std::string write_linkage(const StoredLinkage& linkage);

}  // namespace linkwright
