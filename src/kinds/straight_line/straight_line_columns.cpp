#include <fmt/format.h>

#include "straight_line_kind.hpp"

namespace linkwright {
namespace {

void add_stroke(LinkageColumns& list, const std::string& over, const std::string& words) {
  list.length(over + ".max_deviation", "Largest deviation from the line over " + words);
  list.length(over + ".best_line_deviation", "The same from the line that fits best");
  list.angle(over + ".min_transmission_angle_deg", "Minimum transmission angle over " + words);
  list.number(over + ".velocity_nonuniformity", "", "Nonuniformity of the point's velocity over " + words);
  list.angle(over + ".crank_range_deg", "How far the input turns over " + words);
}

}  // namespace

void list_columns(LinkageColumns& list, const StraightLineTask& /*task*/) {
  list.text("case", "Case of straight lines whose map it lies on", LinkageColumn::usual);
  list.number("layer", "", "Which of the linkages at its place of the map");
  list.coordinates("place", "", "Place on the map", false, 2);
  list.number("shape.turns", "", "Of a search of all cases: the sides of the line and the dyad, as bits");
  for (int k = 0; k < 4; ++k)
    list.number(fmt::format("shape.numbers[{}]", k), "", "Of a search of all cases: a number of the shape, 0 to 1");
  list.text("type", "Type of the linkage", LinkageColumn::usual);
  list.angle("min_transmission_angle_deg", "Minimum transmission angle over the usable length", LinkageColumn::usual);
  list.lengths({{"ground", "Length of the ground link"},
                {"input", "Length of the input link"},
                {"coupler", "Length of the coupler"},
                {"output", "Length of the output link"},
                {"point_to_input", "From the point to the moving pivot of the input"},
                {"point_to_output", "From the point to the moving pivot of the output"}});
  for (const std::string pivot : {"input_fixed", "input_moving", "output_moving", "output_fixed", "point"})
    list.point("pivots." + pivot, pivot == "point" ? "Guided point" : "Pivot", LinkageColumn::usual);
  list.number("contact_points", "", "Points of contact with the line", LinkageColumn::usual);
  list.length("deviation", "Deviation allowed", LinkageColumn::usual);
  list.length("usable.length", "Length within the deviation from the tangent", LinkageColumn::usual);
  list.length("usable_strip.length", "Length within the deviation from the best line", LinkageColumn::usual);
  list.number("stroke_over_longest", "", "Usable length over the longest link", LinkageColumn::usual);
  add_stroke(list, "over_usable", "the usable length");
  add_stroke(list, "stroke", "the stroke asked for");
  list_verdict(list);
}

}  // namespace linkwright
