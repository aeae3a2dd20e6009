#pragma once

#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "files/axis_label.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/synthesis/answer.hpp"
#include "plane_window.hpp"
#include "svg_canvas.hpp"

namespace linkwright {

/// A map as it is drawn, whatever the kind of linkage.
struct DrawnRegion {
  struct Axis {
    AxisLabel label;
    std::string_view color;
    std::vector<Dyad> dyads;  ///< of the samples, where each has one of its own
  };

  const Findings& found;
  const LinkageFamily& family;
  Axis input, output;
  std::vector<MapPoint> best;  ///< where the linkages listed lie
};

/// The map of an answer between two axes. The answer must outlive it, and have a map.
template <class KindAnswer>
[[nodiscard]] DrawnRegion drawn_region(const KindAnswer& answer, DrawnRegion::Axis input, DrawnRegion::Axis output) {
  DrawnRegion drawn{answer, *answer.family(), std::move(input), std::move(output), {}};
  for (const auto& found : answer.linkages) drawn.best.push_back(answer.point_of(found));
  return drawn;
}

/// The solution region by type: full colour where all requirements are met, washed where only a requirement fails,
/// grey with hatching where the linkage has a defect. Up: the driving link; right: the other, or a function's free
/// number; a map of one column lies on its side as a ribbon. Where there are only a few cells each says what it is. The
/// best linkages carry rings with their numbers. `map`: the rectangle of the cells; axes stand left of and below it.
void draw_region(SvgCanvas& svg, const DrawnRegion& region, const PixelBox& map);

/// One column only: a function without a free parameter.
[[nodiscard]] bool is_ribbon(const LinkageFamily* family);

/// A few cells only: grounded links, or linkages, that can be counted.
[[nodiscard]] bool is_board(const LinkageFamily* family);

/// Cells that are linkages, with all their pivots.
[[nodiscard]] std::int64_t linkages_in(const RegionCounts& counts);

/// Names, colours and counts of the types of the class, in two columns, and what washed and hatched mean.
void draw_region_legend(SvgCanvas& svg, const Findings& found, const LinkageClass& of, Point corner, double width);

}  // namespace linkwright
