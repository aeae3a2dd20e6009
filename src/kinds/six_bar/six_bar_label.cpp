#include <fmt/format.h>

#include "linkwright/files/label.hpp"
#include "linkwright/files/task_label.hpp"
#include "six_bar_kind.hpp"

// How tasks of six-bars, and the axes of their maps, are spoken of.
namespace linkwright {

std::string label_of(const SixBarTask& task) {
  std::string text =
      fmt::format("six-bar for {} ({})", positions_text(position_count(task.poses)), pattern(task.poses));
  if (const auto row = six_bar_row(task.added)) text += ", " + row_label(*row);
  return text;
}

std::string short_label_of(const SixBarTask& task) {
  return "six-bar for " + positions_text(position_count(task.poses));
}

std::string row_label(const SixBarRow& row) {
  return fmt::format("{} by {} and {}", label(row.topology), text(row.added[0]), text(row.added[1]));
}

AxisLabel axis_label(const SixBarAnswer& answer, Side side, std::string_view /*length_unit*/) {
  const int link = side == Side::input ? 4 : 5;
  const BodyPair between = answer.task.added[side == Side::input ? 0 : 1];
  const std::string name = fmt::format("link {} between {} and {}", link, between.a, between.b);
  if (side == Side::output && answer.chain && answer.chain->second_is_share())
    return {name + ", share of its curve, which link 4 decides",
            fmt::format("Link {}: share of its curve", link),
            "1",
            "curve_share",
            {{"", 0, 1}}};
  return {name + ", coordinate on its curve",
          fmt::format("Link {}: place τ{} on its curve", link, link == 4 ? "₄" : "₅"), "tau",
          linkwright::name(AxisQuantity::curve_coordinate),
          answer.chain ? answer.chain->axis(side).branches : std::vector<CurveBranch>{}};
}

}  // namespace linkwright
