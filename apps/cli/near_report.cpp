#include <fmt/format.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/number_text.hpp"
#include "report.hpp"
#include "text_table.hpp"

namespace linkwright::cli {

std::string near_table(const Problem& problem, const MotionAnswer& answer) {
  if (answer.linkages.empty() || answer.task.near.empty()) return "";
  const auto length = [&](double value) {
    return fmt::format("{}{}{}", significant_text(value, 4), problem.length_unit.empty() ? "" : " ",
                       problem.length_unit);
  };
  const auto angle = [](double radians) { return significant_text(degrees(radians), 3) + "°"; };
  bool has_tolerance = false;
  for (const NearPose& near : answer.task.near) has_tolerance = has_tolerance || near.tolerance;
  std::vector<std::string> head = {"#", "rms", "distance", "largest", "turn", "largest", "<at pose", "exact to"};
  if (has_tolerance) head.emplace_back("within tolerance");
  TextTable table(head);
  for (std::size_t i = 0; i < answer.linkages.size(); ++i) {
    const auto& near = answer.linkages[i].near;
    if (!near) continue;
    const PoseFitError& error = near->error;
    std::vector<std::string> row = {fmt::format("{}", i + 1),
                                    length(error.rms),
                                    length(error.position_rms),
                                    length(error.position_max),
                                    angle(error.angle_rms),
                                    angle(error.angle_max),
                                    fmt::format("{}", error.max_at + 1),
                                    answer.task.poses.empty() ? "–" : significant_text(error.exact_residual, 2)};
    if (has_tolerance)
      row.push_back(near->outside.empty()
                        ? "yes"
                        : fmt::format("{} pose{} not", near->outside.size(), near->outside.size() == 1 ? "" : "s"));
    table.add_row(row);
  }
  return "\n" +
         wrapped(
             "How near the body comes to the near poses: root mean square error, turns counted by the turning length; "
             "then root mean square and largest distance and turn by themselves:") +
         table.text();
}

}  // namespace linkwright::cli
