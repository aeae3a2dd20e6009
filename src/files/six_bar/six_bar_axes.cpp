#include "six_bar_axes.hpp"

#include <fmt/format.h>

namespace linkwright {

std::optional<SixBarFamily> six_bar_family(const SixBarTask& task) {
  const auto bodies = task.chain ? chain_positions(task.poses, *task.chain) : std::nullopt;
  if (!bodies) return std::nullopt;
  return SixBarFamily(*task.chain, task.added, *bodies);
}

SixBarAxis six_bar_axis(const SixBarTask& task, Side side) {
  const bool is_first = side == Side::input;
  const BodyPair between = task.added[is_first ? 0 : 1];
  const std::string link = fmt::format("link {}", is_first ? 4 : 5);
  const auto family = six_bar_family(task);
  SixBarAxis axis{fmt::format("{} between {} and {}, place on its curve", link, between.a, between.b),
                  fmt::format("L{}: place τ{} on its curve", link.substr(1), is_first ? "₄" : "₅"),
                  false,
                  {}};
  if (!family) return axis;
  if (is_first) {
    axis.branches = family->first().curve->branches();
  } else if (!family->second_depends_on_first()) {
    axis.branches = family->independent_second()->curve->branches();
  } else {
    axis = {fmt::format("{} between {} and {}, share of its curve, which link 4 decides", link, between.a, between.b),
            fmt::format("L{}: share of its curve", link.substr(1)),
            true,
            {{"", 0, 1}}};
  }
  return axis;
}

}  // namespace linkwright
