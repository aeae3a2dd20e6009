#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "linkwright/region/linkage_family.hpp"
#include "linkwright/synthesis/answer.hpp"

// What is at a place of the map that the user picked (SynthesisOptions::at).
namespace linkwright {

/// The requirements that the linkage at a place fails, by the rules of the map's cells. Nothing where the place is off
/// an axis, or none is there.
[[nodiscard]] std::optional<std::vector<RequirementKind>> failures_at(const LinkageFamily& family,
                                                                      const Findings& found, MapPoint place);

/// Status and reason by what was listed: the linkages at the place, or nothing.
void state_what_is_there(Findings& found, const LinkageFamily& family, std::size_t listed);

/// Lists the linkage at `options.at` that `make(place, failed)` gives, whether it meets the requirements or not, and
/// nothing else. `make` may add to what it fails.
template <class KindAnswer, class Make>
void list_what_is_there(KindAnswer& answer, const LinkageFamily& family, const Make& make) {
  const MapPoint place = *answer.options.at;
  answer.linkages.clear();
  answer.fails.clear();
  if (auto failed = failures_at(family, answer, place))
    if (auto made = make(place, *failed)) {
      answer.linkages.push_back(*std::move(made));
      answer.fails.push_back(*std::move(failed));
    }
  state_what_is_there(answer, family, answer.linkages.size());
}

}  // namespace linkwright
