#include "six_bar_kind.hpp"

namespace linkwright {

void list_columns(LinkageColumns& list, const SixBarTask& /*task*/) {
  list.text("topology", "Watt and Stephenson kinds: watt_1, stephenson_2, …", LinkageColumn::usual);
  list_motion(list);
  list.angle("min_transmission_angles_of_dyads_deg[0]", "Minimum transmission angle of the first dyad");
  list.angle("min_transmission_angles_of_dyads_deg[1]", "Minimum transmission angle of the second dyad");
  list.number("link_ratio", "", "Longest over shortest link", LinkageColumn::usual);
  for (const std::string joint : {"a", "b", "d"})
    list.point("joints." + joint, "Hinge of the chain", LinkageColumn::usual);
  for (const std::string joint : {"c4", "z4", "c5", "z5"})
    list.point("joints." + joint, "End of an added link", LinkageColumn::usual);
  for (const std::string added : {"added[0]", "added[1]"}) {
    list.text(added + ".between", "Bodies that the added link joins", LinkageColumn::usual);
    list.number(added + ".coordinate", "", "Place of the added link on its curve");
  }
  list.number("pose_residual", "", "Error of the poses over their size");
  list_verdict(list);
}

}  // namespace linkwright
