#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

#include "linkwright/synthesis/answer.hpp"

namespace linkwright {

/// The member `linkages` that a result file of the answer has, without curves for plots. Takes the answer apart.
[[nodiscard]] nlohmann::json linkage_records(Answer answer);

/// A member of a member …: "lengths.ground", "input.center_point[0]"; null where there is none.
[[nodiscard]] const nlohmann::json* member_at(const nlohmann::json& record, std::string_view name);

}  // namespace linkwright
