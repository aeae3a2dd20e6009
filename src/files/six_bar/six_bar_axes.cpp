#include "six_bar_axes.hpp"

#include <fmt/format.h>

namespace linkwright {

SixBarAxis six_bar_axis(const SixBarTask& task, const ChainFamily* family, Side side) {
  const bool is_first = side == Side::input;
  const BodyPair between = task.added[is_first ? 0 : 1];
  const std::string link = fmt::format("link {}", is_first ? 4 : 5);
  SixBarAxis axis{fmt::format("{} between {} and {}, place on its curve", link, between.a, between.b),
                  fmt::format("L{}: place τ{} on its curve", link.substr(1), is_first ? "₄" : "₅"),
                  false,
                  {}};
  if (!family) return axis;
  if (is_first || !family->second_is_share()) {
    axis.branches = family->axis(side).branches;
  } else {
    axis = {fmt::format("{} between {} and {}, share of its curve, which link 4 decides", link, between.a, between.b),
            fmt::format("L{}: share of its curve", link.substr(1)),
            true,
            {{"", 0, 1}}};
  }
  return axis;
}

}  // namespace linkwright
