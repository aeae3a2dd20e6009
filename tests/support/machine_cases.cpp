#include "support/machine_cases.hpp"

#include "linkwright/synthesis/solve.hpp"
#include "support/draws.hpp"
#include "support/file_support.hpp"

namespace linkwright::testing {

const std::vector<AnyStoredLinkage>& stored_linkages_of_examples() {
  static const std::vector<AnyStoredLinkage> all = [] {
    std::vector<AnyStoredLinkage> found;
    for (const char* name :
         {"tailgate", "latch", "folding_wing", "loader_bucket_chain", "straight_luffing_crane", "log_generator"}) {
      const Problem problem = example(std::string(name) + ".json", 60);
      const auto answer = solve(problem);
      auto linkages = stored_linkages(problem, answer.value());
      linkages.resize(std::min<std::size_t>(linkages.size(), 3));
      for (std::size_t k = 0; k < linkages.size(); ++k) {
        std::visit([&](auto& stored) { stored.title = std::string(name) + ' ' + std::to_string(k + 1); }, linkages[k]);
        found.push_back(std::move(linkages[k]));
      }
    }
    return found;
  }();
  return all;
}

const std::vector<Machine>& machines() {
  static const std::vector<Machine> all = [] {
    std::vector<Machine> made;
    const auto& linkages = stored_linkages_of_examples();
    const auto every = static_cast<std::size_t>(3 / draws(3));  // three of each example, one under sanitizers
    for (std::size_t k = 0; k < linkages.size(); k += every)
      made.push_back(machine(moving_linkage(linkages[k])).value());
    return made;
  }();
  return all;
}

}  // namespace linkwright::testing
