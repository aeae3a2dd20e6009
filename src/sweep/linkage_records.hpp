#pragma once

#include <string_view>

#include "files/json/json.hpp"
#include "linkwright/synthesis/answer.hpp"

namespace linkwright {

/// The member `linkages` that a result file of the answer has, without curves for plots. Takes the answer apart.
[[nodiscard]] Json linkage_records(Answer answer);

/// A member of a member …: "lengths.ground", "input.center_point[0]"; null where there is none.
[[nodiscard]] const Json* member_at(const Json& record, std::string_view name);

}  // namespace linkwright
