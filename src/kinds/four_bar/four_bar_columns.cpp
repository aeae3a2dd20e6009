#include "four_bar_kind.hpp"

namespace linkwright {
namespace {

void add_four_bar(LinkageColumns& list) {
  list_motion(list);
  list.angle("min_transmission_angle_full_turn_deg", "Minimum transmission angle over a full turn of the input");
  list.number("link_ratio", "", "Longest over shortest link", LinkageColumn::usual);
  list.lengths({{"ground", "Length of the ground link"},
                {"input", "Length of the input link"},
                {"coupler", "Length of the coupler"},
                {"output", "Length of the output link"}});
  for (const std::string link : {"input", "output"}) {
    list.point(link + ".center_point", "Fixed pivot of the " + link, LinkageColumn::usual);
    list.point(link + ".circle_point", "Moving pivot of the " + link + " in position 1", LinkageColumn::usual);
    list.number(link + ".coordinate", "", "Place of the " + link + " on the axis of the map");
  }
  list_verdict(list);
}

}  // namespace

void list_columns(LinkageColumns& list, const MotionTask& task) {
  add_four_bar(list);
  if (task.near.empty()) return;
  list.length("near.error.rms", "Root mean square error at the near poses, turns counted by the turning length",
              LinkageColumn::usual);
  list.length("near.error.position_rms", "Root mean square distance from the near poses");
  list.length("near.error.position_max", "Largest distance from a near pose");
  list.angle("near.error.angle_rms_deg", "Root mean square turn from the near poses");
  list.angle("near.error.angle_max_deg", "Largest turn from a near pose");
  list.length("near.error.exact_residual", "Largest error at the exact poses");
}

void list_columns(LinkageColumns& list, const FunctionTask& /*task*/) {
  add_four_bar(list);
  list_function(list);
}

void list_columns(LinkageColumns& list, const PathTask& task) {
  add_four_bar(list);
  list.lengths({{"point_to_input", "From the point to the moving pivot of the input"},
                {"point_to_output", "From the point to the moving pivot of the output"}});
  list.point("point", "Point of the coupler in position 1", LinkageColumn::usual);
  list.flag("full_turn", "The crank turns fully", LinkageColumn::usual);
  list.flag("circuit_order", "Along its circuit the points come in their order");
  list.length("position_error", "By driving: largest distance of the point from where it is to be");
  list.angle("timing_error_deg", "By driving: largest turn of the crank to where the point is nearest");
  list.number("cognate.size_ratio", "", "Crank of the cognate over this one");
  if (!task.is_approximate()) return;
  list.length("fit.error.rms", "Root mean square distance of the points from the path", LinkageColumn::usual);
  list.length("fit.error.max", "Largest distance of a point from the path", LinkageColumn::usual);
  list.number("fit.error.rms_over_diagonal", "", "Root mean square distance over the diagonal of the points");
  list.length("fit.error.excursion", "Largest distance of the path between the points from the polygon through them");
}

}  // namespace linkwright
