#include "kinds/kinds.hpp"
#include "linkwright/files/six_bar_file.hpp"

namespace linkwright {

std::vector<AnyStoredLinkage> stored_linkages(const Problem& problem, const Answer& answer) {
  std::vector<AnyStoredLinkage> linkages;
  std::visit(
      [&](const auto& of_kind) {
        for (const auto& found : of_kind.linkages) {
          auto linkage = stored(found, of_kind);
          linkage.title = problem.title;
          linkage.length_unit = problem.length_unit;
          linkages.push_back(std::move(linkage));
        }
      },
      answer);
  return linkages;
}

}  // namespace linkwright
