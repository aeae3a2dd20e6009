#include "spherical_kind.hpp"

namespace linkwright {
namespace {

void add_spherical(LinkageColumns& list) {
  list_motion(list);
  list.angle("min_transmission_angle_full_turn_deg", "Minimum transmission angle over a full turn of the input");
  list.text("triple_rocker", "Kind of triple rocker");
  for (const std::string link : {"ground", "input", "coupler", "output"})
    list.angle("angles_deg." + link, "Angle of the " + link, LinkageColumn::usual);
  for (const std::string link : {"input", "output"}) {
    list.axis(link + ".fixed_axis", "Fixed axis of the " + link + ", unit vector", LinkageColumn::usual);
    list.axis(link + ".moving_axis", "Moving axis of the " + link + " in position 1, unit vector",
              LinkageColumn::usual);
    list.number(link + ".coordinate", "", "Place of the " + link + " on the axis of the map");
  }
  list_verdict(list);
}

}  // namespace

void list_columns(LinkageColumns& list, const SphericalMotionTask& /*task*/) { add_spherical(list); }

void list_columns(LinkageColumns& list, const SphericalFunctionTask& /*task*/) {
  add_spherical(list);
  list_function(list);
}

}  // namespace linkwright
