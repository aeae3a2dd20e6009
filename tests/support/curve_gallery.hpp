#pragma once

#include <string>
#include <vector>

#include "linkwright/approximate/curve_fit.hpp"

namespace linkwright::testing {

/// Points of the path of a four-bar whose dimensions are known: an exact answer exists.
struct GalleryCurve {
  std::string id;
  CurveTarget target;
  bool is_copy = false;  ///< similar to the first
};

/// The four-bars of data/approximate/gallery.json, 64 points of each path at equal steps of its length; of the ends of
/// an open one both.
[[nodiscard]] std::vector<GalleryCurve> curve_gallery();

}  // namespace linkwright::testing
