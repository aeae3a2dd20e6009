#include "kinds/kinds.hpp"
#include "linkwright/drawing/svg_drawing.hpp"

namespace linkwright {

std::string draw_answer(const Problem& problem, const Answer& answer) {
  return std::visit([&](const auto& of_kind) { return draw_sheet(problem, of_kind); }, answer);
}

}  // namespace linkwright
