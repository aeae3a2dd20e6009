#include "linkwright/synthesis/answer.hpp"

#include <array>

namespace linkwright {
namespace {

constexpr std::array<std::string_view, 3> status_names = {"solved", "no_solution", "degenerate"};

}  // namespace

std::string_view name(SolutionStatus status) { return status_names[static_cast<std::size_t>(status)]; }

const Findings& findings(const Answer& answer) {
  return std::visit([](const Findings& of_kind) -> const Findings& { return of_kind; }, answer);
}

Findings& findings(Answer& answer) {
  return std::visit([](Findings& of_kind) -> Findings& { return of_kind; }, answer);
}

std::size_t linkage_count(const Answer& answer) {
  return std::visit([](const auto& of_kind) { return of_kind.linkages.size(); }, answer);
}

std::optional<std::int64_t> looked_at_by_search(const Answer& answer) {
  return std::visit(
      [](const auto& of_kind) -> std::optional<std::int64_t> {
        if constexpr (requires { of_kind.search; })
          if (of_kind.search) return of_kind.search->looked_at();
        return std::nullopt;
      },
      answer);
}

}  // namespace linkwright
