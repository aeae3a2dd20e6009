#pragma once

#include <optional>
#include <string_view>

#include "linkwright/core/result.hpp"
#include "linkwright/files/six_bar_file.hpp"
#include "task_session.hpp"

namespace linkwright::wasm {

/// The linkage of a problem of the page whose task is one, `{"kind": "linkage", "mechanism", "file": what a linkage
/// file has}`, or its mistakes; nothing where the task is another.
[[nodiscard]] std::optional<Result<AnyStoredLinkage>> opened_linkage(std::string_view text);

/// The Linkage of the protocol that its kind has, with the drive over the whole travel, and `rates`: by state how its
/// bodies and the point move (OpenedRates there).
[[nodiscard]] LinkageReply opened_reply(const AnyStoredLinkage& linkage);

/// The path of a point of the body (as it lies in position 1) over these states, x and y by turns.
[[nodiscard]] std::vector<double> opened_trace(const AnyStoredLinkage& linkage, Point traced);

}  // namespace linkwright::wasm
